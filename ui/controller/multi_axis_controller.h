// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/configuration_transfer.h"
#include "ui/controller/operation_runner.h"
#include "ui/data/column_mapping.h"

#include <QObject>

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace axiscomp::ui {

/// Several axes of the current drive: what writing all of them would change, and the writes
/// themselves. Each has a column of the open file, or its parameters of a TAM configuration.
class MultiAxisController : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive this.
    MultiAxisController(const DriveProfile& profile, const DriveList& drives, AxisState& axis,
        SetupModel& setup, const TableSelection& tables, OperationRunner& runner,
        LastOutcome& outcome);

    /// Those of the setup, as many as the file has dimensions; empty when one is not set.
    [[nodiscard]] std::vector<DimSource> sources() const;
    /// Asks the drive what all of these would change; planned() follows unless another question
    /// does.
    void plan(const std::vector<ColumnForAxis>& columns, SourcesForSeveral lookup);
    /// The register of the position of an axis; unset: none is known.
    [[nodiscard]] DimSource ownPosition(int axis) const;
    /// The same for the parameters of a station; axes that have them already are left out.
    /// acceptsOther: the station may have another serial number than the drive.
    void planImport(const std::shared_ptr<const TamConfiguration>& configuration,
        std::size_t station, bool acceptsOther);
    /// The same for a backup of a whole drive. acceptsOther: of one with another serial number.
    void planRestoreDrive(const std::shared_ptr<const DriveBackup>& backup, bool acceptsOther);
    /// The last question is of no interest any more.
    void drop();
    /// What write() will do: Task::WriteSeveral, Task::Import or Task::RestoreDrive.
    [[nodiscard]] Task task() const { return m_task; }
    /// One plan per write, in their order; none while the drive is being asked.
    [[nodiscard]] const std::optional<Result<std::vector<WritePlan>>>& plans() const
    {
        return m_plans;
    }
    /// Carries out plans(), axis by axis. acceptsLarge: as in WriteRequest.
    void write(bool acceptsLarge);

Q_SIGNALS:
    void planned();
    /// One of the axes has its new state. now: as read back.
    void tableWritten(const axiscomp::AxisStatus& now);
    /// The same, of a column of the open file. file: without folder.
    void columnWritten(const QString& endpoint, const axiscomp::AxisStatus& now,
        const QString& file, const QString& column);

private:
    void ask(Task task, DriveSession::Operation<PlannedTables> operation);
    void take(const Result<PlannedTables>& found);
    void take(const std::vector<AxisTable>& tables, const OperationEnd<MultiAxisReport>& end);
    [[nodiscard]] std::vector<AxisEntry> axesOfTables() const;

    const DriveProfile& m_profile;
    const DriveList& m_drives;
    AxisState& m_axis;
    SetupModel& m_setup;
    const TableSelection& m_tables;
    OperationRunner& m_runner;
    LastOutcome& m_outcome;
    Task m_task = Task::WriteSeveral;
    std::vector<AxisTable> m_asked; ///< what plans() are of
    QString m_fileName; ///< whose columns they write; empty: they are of no open file
    std::vector<AxisBackup::File> m_files; ///< that are written with them
    std::optional<Result<std::vector<WritePlan>>> m_plans;
    int m_number = 0; ///< the newest question counts
    std::stop_source m_stop;
};

} // namespace axiscomp::ui
