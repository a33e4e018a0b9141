// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes the largest calibration file that a drive can take, and files of other sizes.
// bench_csv
// --sample FILE [random | scattered] writes such a file for other programs; AXISCOMP_BENCH_CSV
// names one to be read instead. threads:0 is one on each processor.
#include "core/csv/calibration_csv.h"
#include "core/io/local_file.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <random>

#include <malloc.h>
#include <unistd.h>

namespace {

using namespace axiscomp;

constexpr int dimensions = 3;
using Sizes = std::array<int, dimensions>;
constexpr Sizes largest{80, 80, 81};

/// Scattered: no position twice.
enum class Order { Grid, Random, Scattered };

void append(std::string& text, double value)
{
    std::array<char, 32> buffer{};
    text.append(
        buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
}

void append(std::string& text, double value, int decimals)
{
    std::array<char, 32> buffer{};
    const auto written = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    text.append(buffer.data(), written.ptr);
}

constexpr const char* head = "// grid plate, 20 degrees\nX [mm],Y [mm],Z [mm],Table 1 [mm]\n";

/// 518 400 lines of 4 columns, 14.7 MB: positions as short as they are, values with 9 decimals.
std::string gridText(const Sizes& sizes)
{
    std::mt19937 random(1); // NOLINT: the same file every time
    std::normal_distribution<double> noise;
    std::string text = head;
    for (int z = 0; z < sizes[2]; ++z)
        for (int y = 0; y < sizes[1]; ++y)
            for (int x = 0; x < sizes[0]; ++x) {
                for (const int index : {x, y, z}) {
                    append(text, -50.0 + 1.25 * index);
                    text += ',';
                }
                append(text, 0.002 * noise(random), 9);
                text += '\n';
            }
    return text;
}

std::string scatteredText()
{
    std::mt19937 random(2); // NOLINT
    std::uniform_real_distribution<double> place(-50.0, 50.0);
    std::string text = head;
    for (int line = 0; line < largest[0] * largest[1] * largest[2]; ++line) {
        for (int d = 0; d < dimensions; ++d) {
            append(text, place(random), 6);
            text += ',';
        }
        append(text, 1e-5 * place(random), 9);
        text += '\n';
    }
    return text;
}

std::string shuffledText()
{
    const std::string text = gridText(largest);
    std::vector<std::string_view> lines;
    for (std::size_t begin = std::strlen(head); begin < text.size();) {
        const std::size_t end = text.find('\n', begin) + 1;
        lines.push_back(std::string_view(text).substr(begin, end - begin));
        begin = end;
    }
    std::mt19937 random(3); // NOLINT
    std::ranges::shuffle(lines, random);
    std::string shuffled = head;
    for (const std::string_view line : lines)
        shuffled += line;
    return shuffled;
}

std::string sample(Order order = Order::Grid)
{
    return order == Order::Grid  ? gridText(largest)
        : order == Order::Random ? shuffledText()
                                 : scatteredText();
}

/// A file that is gone with the process.
class SampleFile {
public:
    SampleFile()
    {
        if (const char* given = std::getenv("AXISCOMP_BENCH_CSV")) {
            m_path = given;
            return;
        }
        m_path = std::filesystem::temp_directory_path()
            / ("axiscomp-bench-" + std::to_string(::getpid()) + ".csv");
        m_own = saveFile(m_path, asBytes(sample())).has_value();
    }
    SampleFile(const SampleFile&) = delete;
    SampleFile& operator=(const SampleFile&) = delete;
    ~SampleFile()
    {
        std::error_code ignored;
        if (m_own)
            std::filesystem::remove(m_path, ignored);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    std::filesystem::path m_path;
    bool m_own = false;
};

const std::filesystem::path& sampleFile()
{
    static const SampleFile file;
    return file.path();
}

CsvOptions options(std::int64_t threads)
{
    CsvOptions result;
    result.dimensions = dimensions;
    result.threads = static_cast<std::size_t>(threads);
    return result;
}

/// A line of /proc/self/status in bytes.
double processMemory(const std::string& key)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(key + ':'))
            return 1024.0 * std::strtod(line.c_str() + key.size() + 1, nullptr);
    return 0.0;
}

/// What reading the file takes at its peak, in file sizes.
double peakMemoryRatio(std::size_t fileSize)
{
    ::malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5"; // sets the peak back
    const double before = processMemory("VmRSS");
    const CsvReading reading = readCalibrationCsv(sampleFile(), options(0));
    benchmark::DoNotOptimize(reading.data);
    return (processMemory("VmHWM") - before) / static_cast<double>(fileSize);
}

void fileToTable(benchmark::State& state)
{
    const auto size = static_cast<std::size_t>(std::filesystem::file_size(sampleFile()));
    for (auto _ : state) {
        const CsvReading reading = readCalibrationCsv(sampleFile(), options(state.range(0)));
        if (!reading.data)
            return state.SkipWithError("the file was not read");
        benchmark::DoNotOptimize(reading.data->tables.front().values.data());
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * size));
    state.counters["peak_memory_per_file_size"] = peakMemoryRatio(size);
}

