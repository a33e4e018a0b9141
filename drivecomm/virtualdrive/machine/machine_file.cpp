// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/machine/machine_file.h"

#include "core/base/bytes.h"
#include "core/io/local_file.h"
#include "core/io/strict_json.h"
#include "core/text/edit_distance.h"
#include "core/text/number_text.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t mostMachineBytes = std::size_t{1} << 20;
constexpr std::size_t mostMachineAxes = 16;
constexpr std::size_t mostWaves = 100;
constexpr std::size_t mostGross = 1000;
constexpr double mostKnots = 10'000.0;
constexpr double largestTravel = 1e6; ///< in mm or deg
constexpr double largestError = 1e3; ///< likewise
constexpr double steepest = 0.1; ///< error per position
constexpr std::size_t longestAxisName = 24; ///< as the registers of a name can hold
constexpr std::int64_t largestSeed = std::int64_t{1} << 53;

/// All members may be missing; one that is not known is refused, with the known name that looks
/// like it.
void expectOnly(const JsonNode& node, std::initializer_list<std::string_view> known)
{
    for (const std::string& name : node.memberNames()) {
        if (std::ranges::find(known, name) != known.end())
            continue;
        const auto distanceTo = [&name](std::string_view one) {
            return editDistance(name, one, LetterCase::Ignored, one.size());
        };
        const std::string_view nearest = *std::ranges::min_element(known, {}, distanceTo);
        std::vector<std::string> all(known.begin(), known.end());
        const Text shown = Verbatim{shownText(name, 60)};
        if (2 * distanceTo(nearest) <= nearest.size())
            node.refuse(
                AXISCOMP_TEXT("Error", "\"{name}\" is not known here; is \"{nearest}\" meant?")
                    .with("name", shown)
                    .with("nearest", nearest));
        else
            node.refuse(AXISCOMP_TEXT("Error", "\"{name}\" is not known here; there is: {known}")
                            .with("name", shown)
                            .with("known", std::move(all)));
    }
}

double within(const JsonNode& node, double least, double most)
{
    const double number = node.number();
    if (number >= least && number <= most)
        return number;
    node.refuse(AXISCOMP_TEXT("Error", "a number from {least} to {most} is expected, not {found}")
                    .with("least", Quantity{roundedText(least)})
                    .with("most", Quantity{roundedText(most)})
                    .with("found", Quantity{roundedText(number)}));
    return least;
}

double above(const JsonNode& node, double most)
{
    const double number = node.number();
    if (number > 0.0 && number <= most)
        return number;
    node.refuse(AXISCOMP_TEXT("Error", "a number above 0, at most {most}, is expected, not {found}")
                    .with("most", Quantity{roundedText(most)})
                    .with("found", Quantity{roundedText(number)}));
    return most;
}

double optionalWithin(
    const JsonNode& node, std::string_view key, double missing, double least, double most)
{
    return node.has(key) ? within(node[key], least, most) : missing;
}

ErrorTerms readTerms(const JsonNode& node, double low, double high)
{
    ErrorTerms terms;
    terms.slope = optionalWithin(node, "slope", 0.0, -steepest, steepest);
    if (node.has("waves"))
        for (const JsonNode& item : node["waves"].items()) {
            if (terms.waves.size() == mostWaves) {
                item.refuse(AXISCOMP_TEXT("Error", "there are more than {most} waves")
                                .with("most", mostWaves));
                break;
            }
            expectOnly(item, {"period", "amplitude", "phase"});
            terms.waves.push_back({above(item["period"], largestTravel),
                within(item["amplitude"], -largestError, largestError),
                optionalWithin(item, "phase", 0.0, -100.0, 100.0)});
        }
    if (node.has("map")) {
        const JsonNode map = node["map"];
        expectOnly(map, {"spacing", "sigma"});
        terms.map =
            ErrorMap{above(map["spacing"], largestTravel), within(map["sigma"], 0.0, largestError)};
        if ((high - low) / terms.map->spacing > mostKnots)
            map["spacing"].refuse(
                AXISCOMP_TEXT("Error", "the travel has more than {most} knots at this distance")
                    .with("most", static_cast<int>(mostKnots)));
    }
    return terms;
}

