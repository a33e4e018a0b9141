// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/conversion.h"

#include "core/conversion/added_tables.h"
#include "core/conversion/columns_beside.h"
#include "core/conversion/lookup_sides.h"
#include "core/conversion/sign_conversion.h"
#include "core/conversion/unheld_notes.h"
#include "core/formats/formats.h"
#include "core/formats/units.h"
#include "core/formats/wrap_range.h"
#include "core/neutral/table_motion.h"
#include "core/table/position_unit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

namespace axiscomp {

namespace {

double factorOf(const std::string& from, const std::string& to)
{
    return isSameUnit(from, to) ? 1.0 : unitFactor(from, to).value_or(1.0);
}

/// Where the knots of an axis stand in a file.
struct WrittenKnots {
    std::vector<std::size_t> places; ///< among those of the file, of each knot
    bool areSame = true; ///< the file has these knots in this order, and no others
    double rounding = 0.0; ///< the largest, in the unit of the file
};

/// Where the points of a table stand in a file.
struct WrittenPoints {
    std::vector<std::uint32_t> places; ///< of each point; empty: the same, as nearly always

    [[nodiscard]] std::size_t of(std::size_t point) const
    {
        return places.empty() ? point : places[point];
    }
};

std::size_t nearestKnot(const std::vector<double>& knots, double position)
{
    const auto above = std::ranges::lower_bound(knots, position);
    const auto index = static_cast<std::size_t>(above - knots.begin());
    if (index == 0)
        return 0;
    const bool isBelow =
        index == knots.size() || position - knots[index - 1] <= knots[index] - position;
    return isBelow ? index - 1 : index;
}

/// Where the file has its own distance between the knots, which moves each of them more than the
/// one before: in their order, from the one that is nearest to the first.
std::optional<WrittenKnots> movedKnots(const SourceAxis& from, const SourceAxis& to)
{
    const double factor = factorOf(from.unit, to.unit);
    const double turn = to.wrap.value_or(0.0);
    const std::size_t size = to.knots.size();
    std::size_t first = 0;
    if (to.wrap) {
        const double position = from.knots.front() * factor;
        const double turns = std::floor((position - to.knots.front()) / turn);
        first = nearestKnot(to.knots, position - turns * turn);
    }
    const bool isWithin = first + from.knots.size() <= size;
    const bool isOnCircle = isFullTurn(to) && from.knots.size() <= size;
    if (to.wrap ? !isWithin && !isOnCircle : from.knots.size() != size)
        return std::nullopt;
    WrittenKnots moved;
    moved.areSame = first == 0 && from.knots.size() == size;
    for (std::size_t i = 0; i < from.knots.size(); ++i) {
        const std::size_t place = first + i < size ? first + i : first + i - (size - 1);
        const double distance = from.knots[i] * factor - to.knots[place];
        const double turns = to.wrap ? std::round(distance / turn) : 0.0;
        moved.places.push_back(place);
        moved.rounding = std::max(moved.rounding, std::abs(distance - turns * turn));
    }
    return moved;
}

/// Nothing where the file lacks one of them. It may have more, such as the one that closes a table,
/// and begin elsewhere on its circle.
std::optional<WrittenKnots> writtenKnots(const SourceAxis& from, const SourceAxis& to)
{
    const double factor = factorOf(from.unit, to.unit);
    const double first = to.knots.front();
    const double allowance = std::max(to.step, 1e-9 * (to.knots.back() - first));
    WrittenKnots written;
    written.areSame = from.knots.size() == to.knots.size();
    written.places.reserve(from.knots.size());
    for (const double knot : from.knots) {
        double position = knot * factor;
        std::size_t place = nearestKnot(to.knots, position);
        if (to.wrap && std::abs(position - to.knots[place]) > allowance) {
            position -= *to.wrap * std::floor((position - first) / *to.wrap);
            place = nearestKnot(to.knots, position);
        }
        const double rounding = std::abs(position - to.knots[place]);
        if (rounding > allowance)
            return movedKnots(from, to);
        written.areSame = written.areSame && place == written.places.size();
        written.places.push_back(place);
        written.rounding = std::max(written.rounding, rounding);
    }
    return written;
}

/// Nothing for formats that have other points: the conversion's difference tells. roundings: of the
/// positions of each axis.
std::optional<WrittenPoints> writtenPoints(
    const NeutralTable& prepared, const NeutralTable& held, std::vector<double>& roundings)
{
    std::vector<WrittenKnots> axes;
    for (std::size_t n = 0; n < held.axes.size(); ++n) {
        auto knots = writtenKnots(prepared.axes[n], held.axes[n]);
        if (!knots) {
            roundings.clear();
            return std::nullopt;
        }
        roundings.push_back(knots->rounding);
        axes.push_back(*std::move(knots));
    }
    WrittenPoints written;
    if (std::ranges::all_of(axes, &WrittenKnots::areSame))
        return written;
    written.places = {0};
    for (std::size_t n = 0; n < axes.size(); ++n) {
        const std::size_t stride = strideOf(held, n);
        std::vector<std::uint32_t> further;
        further.reserve(written.places.size() * axes[n].places.size());
        for (const std::size_t place : axes[n].places)
            for (const std::uint32_t point : written.places)
                further.push_back(static_cast<std::uint32_t>(point + place * stride));
        written.places = std::move(further);
    }
    return written;
}

/// The largest difference of values before and after writing, in the unit after it.
double largestRounding(
    const CompensationColumn& before, const CompensationColumn& after, const WrittenPoints& points)
{
    const double factor = factorOf(before.unit, after.unit);
    double largest = 0.0;
    for (std::size_t i = 0; i < before.values.size(); ++i)
        largest =
            std::max(largest, std::abs(before.values[i] * factor - after.values[points.of(i)]));
    return largest;
}

/// What can be said point by point. No file says which values were made up.
void notePoints(const NeutralTable& prepared, NeutralTable& held, TableConversion& conversion)
{
    for (CompensationColumn& column : held.columns)
        column.filled.clear();
    const auto points = writtenPoints(prepared, held, conversion.positionRounding);
    if (!points)
        return;
    for (std::size_t n = 0; n < std::min(prepared.columns.size(), held.columns.size()); ++n) {
        const CompensationColumn& from = prepared.columns[n];
        CompensationColumn& to = held.columns[n];
        for (const std::uint32_t point : from.filled)
            to.filled.push_back(static_cast<std::uint32_t>(points->of(point)));
        std::ranges::sort(to.filled);
        to.filled.erase(std::unique(to.filled.begin(), to.filled.end()), to.filled.end());
        conversion.valueRounding.push_back(largestRounding(from, to, *points));
    }
}

/// That a file written by settings, such as the numbers of its axes, does not correct another axis
/// than the sign was converted for.
Result<void> checkSameTargets(const NeutralTable& prepared, const NeutralTable& held)
{
    for (std::size_t n = 0; n < std::min(prepared.columns.size(), held.columns.size()); ++n) {
        const auto before = targetOf(prepared, prepared.columns[n]);
        const auto after = targetOf(held, held.columns[n]);
        if (before && after && before != after)
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the table goes from {before}, and the file would say from {after}; "
                        "correct the settings for its axes, or the target")
                        .with("before", columnText(prepared, prepared.columns[n]))
                        .with("after", columnText(held, held.columns[n]))}});
    }
    return {};
}

