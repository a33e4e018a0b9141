// SPDX-License-Identifier: GPL-3.0-or-later
// The window's picture and values of the largest tables, drawn offscreen at the size that they have
// on the page. The time of copying as many pixels as the picture has is the measure for a machine.
#include "core/table/contours.h"
#include "ui/data/values_model.h"
#include "ui/drawing/plot_canvas.h"
#include "ui/drawing/surface_image.h"
#include "ui/plot/vector_view.h"

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>

#include "ui/drawing/custom_plot.h"
#include "ui/drawing/table_map.h"

#include <cmath>

namespace {

using namespace axiscomp;
using namespace axiscomp::ui;

constexpr QSize pageSize(780, 430);

TableViewModel::Table waves(const std::vector<std::uint32_t>& sizes, double phase = 0.0)
{
    CompensationTable table;
    for (const std::uint32_t size : sizes)
        table.grid.axes.push_back({{}, "mm", 0.0, 0.25, size});
    table.values.resize(table.grid.pointCount());
    for (std::size_t i = 0; i < table.values.size(); ++i)
        table.values[i] =
            static_cast<float>(0.003 * std::sin(0.0037 * static_cast<double>(i) + phase));
    return std::make_shared<const CompensationTable>(std::move(table));
}

struct Picture {
    Picture()
    {
        window.resize(pageSize);
        canvas.plot().resize(pageSize);
        window.show();
    }
    void draw() { canvas.plot().replot(QCustomPlot::rpImmediateRefresh); }

    QWidget window;
    PlotCanvas canvas{&window};
};

/// Copying as many pixels as the picture has, in seconds of this machine.
double secondsOfCopying()
{
    static const double seconds = [] {
        const QImage image(pageSize, QImage::Format_RGB32);
        constexpr int times = 400;
        QElapsedTimer timer;
        timer.start();
        for (int n = 0; n < times; ++n)
            benchmark::DoNotOptimize(image.copy());
        constexpr double nanosecond = 1e-9;
        return static_cast<double>(timer.nsecsElapsed()) * nanosecond / times;
    }();
    return seconds;
}

/// How many such copies one round takes.
void countCopies(benchmark::State& state)
{
    state.counters["copies"] = benchmark::Counter(secondsOfCopying(),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void copyPixels(benchmark::State& state)
{
    const QImage image(pageSize, QImage::Format_RGB32);
    for (auto _ : state)
        benchmark::DoNotOptimize(image.copy());
    countCopies(state);
}

void redraw(benchmark::State& state, const std::vector<std::uint32_t>& sizes)
{
    Picture picture;
    picture.canvas.show(waves(sizes), nullptr, 0.003);
    picture.draw();
    for (auto _ : state)
        picture.draw();
    countCopies(state);
}

/// Another table each time: from its values to the screen.
void change(benchmark::State& state, const std::vector<std::uint32_t>& sizes)
{
    Picture picture;
    const std::array<TableViewModel::Table, 2> tables{waves(sizes), waves(sizes, 1.0)};
    std::size_t turn = 0;
    for (auto _ : state) {
        picture.canvas.show(tables.at(++turn % 2), nullptr, 0.003);
        picture.draw();
    }
    countCopies(state);
}

void map724Redraw(benchmark::State& state)
{
    redraw(state, {724, 724});
}
void map724Change(benchmark::State& state)
{
    change(state, {724, 724});
}
void curve100000Redraw(benchmark::State& state)
{
    redraw(state, {100'000});
}
void curve100000Change(benchmark::State& state)
{
    change(state, {100'000});
}

void map724Crosshair(benchmark::State& state)
{
    Picture picture;
    picture.canvas.show(waves({724, 724}), nullptr, 0.003);
    picture.draw();
    std::size_t at = 0;
    for (auto _ : state) {
        ++at;
        picture.canvas.setCrosshair(GridPoint{at % 724, at % 700});
    }
    countCopies(state);
}

/// 28 long lines and rings.
CompensationTable hills()
{
    CompensationTable table = *waves({724, 724});
    for (std::size_t i = 0; i < table.values.size(); ++i)
        table.values[i] = static_cast<float>(0.003 * std::sin(0.01 * static_cast<double>(i % 724))
            * std::cos(0.013 * static_cast<double>(i / 724)));
    return table;
}

void contours724(benchmark::State& state)
{
    const CompensationTable table = hills();
    for (auto _ : state)
        benchmark::DoNotOptimize(contours(table, contourLevels(table)));
    countCopies(state);
}

/// samples: along each dimension.
void surface724(benchmark::State& state, int samples)
{
    const SurfaceSight sight{std::make_shared<const CompensationTable>(hills()), 30.0, 35.0, 1000.0,
        {-0.003, 0.003}, pageSize};
    for (auto _ : state)
        benchmark::DoNotOptimize(surfaceImage(
            sight, divergingGradient(false), QCPRange(-0.003, 0.003), Qt::black, samples));
    countCopies(state);
}
void surface724Turning(benchmark::State& state)
{
    surface724(state, 100);
}
void surface724Whole(benchmark::State& state)
{
    surface724(state, 4096);
}

/// The grid of two axes' errors, as it is drawn again when an axis moves.
void vectors724Redraw(benchmark::State& state)
{
    auto data = std::make_shared<CalibrationData>();
    for (const char* target : {"X", "Y"}) {
        CompensationTable table = hills();
        table.grid.axes[0].name = "X";
        table.grid.axes[1].name = "Y";
        table.target = target;
        data->grid = table.grid;
        data->tables.push_back(std::move(table));
    }
    TableViewModel shown;
    VectorView view(shown);
    view.resize(pageSize);
    view.setData(data);
    view.show();
    auto* plot = view.findChild<QCustomPlot*>(QStringLiteral("vectorCanvas"));
    plot->resize(pageSize);
    for (auto _ : state)
        plot->replot(QCustomPlot::rpImmediateRefresh);
    countCopies(state);
}

/// What a view asks for to draw 24 rows of 8 cells, somewhere in 720 x 720.
void valuesScreen(benchmark::State& state)
{
    TableViewModel shown;
    shown.setTables(waves({720, 720}), nullptr);
    const ValuesModel model(shown);
    int first = 0;
    for (auto _ : state) {
        first = (first + 97) % 690;
        for (int row = first; row < first + 24; ++row) {
            for (int column = first; column < first + 8; ++column) {
                const QModelIndex cell = model.index(row, column);
                for (const int role : {Qt::DisplayRole, Qt::TextAlignmentRole, Qt::FontRole,
                         Qt::BackgroundRole, Qt::ForegroundRole, Qt::DecorationRole})
                    benchmark::DoNotOptimize(cell.data(role));
            }
        }
    }
    countCopies(state);
}

BENCHMARK(copyPixels)->Unit(benchmark::kMicrosecond);
BENCHMARK(map724Redraw)->Unit(benchmark::kMicrosecond);
BENCHMARK(map724Change)->Unit(benchmark::kMicrosecond);
BENCHMARK(map724Crosshair)->Unit(benchmark::kMicrosecond);
BENCHMARK(curve100000Redraw)->Unit(benchmark::kMicrosecond);
BENCHMARK(curve100000Change)->Unit(benchmark::kMicrosecond);
BENCHMARK(contours724)->Unit(benchmark::kMicrosecond);
BENCHMARK(surface724Turning)->Unit(benchmark::kMicrosecond);
BENCHMARK(surface724Whole)->Unit(benchmark::kMicrosecond);
BENCHMARK(vectors724Redraw)->Unit(benchmark::kMicrosecond);
BENCHMARK(valuesScreen)->Unit(benchmark::kMicrosecond);

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
