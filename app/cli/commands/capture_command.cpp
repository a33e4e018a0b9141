// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/table_input.h"
#include "app/cli/session/command_session.h"
#include "app/common/arguments.h"
#include "app/common/number_checks.h"
#include "app/common/number_text.h"
#include "app/common/standard_streams.h"
#include "core/capture/capture_request.h"
#include "core/io/local_file.h"
#include "core/metrology/fine_quantity.h"
#include "drivecomm/capture/number_pattern.h"
#include "drivecomm/capture/serial_instrument.h"

namespace axiscomp::app {

namespace {

struct CaptureOptions {
    DriveOptions drive;
    std::string plan;
    std::string reference;
    std::string encoder; ///< register; empty: the profile's
    std::string pattern;
    std::string request;
    std::string output;
    ReferenceScale scale;
    double window = 0.001; ///< in mm or deg
    double dwellSeconds = 1.0;
    int readings = 10;
    double rateHz = 20.0;
};

constexpr std::string_view typedReference = "typed";

using ReferenceKind = CaptureReference::Kind;

ReferenceKind kindOf(const std::string& reference)
{
    if (reference == typedReference)
        return ReferenceKind::Typed;
    if (reference == standardStream)
        return standardInputIsTerminal() ? ReferenceKind::Typed : ReferenceKind::Lines;
    return reference.starts_with("serial:") ? ReferenceKind::Serial : ReferenceKind::Register;
}

CaptureRules rulesOf(const CaptureOptions& options)
{
    return {options.window,
        std::chrono::duration_cast<std::chrono::nanoseconds>(
            std::chrono::duration<double>(options.dwellSeconds)),
        options.readings};
}

/// One capture: what it works with, and what it tells.
class Capture {
public:
    Capture(Environment& environment, CommandSession& session, CaptureOptions& options)
        : m_environment(environment)
        , m_session(session)
        , m_options(options)
        , m_kind(kindOf(options.reference))
    {
    }

    /// Opens the instrument and the file, and says what is read.
    [[nodiscard]] Result<void> begin(int axis, const MeasuringPlan& plan);
    [[nodiscard]] Result<void> follow();
    [[nodiscard]] const CaptureRun& run() const { return *m_run; }

private:
    [[nodiscard]] Result<Instrument> openInstrument(bool isAngular);
    void sayWhatIsRead();
    [[nodiscard]] const MeasuringPlan& plan() const { return m_run->plan(); }
    [[nodiscard]] std::string unit() const { return plan().isAngular ? "deg" : "mm"; }
    [[nodiscard]] Result<void> readOnce();
    [[nodiscard]] Result<void> waitUntil(std::chrono::steady_clock::time_point moment);
    void takeInput(const std::string& text);
    void takeTyped(std::string_view line);
    void ask();
    void showValue();
    void hintAtZero(const CapturedValue& value);
    [[nodiscard]] Result<void> show(const CaptureNews& news);
    [[nodiscard]] std::string dueText() const;

