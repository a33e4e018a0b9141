// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/resampling/resampling.h"

#include "core/base/parallel.h"
#include "core/conversion/resampling/axis_interpolant.h"
#include "core/conversion/resampling/resampling_errors.h"
#include "core/curve/curve_grid.h"
#include "core/io/large_memory.h"
#include "core/neutral/table_motion.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::array<std::string_view, 4> methodNames{"linear", "cubic", "spline", "smooth"};

/// Values over a grid of these sizes, the first axis fastest: those of a table, until they are
/// interpolated.
struct Values {
    std::vector<std::size_t> sizes;
    std::span<const double> values;
    std::unique_ptr<double[]> made = {};
    bool areFinite = true; ///< what was made of them
};

using Places = std::vector<AxisInterpolant::Place>;

Places placesOf(const AxisInterpolant& interpolant, const std::vector<double>& positions)
{
    Places places;
    places.reserve(positions.size());
    for (const double position : positions)
        places.push_back(interpolant.placeOf(position));
    return places;
}

/// The first offsets of eight lines along an axis with so many points, of values with this stride;
/// behind the last line it counts again.
EightPlaces placesOfLines(
    std::size_t line, std::size_t lines, std::size_t stride, std::size_t length)
{
    std::array<std::size_t, 8> firsts{};
    for (std::size_t n = 0; n < firsts.size(); ++n) {
        const std::size_t i = std::min(line + n, lines - 1);
        firsts[n] = i / stride * stride * length + i % stride;
    }
    return EightPlaces(firsts);
}

/// into: what keeps the result; nullptr: data does.
void interpolateAlong(Values& data, std::size_t axis, const AxisInterpolant& interpolant,
    const Places& places, std::vector<double>* into = nullptr)
{
    std::size_t stride = 1;
    for (std::size_t n = 0; n < axis; ++n)
        stride *= data.sizes[n];
    const std::size_t count = data.sizes[axis];
    const std::size_t lines = data.values.size() / count;
    const std::size_t size = lines * places.size();
    std::unique_ptr<double[]> own;
    if (into != nullptr) {
        reserveLarge(*into, size);
        into->resize(size);
    } else {
        own = makeLarge<double>(size);
    }
    double* const made = into != nullptr ? into->data() : own.get();
    constexpr std::size_t enough = 32'768; // numbers for a thread to be worth its while
    const std::size_t atOnce =
        8 * std::max<std::size_t>(1, enough / (8 * std::max(count, places.size())));
    std::atomic<bool> areFinite = true;
    shareWork((lines + atOnce - 1) / atOnce, 0, [&](std::size_t part) {
        AxisInterpolant::EightLines eight;
        Eight found;
        Eight zero{}; // stays that, unless a number is infinite or none
        const std::size_t end = std::min(lines, (part + 1) * atOnce);
        for (std::size_t line = part * atOnce; line < end; line += 8) {
            interpolant.load(
                data.values.data(), placesOfLines(line, lines, stride, count), stride, eight);
            const EightPlaces targets = placesOfLines(line, lines, stride, places.size());
            for (std::size_t n = 0; n < places.size(); ++n) {
                interpolant.at(eight, places[n], found);
                zero += found - found;
                targets.store(found, &made[n * stride]);
            }
        }
        for (std::size_t n = 0; n < 8; ++n)
            if (zero[n] != 0.0)
                areFinite = false;
    });
    data.areFinite = data.areFinite && areFinite;
    data.values = {made, size};
    data.made = std::move(own);
    data.sizes[axis] = places.size();
}

/// Of all lines along an axis, before they are interpolated.
ColumnDeviation::Density densityAlong(
    const Values& data, std::size_t axis, const AxisInterpolant& interpolant, const AxisGrid& grid)
{
    std::size_t stride = 1;
    for (std::size_t n = 0; n < axis; ++n)
        stride *= data.sizes[n];
    const double to = grid.start + static_cast<double>(grid.size - 1) * grid.distance;
    ColumnDeviation::Density density{axis, grid.size};
    const std::size_t count = data.sizes[axis];
    std::vector<CurveGrid> made(data.values.size() / count);
    shareWork(made.size(), 0, [&](std::size_t n) {
        AxisInterpolant::Line line;
        interpolant.load(&data.values[n / stride * stride * count + n % stride], stride, line);
        made[n] = curveGrid(interpolant.curve(line), grid.start, to, grid.size);
    });
    for (const CurveGrid& line : made) {
        density.largestDistance = std::max(density.largestDistance, line.largestDistance);
        density.largestSlopeChange = std::max(density.largestSlopeChange, line.largestSlopeChange);
    }
    return density;
}

NeutralTable withoutValues(const NeutralTable& table)
{
    NeutralTable copy{table.name, table.axes, {}, table.sign, table.notes};
    for (const CompensationColumn& column : table.columns)
        copy.columns.push_back({column.name, column.target, column.unit, column.direction, {}});
    return copy;
}

