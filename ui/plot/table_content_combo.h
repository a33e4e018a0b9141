// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace axiscomp::ui {

class TableViewModel;

/// Chooses what is shown: the selected table, the drive's, or their difference. All boxes of one
/// TableViewModel show the same choice.
class TableContentCombo : public QComboBox {
    Q_OBJECT

public:
    /// shown must outlive the box.
    explicit TableContentCombo(TableViewModel& shown, QWidget* parent = nullptr);
    void retranslate();

private:
    void follow();

    TableViewModel& m_shown;
};

} // namespace axiscomp::ui
