// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/run_file.h"

#include "core/io/local_file.h"
#include "core/neutral/drive_note.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace axiscomp {

namespace {

constexpr std::string_view firstLine = "// axiscomp runs: 1";
constexpr std::string_view stateKey = "// compensation: ";
constexpr std::string_view tableKey = "// table: ";
constexpr std::string_view referenceKey = "// reference: ";
constexpr std::string_view encoderKey = "// encoder: ";
constexpr std::string_view axisKey = "// axis: ";
constexpr std::string_view feedKey = "// feed: ";
constexpr std::string_view dwellKey = "// dwell: ";
constexpr std::size_t mostRunFileBytes = 64 * 1024 * 1024;

tl::unexpected<Error> cannotWrite(const std::filesystem::path& file, Text reason)
{
    return fail(
        ErrorCode::FileNotWritable, {{"file", file.string()}, {"reason", std::move(reason)}});
}

tl::unexpected<Error> notOurs(const std::filesystem::path& file, Text reason)
{
    return fail(
        ErrorCode::FileNotReadable, {{"file", file.string()}, {"reason", std::move(reason)}});
}

std::string unitOf(const MeasuringPlan& plan)
{
    return plan.isAngular ? "deg" : "mm";
}

std::string feedText(const MeasuringPlan& plan)
{
    return toText(plan.feedPerMinute) + " " + unitOf(plan) + "/min";
}

std::string dwellText(const MeasuringPlan& plan)
{
    return toText(plan.dwellSeconds) + " s";
}

/// What a line with one of these keys must say.
std::array<std::pair<std::string_view, std::string>, 7> statedBy(
    const MeasuringPlan& plan, const RunOrigin& origin)
{
    return {{{axisKey, plan.axis}, {stateKey, origin.state}, {tableKey, origin.tablePlace},
        {referenceKey, origin.reference}, {encoderKey, origin.encoder}, {feedKey, feedText(plan)},
        {dwellKey, dwellText(plan)}}};
}

/// "// drive: Demo-X, serial number 4711"
std::string driveLine(const DriveIdentity& drive)
{
    return "// " + driveNote(driveText(drive.name, drive.serialNumber));
}

/// Whether a line says another serial number than that of the drive.
bool isOfAnotherDrive(std::string_view line, const DriveIdentity& drive)
{
    const auto stated = line.starts_with("//") ? statedIn(line.substr(2), driveKey) : std::nullopt;
    return stated && stated->find(driveSerialKey) != std::string_view::npos
        && driveSerialIn(*stated) != drive.serialNumber;
}

std::string columnLine(const MeasuringPlan& plan)
{
    const std::string unit = " [" + unitOf(plan) + "]";
    return "target" + unit + ",direction,run,deviation" + unit + ",encoder" + unit + ",output"
        + unit + ",time";
}

/// What a step's line begins with.
std::string lineBegin(const MeasuringStep& step)
{
    return planPosition(step.target) + (step.direction == Approach::Up ? ",+," : ",-,")
        + std::to_string(step.run) + ",";
}

std::string decimalText(double value, int decimals)
{
    std::array<char, 400> digits{};
    const auto end = std::to_chars(
        digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals);
    return {digits.data(), end.ptr};
}

/// A tenth of a nanometre is finer than any instrument.
std::string lineOfValue(const CapturedValue& value)
{
    constexpr int decimals = 7;
    constexpr int secondsDecimals = 3;
    return lineBegin(value.step) + decimalText(value.deviation, decimals) + ","
        + decimalText(value.encoder, decimals) + "," + decimalText(value.output, decimals) + ","
        + decimalText(std::chrono::duration<double>(value.time).count(), secondsDecimals) + "\n";
}

/// The value of a step from its line; nothing when this is no whole one.
std::optional<CapturedValue> valueOfLine(std::string_view line, const MeasuringStep& step)
{
    const std::string begin = lineBegin(step);
    if (!line.starts_with(begin))
        return std::nullopt;
    std::vector<Token> cells;
    splitCells({line.substr(begin.size()), 0, 1}, ',', cells);
    std::vector<double> numbers;
    for (const Token& cell : cells)
        if (const auto number = numberOf(cell.text))
            numbers.push_back(*number);
    constexpr std::size_t columns = 4; // deviation, encoder, output, time
    constexpr double latest = 9e9; // s from 1970, in the year 2255: nanoseconds end seven later
    if (cells.size() != columns || numbers.size() != columns || std::abs(numbers[3]) > latest)
        return std::nullopt;
    return CapturedValue{step, numbers[0], numbers[1], numbers[2],
        std::chrono::round<std::chrono::nanoseconds>(std::chrono::duration<double>(numbers[3]))};
}

/// Whether there is a whole line behind the columns, which come last of what begins a file.
bool hasWholeValue(std::string_view content)
{
    std::size_t begin = 0;
    while (content.substr(begin).starts_with("//")) {
        const std::size_t end = content.find('\n', begin);
        if (end == std::string_view::npos)
            return false;
        begin = end + 1;
    }
    const std::size_t columns = content.find('\n', begin);
    return columns != std::string_view::npos
        && content.find('\n', columns + 1) != std::string_view::npos;
}

Result<std::string> contentOf(const std::filesystem::path& file, const system::File& opened)
{
    const auto state = opened.state();
    if (!state || state->kind != system::FileKind::Ordinary)
        return notOurs(file, AXISCOMP_TEXT("Error", "it is not an ordinary file"));
    if (state->size > mostRunFileBytes)
        return fail(ErrorCode::FileTooLarge,
            {{"file", file.string()}, {"size", state->size}, {"limit", mostRunFileBytes}});
    std::string content(static_cast<std::size_t>(state->size), '\0');
    const auto count = opened.readAt(0, std::as_writable_bytes(std::span(content)));
    if (!count || *count < content.size())
        return notOurs(file,
            fileErrorReason(count ? std::make_error_code(std::errc::io_error) : count.error()));
    return content;
}

} // namespace