/// A format that says its units has brought its numbers into them: what the file calls um may be
/// read in mm, so that another statement would be about other numbers than those in the file.
Result<void> checkStatedUnit(const std::string& unit, const std::string& stated)
{
    if (unit.empty() || stated.empty() || isSameUnit(unit, stated))
        return {};
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "the unit {stated} is stated, and the numbers of the file were read in {unit}; "
                "leave the statement out")
                .with("stated", stated)
                .with("unit", unit)}});
}

Result<void> checkStatedUnits(const NeutralTable& table, const StatedUnits& stated)
{
    for (const SourceAxis& axis : table.axes)
        AXISCOMP_CHECK(checkStatedUnit(axis.unit, stated.positions));
    for (const CompensationColumn& column : table.columns)
        AXISCOMP_CHECK(checkStatedUnit(column.unit, stated.values));
    return {};
}

/// That values in the unit of the drive are not added to positions in a unit that is stated.
Result<void> checkPositionsOfDrive(const NeutralTable& table)
{
    for (const CompensationColumn& column : table.columns) {
        const auto own = ownAxis(table, column);
        if (own && !table.axes[*own].unit.empty())
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the values for {column} are said to be in the unit of the drive, and the "
                        "positions that they are added to are in {unit}; state the unit of the "
                        "values, or that the positions are in that of the drive, too")
                        .with("column", columnText(table, column))
                        .with("unit", table.axes[*own].unit)}});
    }
    return {};
}

