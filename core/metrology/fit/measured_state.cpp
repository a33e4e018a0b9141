// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/measured_state.h"

#include "core/metrology/fit/fit_errors.h"
#include "core/table/table_identity.h"
#include "core/table/target_axis.h"
#include "core/text/crc_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace axiscomp {

namespace {

using StateKind = MeasuredState::Kind;

auto wrongState(Text reason)
{
    return fail(ErrorCode::MeasurementState, {{"reason", std::move(reason)}});
}

std::vector<std::string> crcList(const KnownTables& tables)
{
    std::vector<std::string> list;
    for (const std::uint32_t crc : tables.crcs)
        list.push_back(crcText(crc));
    return list;
}

Text stateText(const MeasuredState& state)
{
    if (state.kind == StateKind::Off)
        return AXISCOMP_TEXT("Measurement", "the compensation off");
    if (!state.tableCrc)
        return AXISCOMP_TEXT("Measurement", "the compensation on");
    return AXISCOMP_TEXT("Measurement", "the table {crc} active")
        .with("crc", crcText(*state.tableCrc));
}

/// What the file and the person say together. Errors: MeasurementState.
Result<MeasuredState> agreedState(const StateRequest& request)
{
    const MeasuredState& onFile = request.onFile;
    if (!request.stated) {
        if (onFile.kind == StateKind::NotSaid)
            return wrongState(AXISCOMP_TEXT("Error",
                "the measurement does not say whether a compensation was active while it was "
                "made: say that it was off, that it was on, or which table was active "
                "(--measured-with off, --measured-with on, or --measured-with and the file of the "
                "table)"));
        return onFile;
    }
    const MeasuredState& stated = *request.stated;
    const MeasuredState& said = onFile.kind == StateKind::NotSaid ? request.onSomeFiles : onFile;
    const bool isSame = said.kind == StateKind::NotSaid
        || (said.kind == stated.kind
            && (!said.tableCrc || !stated.tableCrc || *said.tableCrc == *stated.tableCrc));
    if (!isSame)
        return wrongState(AXISCOMP_TEXT("Error",
            "the measurement says that it was made with {recorded}, not with {stated}; say nothing "
            "else (--measured-with), or take the table that was active")
                              .with("recorded", stateText(said))
                              .with("stated", stateText(stated)));
    MeasuredState agreed = stated;
    if (!agreed.tableCrc)
        agreed.tableCrc = said.tableCrc;
    return agreed;
}

std::vector<std::string> namedTargets(const std::vector<std::string>& targets)
{
    std::vector<std::string> named;
    std::ranges::copy_if(targets, std::back_inserter(named),
        [](const std::string& target) { return !target.empty(); });
    return named;
}

/// In mm and in m the same numbers have the same CRC, so that it does not tell which they are in.
Result<void> checkUnitStated(const KnownTables& known, std::uint32_t crc)
{
    const auto table = known.indexWithCrc(crc);
    if (!table || known.isUnitStated(*table))
        return {};
    return wrongState(AXISCOMP_TEXT("Error",
        "{name} does not say the unit of its numbers, and its CRC-32 {crc} is the same in mm and "
        "in "
        "m, in degrees and in radians: take a calibration file in whose header the units stand, "
        "such as the one that reading the table from the drive writes")
                          .with("name", known.name)
                          .with("crc", crcText(crc)));
}

/// Two tables with these values, which lie over other positions; nothing: there is but one. The
/// measurement has the CRC alone, so that it does not tell which of them was active.
std::optional<std::pair<const KnownTables*, const KnownTables*>> doubtful(
    const StateRequest& request, std::uint32_t crc)
{
    std::vector<const KnownTables*> all{request.onto};
    for (const KnownTables& known : request.others)
        all.push_back(&known);
    const KnownTables* first = nullptr;
    for (const KnownTables* const known : all) {
        if (!known->has(crc))
            continue;
        first = first ? first : known;
        if (!isSameTable({crc, first->withCrc(crc)->grid}, {crc, known->withCrc(crc)->grid}))
            return std::pair(first, known);
    }
    return std::nullopt;
}

const KnownTables* tablesOf(const StateRequest& request, std::uint32_t crc)
{
    if (request.onto->has(crc))
        return request.onto;
    const auto found = std::ranges::find_if(
        request.others, [crc](const KnownTables& known) { return known.has(crc); });
    return found == request.others.end() ? nullptr : &*found;
}

tl::unexpected<Error> otherSources(const KnownTables& active)
{
    return wrongState(AXISCOMP_TEXT("Error",
        "while {name} was active the sources of the axis were others, so that its values may "
        "belong "
        "to other positions: measure again with what the axis has now")
                          .with("name", active.name));
}

Result<FoundState> measuredOn(const StateRequest& request, const MeasuredState& state)
{
    if (!request.onto)
        return wrongState(state.tableCrc
                ? AXISCOMP_TEXT("Error",
                    "these are residuals of the table {crc}, which was active while they were "
                    "measured: merge them onto that table, from its file or from the drive "
                    "(--onto and the file, or --onto drive)")
                      .with("crc", crcText(*state.tableCrc))
                : Text(AXISCOMP_TEXT("Error",
                    "these are residuals of a table that was active while they were measured: "
                    "merge them onto that table, from its file or from the drive (--onto and the "
                    "file, or --onto drive)")));
    FoundState found;
    found.kind = FoundState::Kind::On;
    found.active = request.onto;
    found.axis = request.axis;
    if (state.tableCrc) {
        found.active = tablesOf(request, *state.tableCrc);
        if (!found.active)
            return wrongState(AXISCOMP_TEXT("Error",
                "it was measured with the table {crc} active, which is not {name} ({known}), nor "
                "any other table known; give its file (--measured-with), or merge onto it")
                                  .with("crc", crcText(*state.tableCrc))
                                  .with("name", request.onto->name)
                                  .with("known", crcList(*request.onto)));
        if (const auto both = doubtful(request, *state.tableCrc))
            return wrongState(AXISCOMP_TEXT("Error",
                "it was measured with the table {crc} active, and {first} and {second} have the "
                "same values over other positions: merge onto the file of the one that was active "
                "(--onto)")
                                  .with("crc", crcText(*state.tableCrc))
                                  .with("first", both->first->name)
                                  .with("second", both->second->name));
        if (found.active->hadOtherSources)
            return otherSources(*found.active);
        if (request.onFile.tableCrc || request.onSomeFiles.tableCrc)
            AXISCOMP_CHECK(checkUnitStated(*found.active, *state.tableCrc));
        found.tableCrc = state.tableCrc;
        found.text = AXISCOMP_TEXT("Measurement", "measured with the table {crc} of {name} active")
                         .with("crc", crcText(*state.tableCrc))
                         .with("name", found.active->name);
        return found;
    }
    if (request.onto->hadOtherSources)
        return otherSources(*request.onto);
    found.text = AXISCOMP_TEXT("Measurement", "measured with {name} active ({known})")
                     .with("name", request.onto->name)
                     .with("known", crcList(*request.onto));
    found.assumption = AXISCOMP_TEXT("Measurement",
        "the measurement does not say which table was active; {name} ({known}) is taken to have "
        "been")
                           .with("name", request.onto->name)
                           .with("known", crcList(*request.onto));
    return found;
}

} // namespace

