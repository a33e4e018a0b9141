// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the largest calibration file that a drive can take. bench_csv --sample FILE writes that
// file for tests/bench/pandas_csv.py; AXISCOMP_BENCH_CSV names an existing one to be read instead.
#include "core/csv/calibration_csv.h"
#include "core/io/local_file.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>

#include <malloc.h>
#include <unistd.h>

namespace {

using namespace axiscomp;

constexpr int dimensions = 3;
constexpr std::array<int, dimensions> sizes{80, 80, 81};

enum class Order { Grid, Random };
enum class Positions { Even, Scattered };

void appendFixed(std::string& text, double value, int decimals)
{
    std::array<char, 32> buffer{};
    const auto written = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    text.append(buffer.data(), written.ptr);
}

/// 518 400 lines of 4 columns, about 20 MB.
std::string sample(Order order = Order::Grid, Positions positions = Positions::Even)
{
    std::mt19937 random(1); // NOLINT: the same file every time
    std::normal_distribution<double> noise;
    std::vector<std::string> lines;
    for (int z = 0; z < sizes[2]; ++z)
        for (int y = 0; y < sizes[1]; ++y)
            for (int x = 0; x < sizes[0]; ++x) {
                std::string& line = lines.emplace_back();
                for (const int index : {x, y, z}) {
                    const double scatter = positions == Positions::Even ? 0.0 : 1e-3;
                    appendFixed(line, -50.0 + 1.25 * index + scatter * noise(random), 5);
                    line += ',';
                }
                appendFixed(line, 0.002 * noise(random), 8);
            }
    if (order == Order::Random)
        std::ranges::shuffle(lines, random);
    std::string text = "// grid plate, 20 degrees\nX [mm],Y [mm],Z [mm],Table 1 [mm]\n";
    for (const std::string& line : lines)
        text.append(line).append(1, '\n');
    return text;
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

CsvOptions options()
{
    CsvOptions result;
    result.dimensions = dimensions;
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
    const CsvReading reading = readCalibrationCsv(sampleFile(), options());
    benchmark::DoNotOptimize(reading.data);
    return (processMemory("VmHWM") - before) / static_cast<double>(fileSize);
}

void fileToTable(benchmark::State& state)
{
    const auto size = static_cast<std::size_t>(std::filesystem::file_size(sampleFile()));
    for (auto _ : state) {
        const CsvReading reading = readCalibrationCsv(sampleFile(), options());
        if (!reading.data)
            return state.SkipWithError("the file was not read");
        benchmark::DoNotOptimize(reading.data->tables.front().values.data());
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * size));
    state.counters["peak_memory_per_file_size"] = peakMemoryRatio(size);
}

void textToTable(benchmark::State& state, const std::string& text)
{
    bool read = false;
    for (auto _ : state) {
        const CsvReading reading = parseCalibrationCsv(text, options());
        read = reading.data.has_value();
        benchmark::DoNotOptimize(read);
    }
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}

void gridOrder(benchmark::State& state)
{
    textToTable(state, sample());
}

void randomOrder(benchmark::State& state)
{
    textToTable(state, sample(Order::Random));
}

/// No grid: every position is another one. Is refused, and must not take long about it.
void scatteredPositions(benchmark::State& state)
{
    textToTable(state, sample(Order::Grid, Positions::Scattered));
}

void writeText(benchmark::State& state)
{
    const CsvReading reading = parseCalibrationCsv(sample(), options());
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes += writeCalibrationCsv(*reading.data).size();
    state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
}

BENCHMARK(fileToTable)->Unit(benchmark::kMillisecond);
BENCHMARK(gridOrder)->Unit(benchmark::kMillisecond);
BENCHMARK(randomOrder)->Unit(benchmark::kMillisecond);
BENCHMARK(scatteredPositions)->Unit(benchmark::kMillisecond);
BENCHMARK(writeText)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv)
{
    if (argc == 3 && std::strcmp(argv[1], "--sample") == 0)
        return saveFile(argv[2], asBytes(sample())) ? EXIT_SUCCESS : EXIT_FAILURE;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return EXIT_FAILURE;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return EXIT_SUCCESS;
}
