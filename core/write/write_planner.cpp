// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/write_planner.h"

#include "core/axis/proposals.h"
#include "core/axis/shown_grid.h"
#include "core/drive/axis_target.h"
#include "core/drive/drive_units.h"
#include "core/neutral/drive_note.h"
#include "core/store/backup_json.h"
#include "core/table/large_correction.h"
#include "core/table/position_unit.h"
#include "core/table/tam_table.h"
#include "core/table/target_axis.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"
#include "core/write/lookup_side.h"

#include <algorithm>

namespace axiscomp {

namespace {

std::string numberText(double value)
{
    return toText(RegisterValue{value});
}

Verbatim quotedName(const std::string& name)
{
    return {'"' + name + '"'};
}

/// "mm at mm, deg": the values, and each of the positions; "-" is not known.
std::string unitsText(const TableUnits& units)
{
    const auto symbol = [](const std::string& unit) {
        return unit.empty() ? std::string("-") : symbolOrWord(unit);
    };
    std::string text = symbol(units.values);
    for (std::size_t n = 0; n < units.positions.size(); ++n)
        text += (n == 0 ? " at " : ", ") + symbol(units.positions[n]);
    return text;
}

/// "5 x 4 points, X 0 .. 40, Y 0 .. 30": enough to recognise a table.
std::string gridText(const Grid& grid)
{
    std::string sizes;
    std::string ranges;
    for (std::size_t n = 0; n < grid.axes.size(); ++n) {
        const GridAxis& axis = grid.axes[n];
        sizes += (n == 0 ? "" : " x ") + std::to_string(axis.size);
        ranges += ", " + (axis.name.empty() ? "dim " + std::to_string(n + 1) : axis.name) + " "
            + numberText(axis.start) + " .. " + numberText(axis.last());
    }
    return sizes + " points" + ranges;
}

std::string tableText(const std::string& slot, const Grid& grid, std::uint32_t crc)
{
    return slot + ": " + gridText(grid) + " (CRC " + crcText(crc) + ")";
}

const char* persistencyText(Persistency persistency)
{
    return persistency == Persistency::Persistent ? "persistent" : "volatile";
}

std::string sourceText(const std::string& drive, const DimSource& source)
{
    if (!source.isSet())
        return "none";
    return source.path.empty() ? sourceName(source) : sourceUri(drive, source.path);
}

} // namespace

std::uint32_t elementCrcOf(ByteView file, const CompensationTable& table)
{
    return crc32(file.last(table.values.size() * sizeof(float)));
}

Text setupText(const CompensationSetup& setup)
{
    std::vector<std::string> sources;
    for (const DimSource& source : setup.sources) {
        if (source.isSet())
            sources.push_back(sourceName(source));
    }
    TextPattern pattern = sources.empty()
        ? AXISCOMP_TEXT("Error", "{table} (CRC {crc}), volatile")
        : AXISCOMP_TEXT("Error", "{table} (CRC {crc}), {sources}, volatile");
    if (setup.persistency == Persistency::Persistent)
        pattern = sources.empty()
            ? AXISCOMP_TEXT("Error", "{table} (CRC {crc}), persistent")
            : AXISCOMP_TEXT("Error", "{table} (CRC {crc}), {sources}, persistent");
    return pattern
        .with("table",
            setup.slot.empty() ? AXISCOMP_TEXT("Error", "no table") : Text(Verbatim{setup.slot}))
        .with("crc", crcText(setup.tableCrc))
        .with("sources", sources);
}

PlannedState plannedState(const WritePlan& plan)
{
    return {plan.before, plan.gridBefore, plan.units, plan.axisName};
}

PlannedState plannedState(const AxisStatus& now)
{
    return {now.setup, now.table ? now.table->grid : Grid{},
        now.table ? unitsOfTable(now) : TableUnits{}, now.axis.name};
}

void expectAsPlanned(WriteRequest& request, const WritePlan& plan)
{
    request.expected = plannedState(plan);
    request.expectedDrive = plan.drive.serialNumber;
}

Result<void> checkAsPlanned(const PlannedState& planned, const AxisStatus& now)
{
    const Text axis = axisText(now.axis.index, now.axis.name);
    if (!(planned.setup == now.setup))
        return fail(ErrorCode::ChangedMeanwhile,
            {{"what", AXISCOMP_TEXT("Error", "the settings of {axis}").with("axis", axis)},
                {"before", setupText(planned.setup)}, {"now", setupText(now.setup)}});
    const Grid grid = now.table ? now.table->grid : Grid{};
    if (planned.grid && !sameSpans(*planned.grid, grid))
        return fail(ErrorCode::ChangedMeanwhile,
            {{"what", AXISCOMP_TEXT("Error", "the table in {slot}").with("slot", now.setup.slot)},
                {"before", Verbatim{gridText(*planned.grid)}}, {"now", Verbatim{gridText(grid)}}});
    if (planned.axisName && *planned.axisName != now.axis.name)
        return fail(ErrorCode::ChangedMeanwhile,
            {{"what",
                 AXISCOMP_TEXT("Error", "the name of axis {axis}").with("axis", now.axis.index)},
                {"before", quotedName(*planned.axisName)}, {"now", quotedName(now.axis.name)}});
    return {};
}

Result<void> checkUnitsAsPlanned(
    const PlannedState& planned, const TableUnits& now, const AxisStatus& of)
{
    if (!planned.units || *planned.units == now)
        return {};
    return fail(ErrorCode::ChangedMeanwhile,
        {{"what",
             AXISCOMP_TEXT("Error", "the units of the table of {axis}")
                 .with("axis", axisText(of.axis.index, of.axis.name))},
            {"before", Verbatim{unitsText(*planned.units)}}, {"now", Verbatim{unitsText(now)}}});
}

Text axisText(int index, const std::string& name)
{
    return (name.empty() ? AXISCOMP_TEXT("Error", "axis {axis}")
                         : AXISCOMP_TEXT("Error", "axis {axis} ({name})"))
        .with("axis", index)
        .with("name", name);
}

Result<PreparedWrite> WritePlanner::prepare(int axis, const WriteRequest& request)
{
    AXISCOMP_CHECK(readAxis(axis));
    if (m_status.isOn())
        return fail(compensationActive(m_status));
    m_writesAnyway = true;
    return decide(request);
}

Result<PreparedWrite> WritePlanner::prepareChanges(int axis, const WriteRequest& request)
{
    AXISCOMP_CHECK(readAxis(axis));
    auto prepared = decide(request);
    const bool hasAll = prepared && prepared->plan.changes.empty();
    if (m_status.isOn() && !hasAll)
        return fail(compensationActive(m_status));
    return prepared;
}

Result<WritePlan> WritePlanner::compare(int axis, const WriteRequest& request)
{
    AXISCOMP_CHECK(readAxis(axis));
    AXISCOMP_TRY(const auto unfinished, m_store.journal(m_drive.serialNumber, m_axis));
    m_writesAnyway = unfinished.has_value();
    AXISCOMP_TRY(auto prepared, decide(request));
    return std::move(prepared.plan);
}

Result<void> WritePlanner::readAxis(int axis)
{
    m_axis = axis;
    AXISCOMP_TRY(m_status, readStatus(m_access, m_drive, axis, m_sources));
    return {};
}

Result<PreparedWrite> WritePlanner::decide(const WriteRequest& request)
{
    const int axis = m_axis;
    if (request.expected)
        AXISCOMP_CHECK(checkAsPlanned(*request.expected, m_status));

    AXISCOMP_TRY(auto saved, m_store.savedState(m_drive.serialNumber));
    m_saved = std::move(saved);
    m_write = {};
    m_keepsTable = false;
    m_positionFacts.clear();
    m_names.clear();
    m_otherWrites = request.others;
    WritePlan& plan = m_write.plan;
    plan.drive = m_drive;
    plan.axis = axis;
    plan.axisName = m_status.axis.name;
    if (m_status.table)
        plan.gridBefore = m_status.table->grid;
    plan.before = m_status.setup;
    plan.after = m_status.setup;
    plan.after.dimensionality = request.dimensionality;
    plan.warnings = request.doubts;
    auto decided = decideSources(request);
    if (!decided)
        return fail(decided.error());
    plan.lookupAt = lookupAtSources(m_access.profile(), axis, sourcePaths(plan.after));
    plan.ownDimension = ownDimension(m_access.profile(), axis, sourcePaths(plan.after));
    if (request.deletesTable) {
        decided = decideDeletion(request);
    } else if (request.withoutTable) {
        decided = decideNoTable(request);
    } else {
        AXISCOMP_TRY(plan.units,
            unitsOf(std::span(plan.after.sources)
                        .first(static_cast<std::size_t>(plan.after.dimensionality))));
        if (request.expected)
            AXISCOMP_CHECK(checkUnitsAsPlanned(*request.expected, plan.units, m_status));
        AXISCOMP_TRY(const auto converted, inUnitsOfDrive(request));
        decided = decideTable(converted);
    }
    if (decided)
        decided = decideRemoval();
    if (decided)
        decided = decideCoverage();
    if (decided)
        decided = checkColumns(request);
    if (decided) {
        listChanges();
        decided = decideSaving();
    }
    if (decided)
        decided = decideFlash();
    if (!decided)
        return fail(decided.error());
    warn();
    return m_write;
}

Result<void> WritePlanner::decideSources(const WriteRequest& request)
{
    auto& sources = m_write.plan.after.sources;
    const auto dimensions = static_cast<std::size_t>(request.dimensionality);
    if (dimensions < 1 || dimensions > sources.size())
        return fail(ErrorCode::InvalidArgument,
            {{"reason", AXISCOMP_TEXT("Error", "the dimensionality is 1, 2 or 3")}});
    if (!request.sources.empty()) {
        sources = {};
        if (request.sources.size() > dimensions)
            return fail(ErrorCode::SourceSurplus,
                {{"dimension", dimensions + 1}, {"dimensions", dimensions}});
        for (std::size_t n = 0; n < request.sources.size(); ++n) {
            if (request.withoutTable && request.sources[n].empty())
                continue;
            AXISCOMP_TRY(auto source, m_sources.resolve(m_access, request.sources[n]));
            sources[n] = source;
        }
    }
    for (std::size_t n = 0; n < sources.size(); ++n) {
        if (n < dimensions && !sources[n].isSet() && !request.withoutTable)
            return fail(ErrorCode::SourceMissing, {{"dimension", n + 1}});
        if (n >= dimensions && sources[n].isSet())
            return fail(
                ErrorCode::SourceSurplus, {{"dimension", n + 1}, {"dimensions", dimensions}});
        const auto first = std::ranges::find(sources, sources[n]);
        if (sources[n].isSet() && first < sources.begin() + static_cast<std::ptrdiff_t>(n))
            return fail(ErrorCode::SourceRepeated,
                {{"source", sources[n].path}, {"first", first - sources.begin() + 1},
                    {"second", n + 1}});
    }
    return {};
}

/// Of this axis, or of another one whose position is a source.
Result<PositionFacts> WritePlanner::positionFacts(int axis)
{
    if (axis == m_axis)
        return PositionFacts{m_status.axis.name, m_status.axis.unit, m_status.axis.travel};
    const auto known = m_positionFacts.find(axis);
    if (known != m_positionFacts.end())
        return known->second;
    AXISCOMP_TRY(auto facts, readPositionFacts(m_access, axis));
    return m_positionFacts.emplace(axis, std::move(facts)).first->second;
}

/// The names of all axes but this. Asked for only where a file says a name.
Result<std::vector<std::string>> WritePlanner::namesBeside(int axis)
{
    if (m_drive.axes < 2)
        return std::vector<std::string>{};
    if (m_names.empty()) {
        AXISCOMP_TRY(m_names, readAxisNames(m_access, m_drive));
    }
    std::vector<std::string> names;
    for (int other = 0; other < std::ssize(m_names); ++other)
        if (other != axis)
            names.push_back(m_names[static_cast<std::size_t>(other)]);
    return names;
}

Result<TableUnits> WritePlanner::unitsOf(std::span<const DimSource> sources)
{
    return driveUnits(m_access.profile(), sources, m_axis, [this](int axis) -> Result<std::string> {
        AXISCOMP_TRY(auto facts, positionFacts(axis));
        return std::move(facts.unit);
    });
}

Result<WriteRequest> WritePlanner::inUnitsOfDrive(const WriteRequest& request)
{
    if (!request.table)
        return request;
    AXISCOMP_TRY(auto converted,
        inUnitsOfAxis(
            *request.table, m_write.plan.units, m_write.plan.ownDimension, request.unstatedUnit));
    m_write.plan.unitRemarks = std::move(converted.remarks);
    noteUnknownUnits(request.table->grid);
    // Once, so that the drive has what the plan says, and has it already the next time.
    converted.table.grid = storedGrid(std::move(converted.table.grid), m_access.profile().layout);
    m_write.plan.table = std::move(converted.table);
    m_write.plan.isComputed = request.isComputed;
    m_write.plan.largeCorrections = largeCorrections(*m_write.plan.table);
    WriteRequest result = request;
    result.table = m_write.plan.table;
    return result;
}

/// Columns with a unit over a source of which nobody knows it: kelvins over a register in °C would
/// be 273 off. A temperature in °C needs no word.
void WritePlanner::noteUnknownUnits(const Grid& grid)
{
    WritePlan& plan = m_write.plan;
    const DriveProfile& profile = m_access.profile();
    for (std::size_t n = 0; n < std::min(grid.axes.size(), plan.after.sources.size()); ++n) {
        const DimSource& source = plan.after.sources[n];
        const std::string& unit = grid.axes[n].unit;
        const bool isUsual = isCelsius(unit) && profile.isTemperature(source.path);
        if (unit.empty() || isUsual || !source.isSet() || profile.axisOfPosition(source.path))
            continue;
        plan.unitRemarks.push_back(AXISCOMP_TEXT("Error",
            "The positions of dimension {number} are written in {unit} as they stand: the profile "
            "does not say the unit of {source}.")
                                       .with("number", n + 1)
                                       .with("unit", unit)
                                       .with("source", Verbatim{sourceName(source)}));
    }
}

Result<void> WritePlanner::decideCoverage()
{
    WritePlan& plan = m_write.plan;
    const CompensationSetup& after = plan.after;
    const Grid* grid = plan.table ? &plan.table->grid
        : m_status.table          ? &m_status.table->grid
                                  : nullptr;
    if (!grid || after.slot.empty() || grid->dimensions() != after.dimensionality)
        return {};
    AXISCOMP_TRY(plan.coverage,
        travelCoverage(m_access.profile(),
            std::span(after.sources).first(static_cast<std::size_t>(after.dimensionality)), *grid,
            [this](int axis) -> Result<std::optional<Travel>> {
                AXISCOMP_TRY(const auto facts, positionFacts(axis));
                return facts.travel;
            }));
    return {};
}

/// That each column fits its source. The columns as the file has them: converted they would have
/// the units of the drive. Errors: SourceMismatch.
Result<void> WritePlanner::checkColumns(const WriteRequest& request)
{
    WritePlan& plan = m_write.plan;
    const std::size_t columns = request.table ? request.table->grid.axes.size() : 0;
    for (std::size_t n = 0; n < std::min(columns, plan.after.sources.size()); ++n) {
        const DimSource& source = plan.after.sources[n];
        const auto owner = m_access.profile().axisOfPosition(source.path);
        std::string name;
        if (owner) {
            AXISCOMP_TRY(const auto facts, positionFacts(*owner));
            name = facts.name;
        }
        std::optional<Error> unread;
        auto doubt = sourceDoubt(
            m_access.profile(), request.table->grid.axes[n], n + 1, source,
            isStatedSource(*request.table, n), [&](int) { return name; },
            [&](int axis) {
                auto others = namesBeside(axis);
                if (others)
                    return *std::move(others);
                unread = std::move(others).error();
                return std::vector<std::string>{};
            });
        if (unread)
            return fail(*std::move(unread));
        if (doubt && doubt->refusal)
            return fail(*std::move(doubt->refusal));
        if (doubt)
            plan.warnings.push_back(std::move(doubt->text));
    }
    return {};
}

/// Whatever the table is called: that this axis has it, or had it, is no mistake to be made now.
bool WritePlanner::isTargetSettled(TableOrigin origin, bool isThere) const
{
    const WritePlan& plan = m_write.plan;
    const bool hasAll = isThere && plan.before.sources == plan.after.sources;
    return origin == TableOrigin::Axis || (origin != TableOrigin::File && hasAll);
}

/// A file that corrects Y is not for axis X, wherever it is looked up; nor is one for X2 where the
/// drive has X1 and X2.
Result<void> WritePlanner::checkTargetName(const CompensationTable& table, TableOrigin origin)
{
    const std::string& stated = table.target.empty() ? table.statedAxis : table.target;
    const std::string axis =
        stated.empty() ? std::string(axisOfColumn(table.name)) : std::string(trimmed(stated));
    const std::string name = stated.empty() ? nameInValues(table.name) : axis;
    const std::string& own = m_status.axis.name;
    bool isOther = areDifferentAxes(axis, own);
    const bool isName = !name.empty() && !name.starts_with('#') && name != otherAxis;
    if (!isOther && isName && !sameLetters(name, trimmed(own))) {
        AXISCOMP_TRY(const auto others, namesBeside(m_axis));
        isOther = namesAnotherAxis(name, own, others);
    }
    if (!isOther)
        return {};
    const std::string statement =
        axisTarget(m_access.profile(), m_axis, sourcePaths(m_write.plan.after));
    Error error{ErrorCode::TargetMismatch,
        {{"table", table.name}, {"target", Verbatim{axis.empty() ? name : axis}}, {"axis", m_axis},
            {"role",
                own.empty() ? AXISCOMP_TEXT("Error", "there is no name on the drive")
                            : AXISCOMP_TEXT("Error", "the name on the drive is {name}")
                                  .with("name", Verbatim{own})},
            {"statement", statement.empty() ? sourceTarget(0) : statement}},
        {}};
    if (origin != TableOrigin::File)
        error.context.set("kept", Verbatim{"table"});
    return fail(std::move(error));
}

/// Whether the axis, which names an empty slot, may stay as it is: nothing else has to be written,
/// and a reboot brings no table back.
Result<bool> WritePlanner::hasNoTable(const WriteRequest& request) const
{
    const WritePlan& plan = m_write.plan;
    const std::string& slot = plan.before.slot;
    if (!request.leavesEmptySlot || m_status.table || !m_access.profile().slotNamed(slot)
        || plan.before.sources != plan.after.sources)
        return false;
    const auto saved = std::ranges::find(m_saved.uses, m_axis, &SavedState::Use::axis);
    if (m_saved.isCovered(slot) || (saved != m_saved.uses.end() && saved->slot != slot))
        return false;
    AXISCOMP_TRY(const auto unfinished, m_store.journal(m_drive.serialNumber, m_axis));
    return !unfinished.has_value();
}

Result<void> WritePlanner::decideNoTable(const WriteRequest& request)
{
    WritePlan& plan = m_write.plan;
    plan.slotReason = SlotReason::KeepTable;
    AXISCOMP_TRY(const bool isSettled, hasNoTable(request));
    if (isSettled) {
        plan.after = plan.before;
        return {};
    }
    AXISCOMP_TRY(m_returningSlot, returningSlot());
    plan.after.slot.clear();
    plan.after.tableCrc = 0;
    plan.after.persistency = Persistency::Volatile;
    // As an axis without a table shows it.
    const auto set = std::ranges::count_if(plan.after.sources, &DimSource::isSet);
    plan.after.dimensionality = std::max(1, static_cast<int>(set));
    if (!plan.before.slot.empty())
        plan.changes.push_back({"Table", currentTable(), "none"});
    return {};
}

std::string WritePlanner::currentTable() const
{
    const std::string& slot = m_status.setup.slot;
    if (m_status.table)
        return tableText(slot, m_status.table->grid, m_status.table->crc);
    return slot.empty() ? "none" : slot + ", empty";
}

Result<void> WritePlanner::decideTable(const WriteRequest& request)
{
    if (!request.table) {
        if (!m_status.table)
            return fail(ErrorCode::NoTable, {{"axis", m_axis}});
        if (m_status.table->grid.dimensions() != request.dimensionality)
            return fail(ErrorCode::DimensionMismatch,
                {{"table", m_status.table->grid.dimensions()}, {"chosen", request.dimensionality}});
        m_keepsTable = true;
        AXISCOMP_CHECK(checkKeptUnits());
        m_write.plan.slotReason = SlotReason::KeepTable;
        m_write.elementCrc = m_status.table->crc;
        m_write.plan.after.persistency = request.persistency.value_or(m_status.setup.persistency);
        return {};
    }
    const CompensationTable& table = *request.table;
    if (table.grid.dimensions() != request.dimensionality)
        return fail(ErrorCode::DimensionMismatch,
            {{"table", table.grid.dimensions()}, {"chosen", request.dimensionality}});
    AXISCOMP_CHECK(checkMeasuredDrive(request.measuredDrive, m_drive.serialNumber));
    AXISCOMP_CHECK(checkTarget(m_access.profile(), m_axis, sourcePaths(m_write.plan.after), table));
    if (request.lookupAt)
        AXISCOMP_CHECK(checkLookupSources(
            *request.lookupAt, m_access.profile(), m_axis, sourcePaths(m_write.plan.after)));
    AXISCOMP_TRY(auto file, encodeTamTable(table, false, m_access.profile().layout));
    m_write.elementCrc = elementCrcOf(file, table);
    m_write.plan.tableBytes = file.size();
    m_write.plan.after.tableCrc = m_write.elementCrc;
    m_write.plan.after.persistency = request.persistency.value_or(Persistency::Volatile);
    AXISCOMP_TRY(const bool alreadyThere, isThere(request, table));
    if (!isTargetSettled(request.origin, alreadyThere))
        AXISCOMP_CHECK(checkTargetName(table, request.origin));
    if (alreadyThere) {
        m_keepsTable = request.origin == TableOrigin::InUse;
        if (m_keepsTable)
            AXISCOMP_CHECK(checkKeptUnits());
        m_write.plan.slotReason = SlotReason::KeepTable;
        m_write.plan.after.persistency = request.persistency.value_or(m_status.setup.persistency);
        return {};
    }
    return decideNewTable(request, std::move(file));
}

/// A dimension over positions of an axis is none over temperatures, whatever the units.
Result<void> WritePlanner::checkKeptKind(std::size_t dimension) const
{
    const DriveProfile& profile = m_access.profile();
    const std::string& was = m_write.plan.before.sources[dimension].path;
    const std::string& is = m_write.plan.after.sources[dimension].path;
    const auto areOf = [&profile](const std::string& position, const std::string& temperature) {
        return profile.axisOfPosition(position) && profile.isTemperature(temperature);
    };
    if (!areOf(was, is) && !areOf(is, was))
        return {};
    return fail(ErrorCode::UnitMismatch,
        {{"keptKind", Verbatim{"table"}}, {"number", dimension + 1}, {"before", Verbatim{was}},
            {"source", Verbatim{is}}});
}

/// The table that stays has its positions in the units of the sources that it had.
Result<void> WritePlanner::checkKeptUnits()
{
    const WritePlan& plan = m_write.plan;
    if (plan.before.sources == plan.after.sources)
        return {};
    AXISCOMP_TRY(const auto before, unitsOf(plan.before.sources));
    AXISCOMP_TRY(const auto after, unitsOf(plan.after.sources));
    for (std::size_t n = 0; n < after.positions.size(); ++n) {
        AXISCOMP_CHECK(checkKeptKind(n));
        const std::string was = unitSymbol(before.positions[n]);
        const std::string is = unitSymbol(after.positions[n]);
        if (!was.empty() && !is.empty() && !isSameUnit(was, is))
            return fail(ErrorCode::UnitMismatch,
                {{"what",
                     AXISCOMP_TEXT("Error", "positions of dimension {number}")
                         .with("number", n + 1)},
                    {"unit", was}, {"other", is}, {"kept", Verbatim{"table"}}});
    }
    return {};
}

/// Registers may say more than the file holds, which is read.
Result<bool> WritePlanner::isThere(const WriteRequest& request, const CompensationTable& table)
{
    const std::string& current = m_status.setup.slot;
    const TableSlot* slot = m_access.profile().slotNamed(current);
    if (!slot || !m_status.table || m_status.table->crc != m_write.elementCrc
        || !isShownAs(m_status.table->grid, table.grid)
        || request.slot.value_or(current) != current)
        return false;
    AXISCOMP_TRY(const auto bytes, m_access.link().download(slot->file, m_access.exchange()));
    const auto held = decodeTamTable(bytes, m_access.profile().layout);
    return held && sameSpans(held->table.grid, table.grid)
        && elementCrcOf(bytes, held->table) == m_write.elementCrc;
}

Result<void> WritePlanner::decideNewTable(const WriteRequest& request, Bytes file)
{
    AXISCOMP_TRY(auto slots, slotFacts(request));
    auto chosen = chooseSlot(file.size(), request.slot, slots);
    if (!chosen) {
        Error error = std::move(chosen).error();
        // No other slot can be named for a table that is in this one.
        if (error.code == ErrorCode::SlotInUse && request.origin == TableOrigin::Drive)
            error.context.set("imported", m_axis);
        return fail(std::move(error));
    }
    SlotChoice choice = *std::move(chosen);
    m_isSlotNamed = request.slot.has_value();
    m_isSlotEmpty = choice.isEmpty;
    m_write.slot = choice.slot;
    m_write.slotBefore = choice.state;
    m_write.file = std::move(file);
    m_write.plan.slotReason = choice.reason;
    m_write.plan.after.slot = choice.slot.name;
    m_write.plan.changes.push_back({"Table", currentTable(),
        tableText(choice.slot.name, request.table->grid, m_write.elementCrc)});
    return noteStored(request.table->grid);
}

/// Whether the chosen slot holds this table already, and its flash: storing it again costs nothing.
Result<void> WritePlanner::noteStored(const Grid& grid)
{
    const SlotState& there = m_write.slotBefore;
    if (there.elements != grid.pointCount() || there.crc != m_write.elementCrc)
        return {};
    AXISCOMP_TRY(auto readings, m_access.readAvailable(headerPaths(m_access, m_write.slot.name)));
    const auto header = headerFrom(m_access, readings, m_write.slot.name);
    m_isInSlot = header && header->crc == m_write.elementCrc && sameSpans(header->grid, grid);
    m_isStored = m_isInSlot && there.persistent && header->persistent;
    return {};
}

Result<std::vector<SlotFacts>> WritePlanner::slotFacts(const WriteRequest& request)
{
    AXISCOMP_TRY(auto files, m_access.link().listFiles(m_access.exchange()));
    std::vector<SlotFacts> slots;
    for (const DriveFile& file : files) {
        const TableSlot* slot = m_access.profile().slotOfFile(file.path);
        if (!slot)
            continue;
        SlotFacts facts;
        facts.slot = *slot;
        // The drive knows its own limits better than the profile does.
        if (file.maximumSize > 0)
            facts.slot.maximumSize = std::min(slot->maximumSize, file.maximumSize);
        facts.size = file.size;
        facts.isCurrent = slot->name == m_status.setup.slot;
        slots.push_back(facts);
    }
    AXISCOMP_CHECK(lookInto(slots));
    for (SlotFacts& facts : slots)
        if (const auto taken = request.takenSlots.find(facts.slot.name);
            taken != request.takenSlots.end() && facts.otherUser.isEmpty())
            facts.otherUser = taken->second;
    return slots;
}

/// Contents and users of all slots, at one instant where the profile allows.
Result<void> WritePlanner::lookInto(std::vector<SlotFacts>& slots)
{
    AXISCOMP_TRY(auto own, m_store.ownTables(m_drive.serialNumber, m_axis));
    std::vector<std::string> paths;
    for (const SlotFacts& facts : slots) {
        const auto more = slotStatePaths(m_access, m_drive, m_axis, facts.slot.name);
        paths.insert(paths.end(), more.begin(), more.end());
    }
    AXISCOMP_TRY(auto readings, m_access.readAvailable(std::move(paths)));
    for (SlotFacts& facts : slots) {
        facts.state = slotState(m_access, m_drive, m_axis, facts.slot.name, readings);
        facts.otherUser = facts.state.otherUser;
        // Filled since the directory was read.
        if (facts.size == 0 && !facts.state.isEmpty())
            facts.size = facts.slot.maximumSize;
        facts.isOwnPrevious =
            facts.size > 0 && std::ranges::any_of(own, [&](const DriveStore::OwnTable& table) {
                return table.slot == facts.slot.name && table.crc == facts.state.crc;
            });
    }
    const bool isPersistent = m_write.plan.after.persistency == Persistency::Persistent;
    const bool usesSaved = m_status.table && m_status.table->persistent;
    // Otherwise it is known what the saved parameters name, or that they name the table in use.
    if (!isPersistent || !(usesSaved || m_saved.isKnown))
        markKept(slots, own, isPersistent);
    for (SlotFacts& facts : slots) {
        const auto other = m_saved.otherUser(facts.slot.name, m_axis);
        if (other && facts.otherUser.isEmpty())
            facts.otherUser =
                AXISCOMP_TEXT("Error", "axis {axis} after a reboot").with("axis", *other);
        facts.isKept = facts.isKept
            || (isPersistent && m_saved.isInTheWay(facts.slot.name, m_axis, m_write.elementCrc));
    }
    return {};
}

/// What has to be done around saving the parameters, where anything is written at all.
Result<void> WritePlanner::decideSaving()
{
    const WritePlan& plan = m_write.plan;
    m_others.clear();
    const bool isPersistent = plan.after.persistency == Persistency::Persistent;
    const bool isWritten = m_writesAnyway || m_write.saves || !plan.changes.empty();
    if (!isWritten || (!isPersistent && !m_write.saves))
        return {};
    if (auto read = readOthers(); !read)
        return read;
    const auto isCovering = [&](const AxisStatus& status) {
        return status.table && !status.table->persistent && m_saved.isCovered(status.setup.slot);
    };
    m_write.uncovered = static_cast<int>(std::ranges::count_if(m_others, isCovering));
    if (!isPersistent)
        return {};
    const bool isCommitted = plan.slotReason != SlotReason::KeepTable
        || plan.before.persistency != Persistency::Persistent;
    m_write.releases =
        isCommitted && m_saved.isInTheWay(plan.after.slot, m_axis, m_write.elementCrc);
    if (m_write.releases && plan.after.slot != plan.before.slot && isCovering(m_status))
        ++m_write.uncovered;
    return {};
}

Result<void> WritePlanner::readOthers()
{
    for (int axis = 0; axis < m_drive.axes; ++axis) {
        if (axis == m_axis)
            continue;
        auto other = readStatus(m_access, m_drive, axis, m_sources);
        if (!other && other.error().code == ErrorCode::NoCompensation)
            continue;
        if (!other)
            return fail(other.error());
        m_others.push_back(std::move(*other));
    }
    return {};
}

void WritePlanner::listChanges()
{
    WritePlan& plan = m_write.plan;
    if (plan.before.dimensionality != plan.after.dimensionality)
        plan.changes.push_back({"Dimensionality", std::to_string(plan.before.dimensionality) + "D",
            std::to_string(plan.after.dimensionality) + "D"});
    for (std::size_t n = 0; n < plan.after.sources.size(); ++n) {
        const DimSource& before = plan.before.sources[n];
        const DimSource& after = plan.after.sources[n];
        if (!(before == after))
            plan.changes.push_back({"Dim" + std::to_string(n + 1) + "Source",
                sourceText(m_drive.name, before), sourceText(m_drive.name, after)});
    }
    if (plan.after.slot.empty() || (!plan.table && !m_status.table))
        return;
    if (plan.before.persistency != plan.after.persistency || !m_status.table)
        plan.changes.push_back(
            {"Persistency", m_status.table ? persistencyText(plan.before.persistency) : "none",
                persistencyText(plan.after.persistency)});
}

} // namespace axiscomp