RunFile::RunFile(std::filesystem::path file, system::File opened)
    : m_file(std::move(file))
    , m_opened(std::move(opened))
{
}

Result<RunFile> RunFile::open(
    const std::filesystem::path& file, const MeasuringPlan& plan, const RunOrigin& origin)
{
    auto opened = system::File::open(file, system::File::Purpose::Change);
    if (!opened)
        return cannotWrite(file, fileErrorReason(opened.error()));
    if (!opened->tryLock().value_or(false))
        return cannotWrite(
            file, AXISCOMP_TEXT("Error", "another program is writing measured values to it"));
    AXISCOMP_TRY(const std::string content, contentOf(file, *opened));
    RunFile made(file, *std::move(opened));
    made.m_reference = origin.reference;
    const std::string_view known = std::string_view(content).substr(0, firstLine.size());
    if (firstLine.substr(0, known.size()) != known)
        return notOurs(file,
            AXISCOMP_TEXT(
                "Error", "it holds something else than captured values; name a new file"));
    // Without a value it may as well be of another plan or instrument.
    if (!hasWholeValue(content))
        AXISCOMP_CHECK(made.begin(plan, origin));
    else
        AXISCOMP_CHECK(made.goOn(content, plan, origin));
    return made;
}

Result<void> RunFile::begin(const MeasuringPlan& plan, const RunOrigin& origin)
{
    const std::string encoder =
        origin.encoder.empty() ? "" : "\n" + std::string(encoderKey) + origin.encoder;
    const std::string table =
        origin.tablePlace.empty() ? "" : std::string(tableKey) + origin.tablePlace + "\n";
    return write(std::string(firstLine) + "\n" + std::string(axisKey) + plan.axis
        + "\n// date: " + origin.date + "\n" + std::string(stateKey) + origin.state + "\n" + table
        + std::string(referenceKey) + origin.reference + encoder
        + (origin.drive ? "\n" + driveLine(*origin.drive) : "") + "\n" + std::string(feedKey)
        + feedText(plan) + "\n" + std::string(dwellKey) + dwellText(plan) + "\n" + columnLine(plan)
        + "\n");
}