/// Even, over the range of the table, with so many points of each axis.
ResamplingRequest gridOf(const std::vector<std::size_t>& points, ResamplingMethod method)
{
    ResamplingRequest grid;
    grid.method = method;
    for (const std::size_t count : points)
        grid.axes.push_back({.points = count, .distance = 0.0, .start = {}, .end = {}});
    return grid;
}

/// One table on its way from one format to the other.
class Converter {
public:
    Converter(const ConversionRequest& request, std::vector<Text>& remarks)
        : m_request(request)
        , m_remarks(remarks)
    {
    }

    /// Everything up to the writing; the conversion keeps what the user wants to know of it.
    [[nodiscard]] Result<NeutralTable> prepare(NeutralTable table, TableConversion& conversion);
    /// Compares; asked: what was to be converted, held: what the file says.
    [[nodiscard]] Result<void> finish(const NeutralTable& asked, const NeutralTable& prepared,
        NeutralTable held, TableConversion& conversion) const;

private:
    /// What is done before the sign is converted.
    [[nodiscard]] Result<NeutralTable> beforeSign(
        NeutralTable table, SetSides sides, TableConversion& conversion) const;
    /// Merged, resampled, and shifted to be 0 where that is asked for, as then the source is, too.
    [[nodiscard]] Result<NeutralTable> onGrid(
        NeutralTable table, TableConversion& conversion) const;
    /// What is done before the sign is converted, of the columns beside the table, on its grid.
    [[nodiscard]] Result<void> prepareBeside(const NeutralTable& table, SetSides sides);
    /// What a conversion needs to know of the units: those of numbers that are added to each other.
    [[nodiscard]] Result<NeutralTable> withUnits(NeutralTable table, SetSides sides) const;
    [[nodiscard]] Result<MergedDirections> merged(NeutralTable table) const;
    [[nodiscard]] Result<NeutralTable> resampled(
        NeutralTable table, TableConversion& conversion) const;
    [[nodiscard]] Result<NeutralTable> signConverted(
        NeutralTable table, SetSides sides, TableConversion& conversion);
    /// With one column for both directions where that is asked for.
    [[nodiscard]] NeutralTable asCompared(NeutralTable source) const;
    void remarkOnEnds(const TableConversion& conversion) const;

    /// A grid that was asked for is kept, and so is an even one where that is all the target takes.
    [[nodiscard]] ConvertedKnots knotsFor(const NeutralTable& table) const
    {
        if (!std::holds_alternative<std::monostate>(m_request.resampling))
            return ConvertedKnots::Same;
        if (m_request.to->facts.knots == KnotRule::Any)
            return ConvertedKnots::Exact;
        return isEven(table) ? ConvertedKnots::Same : ConvertedKnots::ExactIfEven;
    }

    [[nodiscard]] SignConvention targetSign() const
    {
        return m_request.targetSign.value_or(m_request.to->facts.sign);
    }

    /// Whether the numbers become those of the other side of the compensation.
    [[nodiscard]] bool changesSide(const NeutralTable& table, SetSides sides) const
    {
        const auto from = sides.isSourceConverted() ? SignConvention::Command : table.sign;
        const auto to = sides.isTargetConverted() ? SignConvention::Command : targetSign();
        return from != to;
    }

    [[nodiscard]] bool areValuesOfDrive() const { return m_request.units.values == unitOfDrive; }

