// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace axiscomp {
struct MeasuringPlan;
}

namespace axiscomp::ui {

/// The targets of a plan, ascending, each with its distance from the one before.
class PlanTargetsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Number, Target, Distance, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// null: none.
    void setPlan(const std::shared_ptr<const MeasuringPlan>& plan);
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString text(const QModelIndex& cell) const;

    std::vector<double> m_targets;
    bool m_isAngular = false;
};

} // namespace axiscomp::ui
