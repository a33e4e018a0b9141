// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/multi_axis_write.h"
#include "ui/controller/column_mapping.h"
#include "ui/controller/operation_runner.h"

#include <QObject>

#include <optional>
#include <stop_token>
#include <vector>

namespace axiscomp::ui {

/// Several axes of the current drive, each with a column of the open file: what a write of all of
/// them would change, and the write itself.
class MultiAxisController : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive this.
    MultiAxisController(const DriveList& drives, AxisState& axis, SetupModel& setup,
        const TableSelection& tables, OperationRunner& runner, LastOutcome& outcome);

    /// Those of the setup, as many as the file has dimensions; empty when one is not set.
    [[nodiscard]] std::vector<DimSource> sources() const;
    /// Asks the drive what all of these would change; planned() follows unless another question
    /// does. keepsSources: each axis keeps its own, otherwise it gets sources().
    void plan(const std::vector<ColumnForAxis>& columns, bool keepsSources);
    /// The last question is of no interest any more.
    void drop();
    /// One plan per column, in their order; none while the drive is being asked.
    [[nodiscard]] const std::optional<Result<std::vector<WritePlan>>>& plans() const
    {
        return m_plans;
    }
    /// Carries out plans(), axis by axis. acceptsLarge: as in WriteRequest.
    void write(bool acceptsLarge);

Q_SIGNALS:
    void planned();

private:
    void take(const Result<std::vector<WritePlan>>& plans);
    void take(const std::vector<AxisTable>& tables, const OperationEnd<MultiAxisReport>& end);
    [[nodiscard]] std::vector<AxisEntry> axesOfTables() const;

    const DriveList& m_drives;
    AxisState& m_axis;
    SetupModel& m_setup;
    const TableSelection& m_tables;
    OperationRunner& m_runner;
    LastOutcome& m_outcome;
    std::vector<AxisTable> m_asked; ///< what the drive was asked about
    std::optional<Result<std::vector<WritePlan>>> m_plans;
    int m_number = 0; ///< the newest question counts
    std::stop_source m_stop;
};

} // namespace axiscomp::ui
