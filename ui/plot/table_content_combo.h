// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace axiscomp::ui {

class ShownTable;

/// Chooses what is shown: the selected table, the drive's, or their difference. All boxes of one
/// ShownTable show the same choice.
class ContentBox : public QComboBox {
    Q_OBJECT

public:
    /// shown must outlive the box.
    explicit ContentBox(ShownTable& shown, QWidget* parent = nullptr);
    void retranslate();

private:
    void follow();

    ShownTable& m_shown;
};

} // namespace axiscomp::ui