    /// The columns beside the table.
    struct Beside {
        NeutralTable source; ///< as that of the conversion
        NeutralTable result; ///< with the other sign
    };

    const ConversionRequest& m_request;
    std::vector<Text>& m_remarks;
    std::optional<Beside> m_beside; ///< nothing: none was needed
};

Result<NeutralTable> Converter::withUnits(NeutralTable table, SetSides sides) const
{
    if (!isTriamec(*m_request.from))
        AXISCOMP_CHECK(checkStatedUnits(table, m_request.units));
    for (SourceAxis& axis : table.axes)
        takeStatedUnit(axis.unit, m_request.units.positions);
    for (CompensationColumn& column : table.columns)
        takeStatedUnit(column.unit, m_request.units.values);
    // Its files say neither units nor targets, so that only here both are known.
    if (m_request.from == &softmc::format())
        AXISCOMP_CHECK(checkOneUnit(m_request.from->facts, unitContradiction(table)));
    const bool isChanged = changesSide(table, sides);
    if (areValuesOfDrive()) {
        AXISCOMP_CHECK(isChanged ? checkPositionsOfDrive(table) : Result<void>());
        return table;
    }
    const bool isKept =
        isTriamec(*m_request.from) && m_request.to == &calibration_csv::format() && !isChanged;
    return isKept ? Result<NeutralTable>(std::move(table)) : withUnitsOfValues(table, m_remarks);
}

Result<MergedDirections> Converter::merged(NeutralTable table) const
{
    const bool hasDirections = std::ranges::any_of(table.columns,
        [](const CompensationColumn& column) { return column.direction != Direction::Both; });
    if (m_request.direction && hasDirections)
        return mergeDirections(table, *m_request.direction);
    MergedDirections same{std::move(table), {}, {}};
    same.columns.resize(same.table.columns.size());
    std::iota(same.columns.begin(), same.columns.end(), std::size_t{0});
    return same;
}

Result<NeutralTable> Converter::resampled(NeutralTable table, TableConversion& conversion) const
{
    ResamplingRequest request;
    if (const auto* asked = std::get_if<ResamplingRequest>(&m_request.resampling)) {
        request = *asked;
    } else if (const auto* wanted = std::get_if<WantedDeviation>(&m_request.resampling)) {
        GridLimits limits;
        if (m_request.to->facts.mostPoints > 0)
            limits.mostPoints = m_request.to->facts.mostPoints;
        AXISCOMP_TRY(
            const auto coarsest, coarsestGrid(table, wanted->deviation, wanted->method, limits));
        request = gridOf(coarsest.points, wanted->method);
    } else {
        return table;
    }
    AXISCOMP_TRY(auto resampled, resample(table, request));
    for (const Text& remark : resampled.report.remarks)
        remarkOnce(m_remarks, remark);
    conversion.resampling = std::move(resampled.report);
    return std::move(resampled.table);
}

Result<void> Converter::prepareBeside(const NeutralTable& table, SetSides sides)
{
    if (!m_request.beside)
        return {};
    NeutralTable beside = movingBeside(*m_request.beside, table);
    if (beside.columns.empty())
        return {};
    beside.sign = m_request.sourceSign.value_or(beside.sign);
    ConversionRequest request = m_request;
    if (const auto* wanted = std::get_if<WantedDeviation>(&m_request.resampling))
        request.resampling = gridOf(knotCounts(table), wanted->method);
    std::vector<Text> unsaid; // which is of columns that nobody asked for
    TableConversion conversion;
    AXISCOMP_TRY(
        auto result, Converter(request, unsaid).beforeSign(std::move(beside), sides, conversion));
    m_beside = Beside{std::move(conversion.source), std::move(result)};
    return {};
}

