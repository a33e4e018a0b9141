// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

namespace axiscomp::ui {

class ComparisonModel;

/// What is left of the error at the targets of the second measurement, a row each, and how well
/// that is known.
class ResidualModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Target, Left, StandardError, ColumnCount };

    /// comparison must outlive the model.
    explicit ResidualModel(const ComparisonModel& comparison, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

private:
    void follow();
    [[nodiscard]] QString text(int row, int column) const;
    [[nodiscard]] QString spoken(int row) const;

    const ComparisonModel& m_comparison;
    int m_rows = 0; ///< as announced
};

} // namespace axiscomp::ui
