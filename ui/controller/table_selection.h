// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/table/table_units.h"
#include "ui/controller/setup_model.h"
#include "ui/data/data_file_model.h"
#include "ui/data/drive_table.h"
#include "ui/outcome/wizard_log.h"

#include <QObject>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace axiscomp::ui {

/// Where a table of a file is in the same file that was read again: by its name, else by its place.
/// index: one of before.
[[nodiscard]] int sameTableIn(const CalibrationData& before, int index, const CalibrationData& now);

/// The open file of compensation data, the table on the drive, and which of their tables is
/// selected: what the setup says about its table follows the file.
class TableSelection : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive the selection.
    TableSelection(const TableLayout& layout, SetupModel& setup, WizardLog& log);

    /// Which table of a file that is opened is selected; until then its first.
    using Proposal = std::function<std::size_t(const CalibrationData&)>;
    void proposeBy(Proposal proposal) { m_proposal = std::move(proposal); }
    /// The proposed table is selected, unless another one of the same file is.
    void open(const QString& path, const ImportChoices& choices);
    /// Tables that were made here, in place of the open file; the first of them is selected.
    void show(const MadeTables& made);
    /// The same for a file that is a grid of another dimensionality than the setup's, which gets
    /// it; with what the user has said about the file.
    void openAs(const QString& path, int dimensions);
    /// The open file, which may have changed; what was selected stays selected, but the table on
    /// the drive where the file has other values by now.
    void readAgain(const AxisPlace& place); ///< which may be another one by now
    [[nodiscard]] DataFileModel& file() { return m_file; }
    [[nodiscard]] const DataFileModel& file() const { return m_file; }
    /// As it was; the setup follows by itself.
    void putBack(const OpenedFile& opened);
    [[nodiscard]] DriveTable& driveTable() { return m_driveTable; }
    [[nodiscard]] const DriveTable& driveTable() const { return m_driveTable; }
    /// In the units of the drive as far as they can be converted. None: the one on the drive, which
    /// has not been downloaded yet.
    [[nodiscard]] LoadedTable selected() const;
    /// Whether selected() has the numbers that the drive takes: those of a file that cannot be
    /// converted mean something else there.
    [[nodiscard]] bool isInDriveUnits() const;
    /// Why they cannot be converted: the error of inUnitsOfAxis.
    [[nodiscard]] std::optional<Error> unitRefusal() const;
    /// As the file has it.
    [[nodiscard]] LoadedTable selectedOfFile() const;
    /// What the drive says about the table that the axis has; none: it has none.
    void setTableOnDrive(const std::optional<TableHeader>& table);
    /// Of the axis and its sources; the dimension whose source is its own position.
    void setUnits(const TableUnits& units, std::optional<std::size_t> ownDimension);
    /// Of the axis among its sources, which a file of another controller is converted for: for
    /// another place it is read again. Nothing: not all sources are chosen.
    void setPlace(const std::optional<AxisPlace>& place);
    [[nodiscard]] std::size_t selectedBytes() const; ///< as a file on the drive; 0 without a table

Q_SIGNALS:
    void changed(); ///< selected()
    void fileOpened(); ///< or closed
    void fileReadAgain();

private:
    void followFile(const std::shared_ptr<const CalibrationData>& before, bool isSameFile);
    void takeSameTable(const CalibrationData& before, int index, const CalibrationData& now);
    void followField(Field field);
    void noteFailure(const LoadedFile& failed);
    void noteProblems(const LoadedFile& failed);
    void noteSelected();
    void followPlace();
    void compareWithDrive();
    [[nodiscard]] bool isOnDrive(const std::shared_ptr<const CompensationTable>& table);

    const TableLayout& m_layout;
    SetupModel& m_setup;
    WizardLog& m_log;
    DataFileModel m_file;
    DriveTable m_driveTable;
    Proposal m_proposal;
    bool m_isOpening = false; ///< somebody wants a table of the file that is being read
    TableUnits m_units;
    std::optional<std::size_t> m_ownDimension;
    std::optional<AxisPlace> m_place;
    mutable LoadedTable m_converted; ///< selected(), of m_source
    mutable std::shared_ptr<const CompensationTable> m_source;
    mutable std::optional<Error> m_unitRefusal; ///< why m_source has other units than the drive's
    std::shared_ptr<const CompensationTable> m_announced;
    std::optional<TableHeader> m_onDrive;
    std::shared_ptr<const CompensationTable> m_counted; ///< m_crc is of
    std::optional<std::uint32_t> m_crc;
};

} // namespace axiscomp::ui