Result<NeutralTable> Converter::signConverted(
    NeutralTable table, SetSides sides, TableConversion& conversion)
{
    const SignConvention to = sides.isTargetConverted() ? SignConvention::Command : targetSign();
    const bool isComputed = m_request.isComputed;
    if (table.sign == to) {
        const bool isForSet = sides.source && sides.target;
        conversion.example =
            isForSet ? examplePointAtSet(table, isComputed) : examplePoint(table, isComputed);
    } else {
        const ConvertedKnots knots = knotsFor(table);
        if (knots == ConvertedKnots::Same)
            table = asWholeTurn(std::move(table), m_request.writing.settings);
        AXISCOMP_CHECK(prepareBeside(table, sides));
        const std::size_t own = table.columns.size();
        if (m_beside)
            appendColumns(table, m_beside->result);
        AXISCOMP_TRY(
            auto converted, convertSign(table, to, m_request.from->facts.behaviour, knots));
        if (m_beside) {
            table.columns.resize(own);
            m_beside->result = takeColumns(converted.table, own);
        }
        if (converted.usesHeldEnds)
            remarkOnce(m_remarks,
                AXISCOMP_TEXT("Error",
                    "at the ends of the table the sign was converted with the end values held, "
                    "where the controller of the source applies nothing"));
        // What the drive looks up at the set position is of neither of the two conventions.
        const NeutralTable& made = converted.table;
        conversion.example = sides.isTargetConverted() ? examplePoint(table, isComputed)
            : sides.isSourceConverted()                ? examplePoint(made, isComputed)
            : to == SignConvention::Command            ? examplePoint(table, made, isComputed)
                                                       : examplePoint(made, table, isComputed);
        table = std::move(converted.table);
    }
    if (sides.isTargetConverted())
        return withTurnedSigns(std::move(table), targetSign());
    return table;
}

Result<NeutralTable> Converter::onGrid(NeutralTable table, TableConversion& conversion) const
{
    AXISCOMP_TRY(const auto zero, zeroWithin(table, m_request.adjustment));
    if (m_request.dropsWrap)
        for (SourceAxis& axis : table.axes)
            axis.wrap.reset();
    AXISCOMP_TRY(auto merge, merged(std::move(table)));
    conversion.directionLosses = std::move(merge.losses);
    const auto ofSource = zero.empty() ? std::nullopt : shiftsToZero(merge.table, zero);
    AXISCOMP_TRY(auto made, resampled(std::move(merge.table), conversion));
    if (!ofSource)
        return made;
    // A grid may end before the position.
    const std::vector<double> shifts = shiftsToZero(made, zero).value_or(*ofSource);
    NeutralTable& source = conversion.source;
    std::vector<double> shiftsOfSource;
    for (std::size_t n = 0; n < source.columns.size(); ++n) {
        const std::size_t own = merge.columns[n];
        shiftsOfSource.push_back(
            factorOf(made.columns[own].unit, source.columns[n].unit) * shifts[own]);
    }
    std::vector<Text> unsaid; // since those of the result are said
    shiftColumns(source, shiftsOfSource, unsaid);
    shiftColumns(made, shifts, m_remarks);
    return made;
}

Result<NeutralTable> Converter::beforeSign(
    NeutralTable table, SetSides sides, TableConversion& conversion) const
{
    AXISCOMP_TRY(table, withUnits(std::move(table), sides));
    AXISCOMP_TRY(table, adjusted(std::move(table), m_request.adjustment, m_remarks));
    conversion.source = table;
    AXISCOMP_TRY(table, onGrid(std::move(table), conversion));
    if (const auto remark = lookupRemark(conversion.source, sides, m_request))
        remarkOnce(m_remarks, *remark);
    if (sides.isSourceConverted()) {
        table = withTurnedSigns(std::move(table), SignConvention::Command);
        conversion.source = withTurnedSigns(std::move(conversion.source), SignConvention::Command);
    }
    conversion.lookupAt = lookupOfResult(conversion.source, m_request);
    return table;
}