bool KnownTables::has(std::uint32_t crc) const
{
    return indexWithCrc(crc).has_value();
}

const CompensationTable* KnownTables::withCrc(std::uint32_t crc) const
{
    const auto index = indexWithCrc(crc);
    return index ? &tables[*index] : nullptr;
}

std::optional<std::size_t> KnownTables::indexWithCrc(std::uint32_t crc) const
{
    if (const auto found = std::ranges::find(crcs, crc); found != crcs.end())
        return static_cast<std::size_t>(found - crcs.begin());
    const auto other = std::ranges::find_if(origins, [crc](const Origin& origin) {
        return std::ranges::find(origin.otherCrcs, crc) != origin.otherCrcs.end();
    });
    if (other == origins.end())
        return std::nullopt;
    return static_cast<std::size_t>(other - origins.begin());
}

bool KnownTables::isUnitStated(std::size_t table) const
{
    return table >= origins.size() || origins[table].isUnitStated;
}

MeasuredState statedTable(
    const KnownTables& known, std::size_t table, const MeasurementHeader& onFile)
{
    for (const MeasuredState& said : {onFile.compensation, onFile.compensationOfSome})
        if (said.tableCrc && known.indexWithCrc(*said.tableCrc) == table)
            return {MeasuredState::Kind::On, said.tableCrc};
    return {MeasuredState::Kind::On, known.crcs[table]};
}