ThermalError readThermal(const JsonNode& node)
{
    expectOnly(node, {"expansion", "zeroPerKelvin", "fixedAt", "warmUp"});
    ThermalError thermal;
    thermal.expansion = optionalWithin(node, "expansion", 0.0, -1e-3, 1e-3);
    thermal.zeroPerKelvin = optionalWithin(node, "zeroPerKelvin", 0.0, -1.0, 1.0);
    thermal.fixedAt = optionalWithin(node, "fixedAt", 0.0, -largestTravel, largestTravel);
    if (node.has("warmUp")) {
        const JsonNode warmUp = node["warmUp"];
        expectOnly(warmUp, {"rise", "minutes"});
        thermal.warmUp =
            WarmUp{within(warmUp["rise"], -200.0, 200.0), above(warmUp["minutes"], 1e5)};
    }
    return thermal;
}

void readTravel(const JsonNode& node, MachineAxis& axis)
{
    const std::vector<JsonNode> ends = node.items();
    if (ends.size() != 2) {
        node.refuse(AXISCOMP_TEXT("Error", "two numbers are expected: the ends of the travel"));
        return;
    }
    axis.low = within(ends[0], -largestTravel, largestTravel);
    axis.high = within(ends[1], -largestTravel, largestTravel);
    if (!(axis.low < axis.high))
        node.refuse(AXISCOMP_TEXT("Error", "the first end must be below the second"));
}

/// What an axis is without the others, which its cross terms name.
MachineAxis readAxis(const JsonNode& node, const std::string& name)
{
    expectOnly(node,
        {"unit", "travel", "slope", "waves", "map", "reversal", "reversalWidth", "noise", "thermal",
            "from"});
    MachineAxis axis;
    axis.name = name;
    if (node.has("unit")) {
        const std::string unit = node["unit"].text();
        axis.isAngular = unit == "deg";
        if (unit != "mm" && unit != "deg")
            node["unit"].refuse(AXISCOMP_TEXT("Error", "mm or deg is expected"));
    }
    axis.high = axis.isAngular ? 360.0 : 500.0;
    if (node.has("travel"))
        readTravel(node["travel"], axis);
    axis.terms = readTerms(node, axis.low, axis.high);
    axis.reversal = optionalWithin(node, "reversal", 0.0, -largestError, largestError);
    axis.reversalWidth = optionalWithin(node, "reversalWidth", 0.0, 0.0, axis.high - axis.low);
    if (node.has("noise")) {
        const JsonNode noise = node["noise"];
        expectOnly(noise, {"approach", "reading"});
        axis.approachNoise = optionalWithin(noise, "approach", 0.0, 0.0, largestError);
        axis.readingNoise = optionalWithin(noise, "reading", 0.0, 0.0, largestError);
    }
    if (node.has("thermal"))
        axis.thermal = readThermal(node["thermal"]);
    return axis;
}

/// X, Y, Z, A, B, C, then the others.
std::size_t usualPlace(const std::string& name)
{
    static constexpr std::array<std::string_view, 6> usual{"X", "Y", "Z", "A", "B", "C"};
    return static_cast<std::size_t>(std::ranges::find(usual, name) - usual.begin());
}

std::vector<std::string> axisNames(const JsonNode& node)
{
    std::vector<std::string> names = node.memberNames();
    std::ranges::stable_sort(names, {}, usualPlace);
    if (names.empty() || names.size() > mostMachineAxes)
        node.refuse(AXISCOMP_TEXT("Error", "an object with 1 to {most} axes is expected")
                        .with("most", mostMachineAxes));
    for (const std::string& name : names)
        if (name.empty() || name.size() > longestAxisName || shownText(name) != name)
            node.refuse(AXISCOMP_TEXT("Error", "the name of an axis has 1 to {most} characters")
                            .with("most", longestAxisName));
    return names;
}