Result<NeutralTable> Converter::prepare(NeutralTable table, TableConversion& conversion)
{
    AXISCOMP_CHECK(checkConsistent(table));
    table.sign = m_request.sourceSign.value_or(table.sign);
    AXISCOMP_TRY(
        table, withTargets(std::move(table), m_request.targets, isTriamec(*m_request.from)));
    AXISCOMP_TRY(const auto sides, setSides(table, m_request));
    auto result = beforeSign(std::move(table), sides, conversion);
    if (result)
        result = signConverted(*std::move(result), sides, conversion);
    // The drive's table has no units: its values are in the unit of its axis.
    const bool holdsNoUnits = m_request.to == &tam_table::format();
    if (result && holdsNoUnits && !areValuesOfDrive())
        AXISCOMP_CHECK(checkUnitOfAxis(*result));
    if (result && isTriamec(*m_request.to) && !areValuesOfDrive()
        && (holdsNoUnits || !isTriamec(*m_request.from)))
        result = inPositionUnits(*result, m_remarks);
    if (result)
        result->sign = m_request.to->facts.sign;
    if (result)
        result->notes = notesOfResult(*result, m_request);
    return result;
}

/// What a controller does beyond the ends of a table.
TextPattern endWords(Outside outside)
{
    switch (outside) {
    case Outside::Extrapolate:
        return AXISCOMP_TEXT("Error", "goes on as in the last cell");
    case Outside::Zero:
        return AXISCOMP_TEXT("Error", "applies nothing");
    case Outside::Wrap:
        return AXISCOMP_TEXT("Error", "begins again at the other end");
    case Outside::Hold:
    case Outside::Error:
        break;
    }
    return AXISCOMP_TEXT("Error", "holds the end values");
}

/// A controller that goes on beyond the ends, and another one that does not.
void Converter::remarkOnEnds(const TableConversion& conversion) const
{
    const Outside from = m_request.from->facts.behaviour.outside;
    const Outside to = m_request.to->facts.behaviour.outside;
    if (from == to || (from != Outside::Extrapolate && to != Outside::Extrapolate))
        return;
    for (const ColumnDifference& difference : conversion.difference.columns) {
        const CompensationColumn& column = conversion.source.columns[difference.columnA];
        if (difference.where.empty())
            continue;
        remarkOnce(m_remarks,
            AXISCOMP_TEXT("Error",
                "beyond the ends of the table the controller of {from} {before}, and that of {to} "
                "{after}: up to one cell beyond them, the corrections for {column} differ by at "
                "most {largest}, at {place}")
                .with("from", m_request.from->facts.name)
                .with("before", endWords(from))
                .with("to", m_request.to->facts.name)
                .with("after", endWords(to))
                .with("column", columnText(conversion.source, column))
                .with("largest", quantityOf(difference.largest, column.unit))
                .with("place", positionText(conversion.source, difference.where)));
    }
}

NeutralTable Converter::asCompared(NeutralTable source) const
{
    if (m_request.direction)
        if (auto merge = mergeDirections(source, *m_request.direction))
            return std::move(merge->table);
    return source;
}

Result<void> Converter::finish(const NeutralTable& asked, const NeutralTable& prepared,
    NeutralTable held, TableConversion& conversion) const
{
    AXISCOMP_TRY(const auto sides, setSides(asked, m_request));
    held.sign = targetSign();
    AXISCOMP_CHECK(checkSameTargets(prepared, held));
    NeutralTable source = asCompared(conversion.source);
    const std::size_t own = source.columns.size();
    std::optional<NeutralTable> inUse;
    if (sides.isTargetConverted())
        inUse = withTurnedSigns(held, SignConvention::Command);
    if (m_beside) {
        if (!inUse)
            inUse = held;
        appendColumns(source, asCompared(m_beside->source));
        appendBeside(*inUse, m_beside->result);
    }
    AXISCOMP_TRY(auto difference,
        conversionDifference(source, m_request.from->facts.behaviour, inUse ? *inUse : held,
            m_request.to->facts.behaviour, mostComparedPositions, own));
    conversion.difference = std::move(difference);
    remarkOnEnds(conversion);
    notePoints(prepared, held, conversion);
    conversion.result = std::move(held);
    return {};
}