Result<std::size_t> tableOfAxis(const KnownTables& known, std::string_view axis)
{
    if (known.tables.size() == 1)
        return std::size_t{0};
    std::vector<std::string> targets;
    for (const CompensationTable& table : known.tables)
        targets.push_back(targetName(table));
    const auto matchesOf = [&targets](std::string_view name) {
        std::vector<std::size_t> matches;
        for (std::size_t n = 0; n < targets.size(); ++n)
            if (!name.empty() && sameLetters(targets[n], name))
                matches.push_back(n);
        return matches;
    };
    auto matches = matchesOf(axis);
    if (matches.empty())
        matches = matchesOf(axisInHeader(axis));
    if (matches.size() == 1)
        return matches.front();
    if (matches.size() > 1)
        return badFit(AXISCOMP_TEXT("Error",
            "{name} has several tables of axis {axis}; which of them was active has to be said by "
            "its CRC, in the file of the measurement (// compensation: crc:{crc})")
                          .with("name", known.name)
                          .with("axis", axis)
                          .with("crc", crcText(known.crcs[matches.front()])));
    const auto axes = namedTargets(targets);
    if (axes.empty())
        return badFit(AXISCOMP_TEXT("Error",
            "{name} has several tables, none of which says its axis, so that it is not known which "
            "of them is meant: take a file with that table alone")
                          .with("name", known.name));
    return badFit(AXISCOMP_TEXT("Error",
        "{name} has several tables, and which of them is meant is not known: state the axis as it "
        "is called there (--target, or // axis: in the file of the measurement; there are: "
        "{axes}), or take a file with that table alone")
                      .with("name", known.name)
                      .with("axes", axes));
}

std::string_view stateName(FoundState::Kind kind)
{
    switch (kind) {
    case FoundState::Kind::Off:
        return "off";
    case FoundState::Kind::On:
        return "on";
    case FoundState::Kind::Irrelevant:
        return "irrelevant";
    }
    return {};
}

Result<FoundState> findState(const StateRequest& request)
{
    if (request.hasRawReadings) {
        if (request.onto && request.onto->hadOtherSources)
            return wrongState(AXISCOMP_TEXT("Error",
                "the axis had other sources with {name}, so that its values may belong to other "
                "positions: merge onto nothing (leave out --onto), since with the raw positions on "
                "file the values are the whole error")
                                  .with("name", request.onto->name));
        FoundState found;
        found.kind = FoundState::Kind::Irrelevant;
        found.active = request.onto;
        found.axis = request.axis;
        found.text = AXISCOMP_TEXT("Measurement",
            "the raw positions of the encoder are on file: the table is made of reference minus "
            "encoder, whatever compensation was active");
        return found;
    }
    AXISCOMP_TRY(const auto state, agreedState(request));
    if (state.kind == StateKind::On)
        return measuredOn(request, state);
    if (request.onto)
        return wrongState(AXISCOMP_TEXT("Error",
            "it was measured with the compensation off: the values are the whole error, and must "
            "not be added to {name}; merge them onto nothing (leave out --onto), or measure with "
            "that table active")
                              .with("name", request.onto->name));
    FoundState found;
    found.axis = request.axis;
    found.text = AXISCOMP_TEXT("Measurement", "measured with the compensation off");
    return found;
}

} // namespace axiscomp