/// Which knots of the source are within the wanted range, and count.
std::vector<std::vector<bool>> wantedKnots(
    const NeutralTable& source, const std::vector<PlannedAxis>& plan)
{
    std::vector<std::vector<bool>> wanted;
    for (std::size_t n = 0; n < plan.size(); ++n) {
        const double rounding =
            1e-12 * (std::abs(plan[n].from) + std::abs(plan[n].to)); // positions are computed
        std::vector<bool>& knots = wanted.emplace_back();
        for (const double knot : source.axes[n].knots)
            knots.push_back(source.axes[n].wrap.has_value()
                || (knot >= plan[n].from - rounding && knot <= plan[n].to + rounding));
    }
    return wanted;
}

ColumnDeviation deviationOf(const NeutralTable& source, const std::vector<PlannedAxis>& plan,
    std::span<const double> values, std::span<const double> found)
{
    ColumnDeviation deviation;
    double sum = 0.0;
    std::size_t count = 0;
    std::size_t largest = 0;
    const std::vector<std::vector<bool>> wanted = wantedKnots(source, plan);
    const std::size_t width = source.axes[0].knots.size();
    for (std::size_t begin = 0; begin < values.size(); begin += width) {
        bool isWanted = true;
        for (std::size_t n = 1, rest = begin / width; n < plan.size(); ++n) {
            isWanted = isWanted && wanted[n][rest % wanted[n].size()];
            rest /= wanted[n].size();
        }
        for (std::size_t i = 0; isWanted && i < width; ++i) {
            if (!wanted[0][i])
                continue;
            const double size = std::abs(found[begin + i] - values[begin + i]);
            sum += size * size;
            ++count;
            if (size > deviation.largest) {
                deviation.largest = size;
                largest = begin + i;
            }
        }
    }
    if (deviation.largest > 0.0) {
        const Position position = knotPosition(source, largest);
        deviation.position.assign(
            position.begin(), position.begin() + static_cast<std::ptrdiff_t>(source.axes.size()));
    }
    deviation.rms = count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
    return deviation;
}

std::vector<ColumnDeviation> deviationsOf(
    const NeutralTable& source, const std::vector<PlannedAxis>& plan, const NeutralTable& resampled)
{
    std::vector<AxisInterpolant> interpolants;
    std::vector<Places> places;
    for (std::size_t n = 0; n < plan.size(); ++n) {
        interpolants.emplace_back(resampled.axes[n], ResamplingMethod::Linear);
        places.push_back(placesOf(interpolants[n], source.axes[n].knots));
    }
    std::vector<ColumnDeviation> deviations;
    for (std::size_t i = 0; i < source.columns.size(); ++i) {
        Values data{knotCounts(resampled), resampled.columns[i].values};
        // The first axis last: its lines lie crosswise in memory, and then there are fewer.
        for (std::size_t n = plan.size(); n-- > 0;)
            if (!plan[n].isKept)
                interpolateAlong(data, n, interpolants[n], places[n]);
        deviations.push_back(deviationOf(source, plan, source.columns[i].values, data.values));
    }
    return deviations;
}

/// The first point again, whatever rounding makes of the last place.
void closeTurn(const SourceAxis& axis, const PlannedAxis& planned, SourceAxis& made, Places& places)
{
    if (!axis.wrap || planned.isKept)
        return;
    places.back() = places.front();
    double& last = made.knots.back();
    last = made.knots.front() + *axis.wrap;
    if (last - made.knots.front() > *axis.wrap) // not longer than the period, by rounding
        last = std::nextafter(last, made.knots.front());
}

} // namespace

std::string_view resamplingMethodName(ResamplingMethod method)
{
    return methodNames[static_cast<std::size_t>(method)];
}

std::optional<ResamplingMethod> resamplingMethodNamed(std::string_view name)
{
    const auto found = std::ranges::find(methodNames, name);
    if (found == methodNames.end())
        return std::nullopt;
    return static_cast<ResamplingMethod>(found - methodNames.begin());
}

bool followsCurve(ResamplingMethod method)
{
    return method == ResamplingMethod::NaturalSpline || method == ResamplingMethod::SmoothingSpline;
}

double ColumnDeviation::distanceFromCurve() const
{
    double sum = 0.0;
    for (const Density& axis : density)
        sum += axis.largestDistance;
    return sum;
}

Result<void> checkMethod(
    const NeutralTable& table, const std::vector<PlannedAxis>& plan, ResamplingMethod method)
{
    constexpr std::size_t fewest = 8; // of smoothingSpline
    for (std::size_t n = 0; method == ResamplingMethod::SmoothingSpline && n < plan.size(); ++n) {
        const SourceAxis& axis = table.axes[n];
        const std::size_t places = axis.knots.size() - (isFullTurn(axis) ? 1 : 0);
        if (!plan[n].isKept && places < fewest)
            return resamplingImpossible(AXISCOMP_TEXT("Error",
                "smoothing needs at least {fewest} positions along {axis}, which has {count}; take "
                "the method spline or cubic")
                                            .with("fewest", fewest)
                                            .with("axis", axisText(table, n))
                                            .with("count", places));
    }
    return {};
}

