// SPDX-License-Identifier: GPL-3.0-or-later
// Points anywhere in a square or cube of 100 mm with a field of 10 um and noise of 0.5 um onto
// grids, and curves. Beside the time stands how far the result is from the field: rmsToTruth_um.
// scipy_fit.py has other programs' figures.
#include "core/curve/smoothing_spline.h"
#include "core/metrology/fit/grid_fit.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace {

using namespace axiscomp;

constexpr double side = 100.0;
constexpr double noise = 0.5;

/// The same as in scipy_fit.py; the shortest wave is 58 mm long.
double field(double x, double y, double z)
{
    constexpr double turn = 2.0 * std::numbers::pi / side;
    return 5.0 * std::sin(0.9 * turn * x + 0.4) * std::cos(0.8 * turn * y)
        + 3.5 * std::sin(turn * (0.9 * y + 0.7 * z) + 1.0) + 2.0 * std::cos(turn * (1.4 * x - z))
        + 6.0 * x * y / (side * side);
}

struct Scatter {
    std::array<std::vector<double>, 3> coordinates;
    std::vector<double> values;

    Scatter(std::size_t dimensions, std::size_t count)
    {
        std::mt19937_64 random(5); // NOLINT: the same points every time
        std::uniform_real_distribution<double> place(0.0, side);
        std::normal_distribution<double> error(0.0, noise);
        for (std::size_t i = 0; i < count; ++i) {
            std::array<double, 3> p{};
            for (std::size_t axis = 0; axis < dimensions; ++axis) {
                p[axis] = place(random);
                coordinates[axis].push_back(p[axis]);
            }
            values.push_back(field(p[0], p[1], p[2]) + error(random));
        }
    }
};

/// Arguments: dimensions, points, nodes along each axis, 1 when the smoothness is searched for.
void scatteredPoints(benchmark::State& state)
{
    const auto dimensions = static_cast<std::size_t>(state.range(0));
    const Scatter points(dimensions, static_cast<std::size_t>(state.range(1)));
    const auto size = static_cast<std::uint32_t>(state.range(2));
    GridFitRequest request;
    request.farPoints = FarPoints::Smooth;
    for (std::size_t axis = 0; axis < dimensions; ++axis)
        request.grid.axes.push_back({{}, "mm", 0.0, side / (size - 1.0), size});
    const ScatteredValues values{
        {points.coordinates[0], points.coordinates[1], points.coordinates[2]}, points.values};
    if (state.range(3) == 0) // what the search finds
        request.smoothness = fitGrid(values, request)->smoothness;
    GridFit fit;
    for (auto _ : state)
        fit = *fitGrid(values, request);
    double square = 0.0;
    for (std::size_t node = 0; node < fit.values.size(); ++node) {
        const double h = request.grid.axes[0].distance;
        const auto place = [&](std::size_t number) {
            return h * static_cast<double>(number % size);
        };
        const double truth = field(
            place(node), place(node / size), dimensions == 3 ? place(node / size / size) : 0.0);
        square += (fit.values[node] - truth) * (fit.values[node] - truth);
    }
    state.counters["rmsToTruth_um"] = std::sqrt(square / static_cast<double>(fit.values.size()));
}
BENCHMARK(scatteredPoints)
    ->Args({2, 100'000, 200, 0})
    ->Args({2, 100'000, 200, 1})
    ->Args({2, 1'000'000, 200, 1})
    ->Args({3, 100'000, 80, 1})
    ->Args({3, 1'000'000, 80, 0})
    ->Args({3, 1'000'000, 80, 1})
    ->Unit(benchmark::kMillisecond);

double curve(double x)
{
    return 3.0 * std::sin(2.0 * std::numbers::pi * x / 430.0 + 0.7)
        + 1.2 * std::sin(2.0 * std::numbers::pi * x / 97.0);
}

void automaticSmoothingSpline(benchmark::State& state)
{
    std::mt19937_64 random(1); // NOLINT: the same points every time
    std::normal_distribution<double> error(0.0, noise);
    std::vector<double> x;
    std::vector<double> y;
    const auto count = static_cast<std::size_t>(state.range(0));
    for (std::size_t i = 0; i < count; ++i) {
        x.push_back(500.0 * static_cast<double>(i) / static_cast<double>(count - 1));
        y.push_back(curve(x.back()) + error(random));
    }
    SmoothedCurve fit;
    for (auto _ : state)
        fit = *smoothingSpline({x, y});
    double square = 0.0;
    for (const double place : x)
        square += std::pow(fit.curve.at(place) - curve(place), 2);
    state.counters["rmsToTruth_um"] = std::sqrt(square / static_cast<double>(count));
}
BENCHMARK(automaticSmoothingSpline)
    ->Arg(81)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