    Environment& m_environment;
    CommandSession& m_session;
    CaptureOptions& m_options;
    ReferenceKind m_kind;
    std::optional<CaptureRun> m_run;
    std::optional<CaptureClock> m_clock;
    std::optional<ReferenceLines> m_lines;
    std::string m_typedLine; ///< that has not ended
    bool m_isDone = false;
};

Result<Instrument> Capture::openInstrument(bool isAngular)
{
    const auto dwell = rulesOf(m_options).dwell;
    if (m_kind == ReferenceKind::Serial)
        return drivecomm::openSerialInstrument(
            {m_options.reference, m_options.request, m_options.pattern}, m_options.scale, isAngular,
            dwell);
    AXISCOMP_TRY(auto finder, drivecomm::numberPattern(m_options.pattern));
    AXISCOMP_TRY(
        auto reader, ReferenceLineReader::make(m_options.scale, isAngular, std::move(finder)));
    m_lines.emplace(std::move(reader), dwell);
    return Instrument([this](std::chrono::nanoseconds time) { return m_lines->at(time); });
}

Result<void> Capture::begin(int axis, const MeasuringPlan& plan)
{
    CaptureRequest request;
    request.plan = plan;
    request.file = pathFromText(m_options.output);
    request.reference = {m_kind, m_options.reference, m_options.scale, m_options.pattern};
    request.encoder = m_options.encoder;
    request.rules = rulesOf(m_options);
    request.openInstrument = [this, isAngular = plan.isAngular] {
        return openInstrument(isAngular);
    };
    AXISCOMP_TRY(request.finder, drivecomm::numberPattern(m_options.pattern));
    AXISCOMP_TRY(m_run, m_session.compensator().beginCapture(axis, request, m_session.operation()));
    m_environment.console().clearProgress();
    sayWhatIsRead();
    m_clock.emplace(m_run->values(), std::chrono::system_clock::now().time_since_epoch());
    if (m_clock->isBehind())
        m_environment.warn("the clock of this computer is behind the last value of the file: "
                           "times go on from there");
    return {};
}

void Capture::sayWhatIsRead()
{
    if (m_run->readings().isUnitAssumed())
        m_environment.warn("the drive does not say the unit of the axis: it is taken to be that "
                           "of the plan");
    if (const auto resolution = farthestResolution(m_run->readings(), plan())) {
        const Quantity step = fineQuantity(resolution->step, plan().isAngular);
        m_environment.console().note(m_run->readings().referenceRegister() + " is a Single: at "
            + planPosition(resolution->target) + (plan().isAngular ? " deg" : " mm")
            + " its numbers are " + step.digits + " " + step.unit + " apart");
    }
}

std::string Capture::dueText() const
{
    const MeasuringStep& due = plan().steps[m_run->taken()];
    return "step " + std::to_string(due.step) + " is due: " + planPosition(due.target) + " "
        + unit() + (due.direction == Approach::Up ? ", upwards from " : ", downwards from ")
        + planPosition(due.approach) + " " + unit();
}

void Capture::showValue()
{
    const CapturedValue& value = m_run->value();
    const Quantity deviation = fineQuantity(value.deviation, plan().isAngular);
    m_environment.print(std::to_string(value.step.step) + "/" + std::to_string(plan().steps.size())
        + "  " + planPosition(value.step.target) + " " + unit() + " "
        + std::string(approachName(value.step.direction)) + ", run "
        + std::to_string(value.step.run) + ": " + signedText(deviation.digits) + " "
        + deviation.unit + "\n");
    if (value.step.step == 1)
        hintAtZero(value);
}

void Capture::hintAtZero(const CapturedValue& value)
{
    const auto zero = proposedZero(value, plan(), m_options.scale);
    if (!zero)
        return;
    m_environment.console().note("the instrument is far from the axis, as if it said 0 at "
        + planPosition(*zero) + " " + unit()
        + ": if that is right, begin a new file with --zero-at " + planPosition(*zero));
}

void Capture::ask()
{
    const MeasuringStep& due = plan().steps[m_run->taken()];
    m_environment.console().note(planPosition(due.target) + " " + unit() + " "
        + std::string(approachName(due.direction)) + ": what does the instrument say, in "
        + (m_options.scale.unit.empty() ? unit() : m_options.scale.unit) + "?");
}

void Capture::takeTyped(std::string_view line)
{
    if (line.find_first_not_of(" \t\r") == std::string_view::npos)
        return;
    const Text problem = m_run->type(line);
    if (!problem.isEmpty())
        m_environment.console().note(problem.english());
}

void Capture::takeInput(const std::string& text)
{
    if (m_lines) {
        m_lines->feed(text, m_clock->now());
        return;
    }
    m_typedLine += text;
    for (std::size_t end = m_typedLine.find('\n'); end != std::string::npos;
         end = m_typedLine.find('\n')) {
        takeTyped(std::string_view(m_typedLine).substr(0, end));
        m_typedLine.erase(0, end + 1);
    }
    if (m_typedLine.size() > ReferenceLines::longestLine)
        m_typedLine.clear();
}

/// Meanwhile what comes on standard input is taken, and at the end what waits there: of a program
/// that writes faster than it is read no more than a pipe holds, behind which its lines are new.
Result<void> Capture::waitUntil(std::chrono::steady_clock::time_point moment)
{
    constexpr std::size_t largestPipe = std::size_t{1} << 20U;
    std::size_t late = 0; // bytes
    const bool reads = m_kind == ReferenceKind::Lines || m_kind == ReferenceKind::Typed;
    InputStream standardInput = InputStream::standardInput();
    while (true) {
        std::string text;
        AXISCOMP_TRY(const auto input,
            standardInput.waitForInput(m_environment.interrupt(), reads, moment, text));
        if (input == Input::None)
            return {};
        if (input == Input::Ended)
            return fail(ErrorCode::FileNotReadable,
                {{"file", Verbatim{"standard input"}},
                    {"reason",
                        Verbatim{
                            "it has ended, and the plan has values that are not taken; the program "
                            "that writes to it must go on for as long as is measured"}}});
        takeInput(text);
        if (std::chrono::steady_clock::now() >= moment)
            late += text.size();
        if (late >= largestPipe)
            return {};
    }
}

Result<void> Capture::show(const CaptureNews& news)
{
    Console& console = m_environment.console();
    if (news.isBack)
        console.note("the drive answers again");
    switch (news.kind) {
    case CaptureNews::Kind::Lost:
        console.note(news.text.english() + "; waiting for it, Ctrl-C ends");
        return {};
    case CaptureNews::Kind::Refused:
        console.note(news.text.english());
        return {};
    case CaptureNews::Kind::NoReference:
        if (m_kind == ReferenceKind::Typed)
            ask();
        else
            console.note(dueText() + ": " + news.text.english());
        return {};
    case CaptureNews::Kind::Stopped:
        return fail(ErrorCode::MeasurementState, {{"reason", news.text}});
    case CaptureNews::Kind::Done:
        m_isDone = true;
        return {};
    case CaptureNews::Kind::Taken:
    case CaptureNews::Kind::Moving:
    case CaptureNews::Kind::Nothing:
        break;
    }
    return {};
}

Result<void> Capture::readOnce()
{
    const std::size_t before = m_run->taken();
    AXISCOMP_TRY(const auto news,
        m_session.compensator().readCapture(
            *m_run, [this] { return m_clock->now(); }, m_session.quietOperation()));
    if (m_run->taken() > before)
        showValue();
    AXISCOMP_CHECK(show(news));
    return m_environment.console().flush();
}

Result<void> Capture::follow()
{
    if (m_run->taken() == plan().steps.size())
        return {};
    m_environment.print(dueText() + "\n");
    const auto period = std::chrono::duration_cast<std::chrono::nanoseconds>(
        std::chrono::duration<double>(1.0 / m_options.rateHz));
    constexpr std::chrono::seconds retry(1);
    auto due = std::chrono::steady_clock::now();
    while (!m_isDone) {
        AXISCOMP_CHECK(readOnce());
        // A drive that is slower than the rate sets the pace; nothing is made up for.
        due = std::max(due + period, std::chrono::steady_clock::now());
        if (m_run->isLost())
            due = std::chrono::steady_clock::now() + retry;
        if (!m_isDone)
            AXISCOMP_CHECK(waitUntil(due));
    }
    return {};
}

Result<MeasuringPlan> readPlan(const CaptureOptions& options)
{
    AXISCOMP_TRY(const auto bytes, loadFile(pathFromText(options.plan), mostPlanBytes));
    return readMeasuringPlan(asText(bytes), displayName(options.plan));
}

Result<void> checkUsage(const CaptureOptions& options, ReferenceKind kind)
{
    const std::string& command = options.drive.command;
    if (kind == ReferenceKind::Register && !options.pattern.empty())
        return wrongUsage("--pattern is for lines of text, and a register has none", command);
    if (kind != ReferenceKind::Serial && !options.request.empty())
        return wrongUsage("--request is for an instrument on a serial port", command);
    if (options.output == standardStream)
        return wrongUsage(
            "the values are kept in a file, so that nothing is lost: name it with -o", command);
    return {};
}

Result<ExitCode> runCapture(
    Environment& environment, CommandSession& session, int axis, CaptureOptions& options)
{
    const ReferenceKind kind = kindOf(options.reference);
    AXISCOMP_CHECK(checkUsage(options, kind));
    AXISCOMP_TRY(const auto plan, readPlan(options));
    Capture capture(environment, session, options);
    AXISCOMP_CHECK(capture.begin(axis, plan));
    const CaptureRun& run = capture.run();
    const std::size_t before = run.taken();
    const std::string& state = run.readings().state();
    environment.print("axis " + plan.axis + " of " + run.drive().name + ", compensation " + state
        + ", " + std::to_string(before) + " of " + plural(plan.steps.size(), "value", "values")
        + " taken; the program moves no axis\n");
    const auto followed = capture.follow();
    const std::string count = std::to_string(run.taken()) + " of "
        + plural(plan.steps.size(), "value", "values") + " in " + options.output;
    if (!followed) {
        // What stopped because of the drive's state says itself that a new file is needed.
        const bool goesOn = followed.error().code != ErrorCode::MeasurementState;
        environment.console().note(
            count + (goesOn ? "; the same command goes on behind them" : ""));
        return fail(followed.error());
    }
    environment.print(count + "\n");
    environment.document(
        {{"output", options.output}, {"axis", plan.axis}, {"unit", plan.isAngular ? "deg" : "mm"},
            {"compensation", state}, {"reference", run.reference()}, {"steps", plan.steps.size()},
            {"before", before}, {"taken", run.taken()}});
    return ExitCode::Done;
}

void addInstrumentOptions(CLI::App& command, CaptureOptions& options)
{
    command
        .add_option("--reference", options.reference,
            AXISCOMP_HELP("Help",
                "Where the axis really is: a register of the drive, serial:/dev/ttyUSB1?baud=9600, "
                "- for lines on standard input, or typed"))
        ->option_text("REF (required)")
        ->required();
    command
        .add_option("--unit", options.scale.unit,
            AXISCOMP_HELP("Help",
                "Unit of the instrument; of a register it is that of the axis, of lines the one "
                "behind "
                "the number unless given"))
        ->option_text("UNIT");
    command.add_flag("--invert-reference", options.scale.isInverted,
        AXISCOMP_HELP("Help", "The instrument counts the other way"));
    command
        .add_option("--zero-at", options.scale.zeroAt,
            AXISCOMP_HELP(
                "Help", "Position of the axis where the instrument says 0 (0 unless given)"))
        ->option_text("P");
    command
        .add_option("--pattern", options.pattern,
            AXISCOMP_HELP("Help",
                "Regular expression for the number in a line, its first group or all of it; the "
                "first "
                "number of the line unless given"))
        ->option_text("REGEX");
    command
        .add_option("--request", options.request,
            AXISCOMP_HELP("Help",
                "Send this to the serial instrument before each reading, with \\r and \\n for line "
                "ends"))
        ->option_text("TEXT");
}

void addRuleOptions(CLI::App& command, CaptureOptions& options)
{
    using Seconds = std::chrono::duration<double>;
    command
        .add_option("--encoder", options.encoder,
            AXISCOMP_HELP("Help", "Register of the raw position; the profile's unless given"))
        ->option_text("REG");
    command
        .add_option("--window", options.window,
            AXISCOMP_HELP("Help",
                "The axis stands while its encoder stays within so many mm or deg, and readings "
                "may "
                "differ by as much (0.001 unless given)"))
        ->option_text("W")
        ->check(numberBetween(CaptureRules::smallestWindow, CaptureRules::largestWindow));
    command
        .add_option("--dwell", options.dwellSeconds,
            AXISCOMP_HELP("Help", "So many seconds, before anything is taken (1 unless given)"))
        ->option_text("S")
        ->check(numberBetween(Seconds(CaptureRules::shortestDwell).count(),
            Seconds(CaptureRules::longestDwell).count()));
    command
        .add_option("--average", options.readings,
            AXISCOMP_HELP("Help", "Readings that make a value (10 unless given)"))
        ->option_text("N")
        ->check(CLI::Range(1, CaptureRules::mostReadings));
    command
        .add_option("--rate", options.rateHz,
            AXISCOMP_HELP("Help", "Readings per second, 10 to 50 (20 unless given)"))
        ->option_text("HZ")
        ->check(numberBetween(10.0, 50.0));
}

/// One below the other, as they are typed.
constexpr const char* captureExamples =
    "\n  axiscomp capture --axis X --plan plan.csv -o runs.csv \\"
    "\n      --reference 'Machine/Axes[0]/ReferencePosition'"
    "\n  axiscomp capture --axis X --plan plan.csv -o runs.csv \\"
    "\n      --reference 'serial:/dev/ttyUSB1?baud=9600'"
    "\n  laser-reader | axiscomp capture --axis X --plan plan.csv -o runs.csv --reference -";

} // namespace

void addCaptureCommand(CommandLine& line)
{
    auto options = std::make_shared<CaptureOptions>();
    options->drive.command = commandName("capture");
    CLI::App* command = line.add("capture", driveCommands,
        AXISCOMP_HELP(
            "Help", "Take the values of a measuring plan while something else moves the axis"),
        [options](Environment& environment) {
            return withAxis(environment, options->drive,
                [options](Environment& inside, CommandSession& session, int axis) {
                    return runCapture(inside, session, axis, *options);
                });
        });
    addDriveOptions(*command, options->drive);
    addAxisOption(*command, options->drive);
    command
        ->add_option(
            "--plan", options->plan, AXISCOMP_HELP("Help", "Plan as axiscomp targets writes it"))
        ->option_text("FILE (required)")
        ->required();
    command
        ->add_option("-o,--output", options->output,
            AXISCOMP_HELP("Help", "File of the values; one that is there goes on where it ends"))
        ->option_text("FILE (required)")
        ->required();
    addInstrumentOptions(*command, *options);
    addRuleOptions(*command, *options);
    command->footer(std::string(AXISCOMP_HELP("Help",
                        "axiscomp never moves an axis: the machine's control or a person does."))
        + "\n\n" + AXISCOMP_HELP("Help", "Examples:") + captureExamples);
}

} // namespace axiscomp::app
