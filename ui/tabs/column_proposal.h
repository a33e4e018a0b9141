// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/formats/measurement_format.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;

namespace axiscomp::ui {

/// Says what columns of the same names were chosen to be before, with a button that takes it;
/// hidden while there is nothing to propose.
class ColumnProposal : public QWidget {
    Q_OBJECT

public:
    explicit ColumnProposal(QWidget* parent = nullptr);

    /// Empty: nothing.
    void propose(const std::vector<ColumnMapping>& columns);
    [[nodiscard]] const std::vector<ColumnMapping>& proposed() const { return m_columns; }
    void retranslate();

Q_SIGNALS:
    void taken(); ///< proposed()

private:
    std::vector<ColumnMapping> m_columns;
    QLabel* m_symbol;
    QLabel* m_text;
    QPushButton* m_take;
};

} // namespace axiscomp::ui
