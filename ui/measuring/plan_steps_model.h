// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_session.h"
#include "core/metrology/fine_quantity.h"

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace axiscomp::ui {

/// The steps of a plan, with the values that were taken and a mark at the one that is due.
class PlanStepsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Step, Run, Target, Deviation, Approach, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// plan: null: none; values: of its first steps.
    void show(
        const std::shared_ptr<const MeasuringPlan>& plan, const std::vector<CapturedValue>& values);
    /// Of the step that is due; -1: none is.
    [[nodiscard]] int dueRow() const;
    /// In which the deviations are shown.
    [[nodiscard]] const FineUnit& unit() const { return m_unit; }
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString text(const QModelIndex& cell) const;
    [[nodiscard]] QString spoken(const QModelIndex& cell) const;
    void announce(std::size_t first, std::size_t last);

    std::shared_ptr<const MeasuringPlan> m_plan;
    std::vector<CapturedValue> m_values;
    FineUnit m_unit;
};

} // namespace axiscomp::ui
