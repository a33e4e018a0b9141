// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/table_selection.h"

#include "core/table/tam_table.h"
#include "ui/text/message_text.h"

#include <algorithm>
#include <utility>

namespace axiscomp::ui {

int sameTableIn(const CalibrationData& before, int index, const CalibrationData& now)
{
    const auto& name = before.tables[static_cast<std::size_t>(index)].name;
    const auto found = std::ranges::find(now.tables, name, &CompensationTable::name);
    if (found != now.tables.end())
        return static_cast<int>(found - now.tables.begin());
    return std::min(index, static_cast<int>(now.tables.size()) - 1);
}

TableSelection::TableSelection(const TableLayout& layout, SetupModel& setup, WizardLog& log)
    : m_layout(layout)
    , m_setup(setup)
    , m_log(log)
    , m_file(layout)
{
    connect(&m_file, &DataFileModel::dataReplaced, this, &TableSelection::followFile);
    connect(&m_file, &DataFileModel::failed, this, &TableSelection::noteFailure);
    connect(&m_driveTable, &DriveTable::changed, this, &TableSelection::noteSelected);
    connect(&m_setup, &SetupModel::fieldChanged, this, &TableSelection::followField);
}

void TableSelection::open(const QString& path, const ImportChoices& choices)
{
    m_isOpening = true;
    m_file.open(path, m_setup.edited().dimensionality, choices);
}

void TableSelection::show(const MadeTables& made)
{
    m_isOpening = false;
    m_file.show(made);
}

void TableSelection::openAs(const QString& path, int dimensions)
{
    m_setup.setDimensionality(dimensions);
    open(path, m_file.choicesFor(path));
}

void TableSelection::readAgain(const AxisPlace& place)
{
    if (m_file.file().isMade)
        return;
    const QString path = m_file.file().path;
    ImportChoices choices = m_file.readWith();
    choices.place = place;
    m_file.open(path, m_setup.edited().dimensionality, choices);
}

void TableSelection::followFile(
    const std::shared_ptr<const CalibrationData>& before, bool isSameFile)
{
    const auto& now = m_file.file().data;
    const std::optional<int> chosen = m_setup.edited().table.fileTable;
    const bool isOpened = std::exchange(m_isOpening, false);
    if (!now)
        m_setup.setTable({});
    else if (m_file.file().isMade)
        m_setup.setTable({0});
    else if (!isSameFile || !before || (!chosen && (isOpened || before->tables != now->tables)))
        m_setup.setTable({m_proposal ? static_cast<int>(m_proposal(*now)) : 0});
    else if (chosen && *chosen < static_cast<int>(before->tables.size()))
        takeSameTable(*before, *chosen, *now);
    if (now)
        m_log.add(LogLine::Kind::Information,
            [path = m_file.file().path, isMade = m_file.file().isMade,
                points = now->grid.pointCount(), tables = now->tables.size()] {
                return (isMade ? tr("%1 is used as the table: %2 points, tables: %3.")
                               : tr("%1 has been read: %2 points, tables: %3."))
                    .arg(path)
                    .arg(points)
                    .arg(tables);
            });
    for (const Text& remark : m_file.file().report)
        m_log.add(LogLine::Kind::Information, [remark] { return sentenceText(remark); });
    noteSelected();
    if (now && isSameFile && before)
        Q_EMIT fileReadAgain();
    else
        Q_EMIT fileOpened();
    followPlace(); // of now: it may have been another one when reading began
}

/// The user has not chosen another one.
void TableSelection::takeSameTable(
    const CalibrationData& before, int index, const CalibrationData& now)
{
    EditedSetup edited = m_setup.edited();
    edited.table = {sameTableIn(before, index, now)};
    m_setup.put(edited, std::array{Field::Table});
}

void TableSelection::putBack(const OpenedFile& opened)
{
    m_isOpening = opened.file.isReading;
    m_file.putBack(opened);
    noteSelected();
    followPlace();
}

/// Without an axis the fields are only being emptied: no reason to read the file in another way.
void TableSelection::followField(Field field)
{
    if (field == Field::Dimensionality && m_setup.hasBaseline())
        m_file.setDimensions(m_setup.edited().dimensionality);
    if (field == Field::Table)
        noteSelected();
}

void TableSelection::noteFailure(const LoadedFile& failed)
{
    m_isOpening = false;
    if (failed.refusal)
        m_log.add(LogLine::Kind::Error, [path = failed.path, refusal = *failed.refusal] {
            return tr("%1 cannot be used as it is. %2").arg(path, errorText(refusal));
        });
    else
        noteProblems(failed);
    followPlace();
}

void TableSelection::noteProblems(const LoadedFile& failed)
{
    const auto problems =
        std::ranges::count(failed.problems, Severity::Error, &Diagnostic::severity);
    m_log.add(LogLine::Kind::Error,
        [path = failed.path,
            count = static_cast<qulonglong>(problems) + failed.suppressedProblems] {
            return tr("%1 cannot be used: %2 problems.").arg(path).arg(count);
        });
}

LoadedTable TableSelection::selected() const
{
    const std::optional<int> chosen = m_setup.edited().table.fileTable;
    if (!chosen)
        return m_driveTable.table();
    const LoadedTable ofFile = m_file.table(*chosen);
    if (!ofFile.table || m_units.values.empty())
        return ofFile;
    if (ofFile.table != m_source) {
        m_source = ofFile.table;
        auto converted = inUnitsOfAxis(*ofFile.table, m_units, m_ownDimension);
        m_converted = ofFile;
        m_unitRefusal.reset();
        if (converted)
            m_converted.table =
                std::make_shared<const CompensationTable>(std::move(converted->table));
        else
            m_unitRefusal = std::move(converted).error();
    }
    return m_converted;
}

LoadedTable TableSelection::selectedOfFile() const
{
    const std::optional<int> chosen = m_setup.edited().table.fileTable;
    return chosen ? m_file.table(*chosen) : LoadedTable{};
}

bool TableSelection::isInDriveUnits() const
{
    return !unitRefusal();
}

std::optional<Error> TableSelection::unitRefusal() const
{
    const bool isOfFile = selected().table && m_setup.edited().table.fileTable;
    return isOfFile && !m_units.values.empty() ? m_unitRefusal : std::nullopt;
}

void TableSelection::setUnits(const TableUnits& units, std::optional<std::size_t> ownDimension)
{
    if (units == m_units && ownDimension == m_ownDimension)
        return;
    m_units = units;
    m_ownDimension = ownDimension;
    m_source.reset();
    noteSelected();
}

void TableSelection::setPlace(const std::optional<AxisPlace>& place)
{
    if (place == m_place)
        return;
    m_place = place;
    followPlace();
}

void TableSelection::followPlace()
{
    if (m_place)
        m_file.setPlace(*m_place);
}

std::size_t TableSelection::selectedBytes() const
{
    const auto table = selected().table;
    return table ? tamTableSize(table->grid, m_layout) : 0;
}

void TableSelection::setTableOnDrive(const std::optional<TableHeader>& table)
{
    m_onDrive = table;
    compareWithDrive();
}

void TableSelection::compareWithDrive()
{
    const std::optional<int> chosen = m_setup.edited().table.fileTable;
    const auto table = selected().table;
    m_setup.setTableOnDrive(chosen && isInDriveUnits() && isOnDrive(table) ? chosen : std::nullopt);
}

/// The same numbers in units that are not the drive's are another table. Only tables of the same
/// grid are counted: the CRC of a large one takes a while.
bool TableSelection::isOnDrive(const std::shared_ptr<const CompensationTable>& table)
{
    if (!table || !m_onDrive || !sameSpans(storedGrid(table->grid, m_layout), m_onDrive->grid))
        return false;
    if (table != m_counted) {
        m_counted = table;
        const auto crc = elementCrc(*table, m_layout);
        m_crc = crc ? std::optional(*crc) : std::nullopt;
    }
    return m_crc == m_onDrive->crc;
}

void TableSelection::noteSelected()
{
    compareWithDrive();
    auto now = selected().table;
    if (now == m_announced)
        return;
    m_announced = std::move(now);
    Q_EMIT changed();
}

} // namespace axiscomp::ui