Result<void> checkSignStated(
    const FormatFacts& facts, bool isStated, std::string_view option, std::string_view entry)
{
    if (isStated || !facts.needsSign())
        return {};
    const TextPattern where = entry.empty()
        ? AXISCOMP_TEXT("Error", "in the field Sign, or with {option}")
        : AXISCOMP_TEXT("Error",
            "in the field Sign, with {option}, or as {entry} in a machine "
            "file");
    return fail(ErrorCode::SignNotStated,
        {{"format", facts.name}, {"sign", signName(facts.sign)},
            {"statement",
                where.with("option", Verbatim{std::string(option)})
                    .with("entry", Verbatim{std::string(entry)})}});
}

/// What a person says of the sign of a file, where nobody has published that of its format, holds
/// for a file that is written for the same controller.
ConversionRequest withBothSigns(ConversionRequest request)
{
    const bool isOne = request.from == request.to && request.from->facts.needsSign();
    if (isOne && !request.targetSign)
        request.targetSign = request.sourceSign;
    return request;
}

/// Within one format every number keeps its sign, whichever it is.
Result<void> checkSigns(const ConversionRequest& request)
{
    if (request.from == request.to && !request.sourceSign && !request.targetSign)
        return {};
    AXISCOMP_CHECK(
        checkSignStated(request.from->facts, request.sourceSign.has_value(), "--sign", "sign"));
    return checkSignStated(request.to->facts, request.targetSign.has_value(), "--to-sign", {});
}

bool changesSign(const Conversion& conversion, const ConversionRequest& request)
{
    const SignConvention sign = request.targetSign.value_or(request.to->facts.sign);
    return std::ranges::any_of(conversion.tables,
        [sign](const TableConversion& table) { return table.source.sign != sign; });
}

} // namespace

Result<Conversion> convertTables(
    std::span<const NeutralTable> tables, const ConversionRequest& asked)
{
    const ConversionRequest request = withBothSigns(asked);
    if (request.to->write == nullptr)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error", "the format {format} can be read, not written")
                    .with("format", request.to->facts.name)}});
    AXISCOMP_CHECK(checkSigns(request));
    Conversion conversion;
    Converter converter(request, conversion.remarks);
    std::vector<NeutralTable> prepared;
    for (const NeutralTable& table : tables) {
        conversion.tables.emplace_back();
        AXISCOMP_TRY(auto result, converter.prepare(table, conversion.tables.back()));
        prepared.push_back(std::move(result));
    }
    AXISCOMP_CHECK(checkHolds(request.to->facts, prepared));
    AXISCOMP_CHECK(checkNamedAxes(request.to->facts, prepared, request.writing.settings));
    AXISCOMP_TRY(auto written, request.to->write(prepared, request.writing));
    conversion.written = std::move(written);
    AXISCOMP_CHECK(checkAddedTables(
        request.from->facts, request.to->facts, prepared, conversion.written.held));
    for (const NeutralTable& table : prepared) {
        AXISCOMP_TRY(auto unheld, unheldNotes(request.to->facts, table.notes));
        for (Text& remark : unheld)
            remarkOnce(conversion.written.remarks, std::move(remark));
    }
    const std::size_t count = std::min(prepared.size(), conversion.written.held.size());
    for (std::size_t n = 0; n < count; ++n)
        AXISCOMP_CHECK(converter.finish(
            tables[n], prepared[n], conversion.written.held[n], conversion.tables[n]));
    if (request.to->facts.addsTables && changesSign(conversion, request))
        for (const Text& remark : signRemarksOfAdded(prepared))
            remarkOnce(conversion.remarks, remark);
    for (const Text& remark : conversion.written.remarks)
        remarkOnce(conversion.remarks, remark);
    return conversion;
}

Result<StatedTable> tableAsStated(const NeutralTable& table, ConversionRequest request)
{
    request.to = request.from;
    if (!request.targetSign)
        request.targetSign = request.sourceSign;
    AXISCOMP_CHECK(checkSigns(request));
    const SignConvention sign = request.targetSign.value_or(table.sign);
    request.targetSign = sign;
    StatedTable stated;
    TableConversion conversion;
    Converter converter(request, stated.remarks);
    AXISCOMP_TRY(auto result, converter.prepare(table, conversion));
    stated.table = std::move(result);
    stated.table.sign = sign;
    return stated;
}

} // namespace axiscomp