/// Nothing: it is refused.
std::optional<std::size_t> axisNamed(
    const JsonNode& node, const std::vector<std::string>& names, const std::string& name)
{
    const auto found = std::ranges::find(names, name);
    if (found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    node.refuse(AXISCOMP_TEXT("Error", "there is no axis \"{name}\"; there is: {known}")
                    .with("name", shownText(name))
                    .with("known", names));
    return std::nullopt;
}

void readCross(const JsonNode& node, const std::vector<std::string>& names,
    std::vector<MachineAxis>& axes, std::size_t self)
{
    for (const std::string& name : node.memberNames()) {
        const auto other = axisNamed(node, names, name);
        if (!other)
            return;
        const JsonNode terms = node[name];
        if (*other == self)
            terms.refuse(AXISCOMP_TEXT(
                "Error", "an axis's own terms stand with the axis; here are those of others"));
        expectOnly(terms, {"slope", "waves", "map"});
        axes[self].cross.push_back({*other, readTerms(terms, axes[*other].low, axes[*other].high)});
    }
}

struct InstrumentUnit {
    std::string_view name;
    double unitsPerPosition;
    bool isAngular;
};
constexpr std::array instrumentUnits{InstrumentUnit{"mm", 1.0, false},
    InstrumentUnit{"m", 1e-3, false}, InstrumentUnit{"um", 1e3, false},
    InstrumentUnit{"inch", 1.0 / 25.4, false}, InstrumentUnit{"deg", 1.0, true},
    InstrumentUnit{"arcsec", 3600.0, true}};

void readInstrumentUnit(const JsonNode& node, MachineInstrument& instrument, bool isAngular)
{
    const std::string wanted =
        node.has("unit") ? node["unit"].text() : std::string(isAngular ? "deg" : "mm");
    std::vector<std::string> fitting;
    for (const InstrumentUnit& unit : instrumentUnits) {
        if (unit.isAngular != isAngular)
            continue;
        fitting.emplace_back(unit.name);
        if (unit.name != wanted)
            continue;
        instrument.unit = unit.name;
        instrument.unitsPerPosition = unit.unitsPerPosition;
        return;
    }
    node["unit"].refuse(AXISCOMP_TEXT("Error", "one of these units is expected: {known}")
                            .with("known", std::move(fitting)));
}

MachineInstrument readInstrument(const JsonNode& node, const std::vector<std::string>& names,
    const std::vector<MachineAxis>& axes)
{
    expectOnly(node, {"axis", "zero", "sign", "unit", "gross"});
    MachineInstrument instrument;
    if (node.has("axis"))
        instrument.axis = axisNamed(node["axis"], names, node["axis"].text()).value_or(0);
    instrument.zero = optionalWithin(node, "zero", 0.0, -largestTravel, largestTravel);
    if (node.has("sign")) {
        instrument.sign = node["sign"].integer<int>(-1, 1);
        if (instrument.sign == 0)
            node["sign"].refuse(AXISCOMP_TEXT("Error", "1 or -1 is expected"));
    }
    readInstrumentUnit(node, instrument, axes[instrument.axis].isAngular);
    if (node.has("gross"))
        for (const JsonNode& item : node["gross"].items()) {
            if (instrument.gross.size() == mostGross) {
                item.refuse(AXISCOMP_TEXT("Error", "there are more than {most} gross errors")
                                .with("most", mostGross));
                break;
            }
            expectOnly(item, {"reading", "by"});
            instrument.gross.push_back({item["reading"].integer<std::uint64_t>(1, 1'000'000'000),
                within(item["by"], -largestTravel, largestTravel)});
        }
    return instrument;
}

MachineDescription readMachine(const JsonNode& root)
{
    expectOnly(root, {"seed", "axes", "instrument"});
    MachineDescription machine;
    if (root.has("seed"))
        machine.seed = root["seed"].integer<std::uint64_t>(0, largestSeed);
    const JsonNode axes = root["axes"];
    const std::vector<std::string> names = axisNames(axes);
    for (const std::string& name : names)
        machine.axes.push_back(readAxis(axes[name], name));
    for (std::size_t i = 0; i < names.size(); ++i)
        if (axes[names[i]].has("from"))
            readCross(axes[names[i]]["from"], names, machine.axes, i);
    if (!names.empty() && root.has("instrument"))
        machine.instrument = readInstrument(root["instrument"], names, machine.axes);
    else if (!names.empty() && machine.axes.front().isAngular)
        machine.instrument.unit = "deg";
    return machine;
}

} // namespace

Result<MachineDescription> parseMachine(std::string_view json, const std::string& fileName)
{
    constexpr int deepest = 8;
    constexpr std::size_t mostValues = 20'000;
    StrictJson document(json, {mostMachineBytes, deepest, mostValues});
    MachineDescription machine = readMachine(document.root());
    if (document.problem())
        return fail(ErrorCode::FileNotReadable,
            {{"file", fileName}, {"reason", document.problem()->reason}});
    return machine;
}

Result<MachineDescription> loadMachine(const std::filesystem::path& file)
{
    AXISCOMP_TRY(const auto bytes, loadFile(file, mostMachineBytes));
    return parseMachine(asText(bytes), file.string());
}

} // namespace axiscomp::drivecomm