Result<void> checkResamplable(const NeutralTable& table)
{
    if (auto fine = checkConsistent(table); !fine)
        return fine;
    constexpr double rounding = 1e-9;
    for (std::size_t n = 0; n < table.axes.size(); ++n) {
        const std::size_t stride = strideOf(table, n);
        const std::size_t count = table.axes[n].knots.size();
        if (!isFullTurn(table.axes[n]))
            continue;
        for (const CompensationColumn& column : table.columns) {
            double largest = 0.0;
            for (const double value : column.values)
                largest = std::max(largest, std::abs(value));
            for (std::size_t first = 0; first < column.values.size(); ++first) {
                if (first / stride % count != 0)
                    continue;
                const double begin = column.values[first];
                const double end = column.values[first + (count - 1) * stride];
                if (std::abs(begin - end) > rounding * largest)
                    return resamplingImpossible(AXISCOMP_TEXT("Error",
                        "a full turn of {axis} begins with {begin} and ends with {end}; make both "
                        "the same, or treat the axis as linear (--no-wrap)")
                                                    .with("axis", axisText(table, n))
                                                    .with("begin", quantityOf(begin, column.unit))
                                                    .with("end", quantityOf(end, column.unit)));
            }
        }
    }
    return {};
}

Result<ResampledTable> resampleOnto(
    const NeutralTable& table, const std::vector<PlannedAxis>& plan, ResamplingMethod method)
{
    ResampledTable result{withoutValues(table), {}, {}};
    std::vector<AxisInterpolant> interpolants;
    std::vector<Places> places;
    for (std::size_t n = 0; n < plan.size(); ++n) {
        interpolants.emplace_back(table.axes[n], method);
        places.push_back(placesOf(interpolants[n], plan[n].knots));
        SourceAxis& made = result.table.axes[n];
        made.knots = plan[n].knots;
        made.step = plan[n].isKept ? made.step : 0.0;
        closeTurn(table.axes[n], plan[n], made, places[n]);
        result.grid.push_back(plan[n].grid);
        if (!plan[n].remark.isEmpty())
            result.report.remarks.push_back(plan[n].remark);
        if (plan[n].isShort)
            result.report.losses.push_back(plan[n].remark);
    }
    const auto last = std::ranges::find_if_not(
        plan.rbegin(), plan.rend(), &PlannedAxis::isKept); // of the axes that change
    std::vector<std::vector<ColumnDeviation::Density>> densities;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        Values data{knotCounts(table), table.columns[i].values};
        CompensationColumn& column = result.table.columns[i];
        densities.emplace_back();
        for (std::size_t n = 0; n < plan.size(); ++n) {
            if (plan[n].isKept)
                continue;
            if (followsCurve(method))
                densities.back().push_back(densityAlong(data, n, interpolants[n], plan[n].grid));
            const bool isLast = &plan[n] == &*last;
            interpolateAlong(
                data, n, interpolants[n], places[n], isLast ? &column.values : nullptr);
        }
        if (!data.areFinite)
            return resamplingImpossible(
                AXISCOMP_TEXT("Error", "the values for {column} are too large to be interpolated")
                    .with("column", columnText(table, column)));
        if (last == plan.rend()) {
            column.values = table.columns[i].values;
            column.filled = table.columns[i].filled;
        }
    }
    result.report.columns = deviationsOf(table, plan, result.table);
    for (std::size_t i = 0; i < densities.size(); ++i)
        result.report.columns[i].density = std::move(densities[i]);
    return result;
}

Result<ResampledTable> resample(const NeutralTable& table, const ResamplingRequest& request)
{
    AXISCOMP_CHECK(checkResamplable(table));
    if (request.axes.size() != table.axes.size())
        return invalidArgument(
            AXISCOMP_TEXT("Error", "grids for {count} axes are given, the table has {axes}")
                .with("count", request.axes.size())
                .with("axes", table.axes.size()));
    std::vector<PlannedAxis> plan;
    double points = 1.0;
    for (std::size_t n = 0; n < table.axes.size(); ++n) {
        AXISCOMP_TRY(auto planned, planAxis(table, n, request.axes[n], request.holdsEnds));
        const bool isAsked = request.axes[n].points > 0 || request.axes[n].distance > 0.0;
        if (isAsked && request.method == ResamplingMethod::SmoothingSpline)
            planned.isKept = false; // the same positions, but smoothed
        points *= static_cast<double>(planned.grid.size);
        plan.push_back(std::move(planned));
    }
    if (points > static_cast<double>(mostGridPoints))
        return resamplingImpossible(AXISCOMP_TEXT(
            "Error", "the grid would have more than {count} points; take fewer along an axis")
                                        .with("count", mostGridPoints));
    AXISCOMP_CHECK(checkMethod(table, plan, request.method));
    return resampleOnto(table, plan, request.method);
}

} // namespace axiscomp