void textToTable(benchmark::State& state, const std::string& text)
{
    for (auto _ : state) {
        const CsvReading reading = parseCalibrationCsv(text, options(state.range(0)));
        benchmark::DoNotOptimize(reading.data.has_value());
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}

void randomOrder(benchmark::State& state)
{
    textToTable(state, sample(Order::Random));
}

/// No grid: is refused, and must not take long about it.
void scatteredPositions(benchmark::State& state)
{
    textToTable(state, sample(Order::Scattered));
}

void writeText(benchmark::State& state)
{
    const CsvReading reading = parseCalibrationCsv(sample(), options(0));
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes +=
            writeCalibrationCsv(*reading.data, static_cast<std::size_t>(state.range(0))).size();
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
}

/// From about `range` cells, four in a line: how the time grows with them.
void growth(benchmark::State& state)
{
    const double lines = static_cast<double>(state.range(0)) / (dimensions + 1);
    const int edge = std::max(2, static_cast<int>(std::lround(std::cbrt(lines))));
    const std::string text = gridText({edge, edge, edge});
    CsvOptions all = options(0);
    all.maximumCells = std::numeric_limits<std::size_t>::max();
    for (auto _ : state) {
        const CsvReading reading = parseCalibrationCsv(text, all);
        if (!reading.data)
            return state.SkipWithError("the text was not read");
        benchmark::DoNotOptimize(reading.data->tables.front().values.data());
    }
    state.counters["cells"] = std::pow(edge, dimensions) * (dimensions + 1);
}

void oneAndAll(benchmark::internal::Benchmark* benchmark)
{
    benchmark->Unit(benchmark::kMillisecond)->UseRealTime()->ArgName("threads")->Arg(1)->Arg(0);
}

BENCHMARK(fileToTable)->Apply(oneAndAll);
BENCHMARK(randomOrder)->Apply(oneAndAll);
BENCHMARK(scatteredPositions)->Apply(oneAndAll);
BENCHMARK(writeText)->Apply(oneAndAll);
BENCHMARK(growth)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->ArgName("cells")
    ->RangeMultiplier(10)
    ->Range(1'000, 64'000'000)
    ->Iterations(3);

/// As on the command line.
bool saveSample(const char* file, std::string_view order)
{
    const std::string text = sample(order == "random" ? Order::Random
            : order == "scattered"                    ? Order::Scattered
                                                      : Order::Grid);
    return saveFile(file, asBytes(text)).has_value();
}

} // namespace

int main(int argc, char** argv)
{
    if (argc >= 3 && std::strcmp(argv[1], "--sample") == 0)
        return saveSample(argv[2], argc > 3 ? argv[3] : "") ? EXIT_SUCCESS : EXIT_FAILURE;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return EXIT_FAILURE;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return EXIT_SUCCESS;
}