Result<void> RunFile::goOn(
    const std::string& content, const MeasuringPlan& plan, const RunOrigin& origin)
{
    const auto isOther = [](std::string_view line, std::string_view key, std::string_view value) {
        return line.starts_with(key) && line.substr(key.size()) != value;
    };
    const auto stated = statedBy(plan, origin);
    bool hasColumns = false;
    std::size_t number = 0;
    while (true) {
        const std::size_t end = content.find('\n', m_size);
        if (end == std::string::npos)
            break;
        const std::string line = content.substr(m_size, end - m_size);
        ++number;
        const auto wrong = [&](const Text& expected) {
            return notOurs(m_file,
                AXISCOMP_TEXT("Error",
                    "line {line} has {found} where {expected} is expected; name a new file")
                    .with("line", number)
                    .with("found", '"' + shownText(line, 60) + '"')
                    .with("expected", expected));
        };
        if (number == 1 && line != firstLine)
            return wrong(Verbatim{std::string(firstLine)});
        for (const auto& [key, value] : stated)
            if (isOther(line, key, value))
                return wrong(Verbatim{std::string(key) + value});
        if (origin.drive && isOfAnotherDrive(line, *origin.drive))
            return wrong(Verbatim{driveLine(*origin.drive)});
        if (!hasColumns && !line.starts_with("//")) {
            if (line != columnLine(plan))
                return wrong(Verbatim{columnLine(plan)});
            hasColumns = true;
        } else if (hasColumns) {
            if (taken() == plan.steps.size())
                return wrong(AXISCOMP_TEXT("Error", "the end"));
            const MeasuringStep& step = plan.steps[taken()];
            const auto value = valueOfLine(line, step);
            if (!value)
                return wrong(AXISCOMP_TEXT("Error", "step {step} of the plan, {begin}...")
                                 .with("step", taken() + 1)
                                 .with("begin", lineBegin(step)));
            m_lineBegins.push_back(m_size);
            m_values.push_back(*value);
        }
        m_size = end + 1;
    }
    if (m_size < content.size())
        if (const auto problem = m_opened.resize(m_size))
            return cannotWrite(m_file, fileErrorReason(problem));
    return {};
}

/// Behind the last whole line; all of it or nothing.
Result<void> RunFile::write(const std::string& text)
{
    std::error_code problem = m_opened.writeAt(m_size, asBytes(text));
    if (!problem)
        problem = m_opened.flush();
    // What was behind it is older than this; and a part of a line is none.
    const std::size_t whole = problem ? m_size : m_size + text.size();
    const std::error_code uncut = m_opened.resize(whole);
    m_mayHaveTail = static_cast<bool>(uncut);
    if (problem || uncut)
        return cannotWrite(m_file, fileErrorReason(problem ? problem : uncut));
    m_size = whole;
    return {};
}

Result<void> RunFile::checkUnchanged() const
{
    const auto named = system::identityOf(m_file);
    const auto state = m_opened.state();
    const bool isThisOne = named && named == m_opened.identity();
    const bool hasItsSize =
        state && (state->size == m_size || (m_mayHaveTail && state->size > m_size));
    if (!isThisOne || !hasItsSize)
        return cannotWrite(m_file,
            AXISCOMP_TEXT("Error",
                "another program has replaced, changed or deleted it since it was opened; look "
                "which values it has before you go on with it"));
    return {};
}

Result<void> RunFile::append(const CapturedValue& value)
{
    AXISCOMP_CHECK(checkUnchanged());
    const std::size_t begin = m_size;
    AXISCOMP_CHECK(write(lineOfValue(value)));
    m_lineBegins.push_back(begin);
    m_values.push_back(value);
    return {};
}

/// One cut at the end of a whole line: whenever it is interrupted the line is there or not.
Result<void> RunFile::removeLast()
{
    AXISCOMP_CHECK(checkUnchanged());
    const std::size_t begin = m_lineBegins.back();
    if (const auto uncut = m_opened.resize(begin))
        return cannotWrite(m_file, fileErrorReason(uncut));
    const std::error_code problem = m_opened.flush();
    // The next line comes where this one was, whether the disk has heard of it or not.
    m_size = begin;
    m_lineBegins.pop_back();
    m_values.pop_back();
    if (problem)
        return cannotWrite(m_file, fileErrorReason(problem));
    return {};
}

} // namespace axiscomp
