// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/loop/machine_loop.h"

#include "core/capture/capture_run.h"
#include "core/compensator/axis_compensator.h"
#include "core/io/local_file.h"
#include "core/metrology/formats/measurement_format.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/machine/machine_file.h"
#include "drivecomm/virtualdrive/machine/program_motion.h"

#include <atomic>

namespace axiscomp::test {

namespace {

using namespace drivecomm;
using namespace std::chrono_literals;

constexpr double lead = 10.0; // mm
constexpr auto beginning = 1h; // of the program, after everything that comes before it
const std::string screw = R"({"seed": SEED, "axes": {"X": {"slope": 12e-6, "waves": [
    {"period": 430, "amplitude": 0.003, "phase": 0.7}, {"period": 97, "amplitude": 0.0012},
    {"period": 10, "amplitude": 0.0008, "phase": 0.3}],
    "reversal": 0.0024, "reversalWidth": 0.01, "noise": {"approach": 0.0001, "reading": 0.00002}}},
    "instrument": {"axis": "X"}})";
const std::string encoder = "Axes[0]/Signals/PositionController/MasterPosition";
const std::string reference = "Machine/Axes[0]/ReferencePosition";

MachineDescription machineOf(std::uint64_t seed)
{
    std::string text = screw;
    text.replace(text.find("SEED"), 4, std::to_string(seed));
    return parseMachine(text, "screw").value();
}

MeasuringPlan planOf(std::uint64_t seed, const MachineLoop::Size& size)
{
    MeasuringPlanRequest request;
    request.to = 500.0;
    request.count = size.targets;
    request.cycles = size.cycles;
    request.period = lead;
    request.seed = seed;
    request.overrun = 5.0;
    request.dwellSeconds = 3.0;
    return makeMeasuringPlan(request).value();
}

/// The drive, switched on, whose control begins the plan after an hour. Until then time passes with
/// each request.
struct Session {
    Session(const AttachmentKind& kind, MachineDescription machine, MeasuringPlan wanted,
        const std::filesystem::path& folder)
        : plan(std::move(wanted))
        , drive(genericProfile(), options(std::move(machine)))
        , attachment(kind.attach(drive, faults))
        , link(attachment->link())
        , store(folder / "axiscomp")
        , compensator(link, genericProfile(), store)
    {
    }

    VirtualDriveOptions options(MachineDescription machine)
    {
        VirtualDriveOptions options;
        options.machine = std::move(machine);
        options.program = plan;
        options.programStart = beginning;
        options.clock = [this] {
            return std::chrono::nanoseconds(
                std::chrono::milliseconds(isPassing ? ++milliseconds : milliseconds.load()));
        };
        return options;
    }

    [[nodiscard]] Result<void> use(const CompensationTable& table)
    {
        WriteRequest request;
        request.sources = {encoder};
        request.table = table;
        AXISCOMP_CHECK(compensator.write(0, request));
        AXISCOMP_TRY(const auto activation, compensator.switchTo(0, Switch::Activate));
        if (!activation.proof)
            return fail(ErrorCode::ProofFailed);
        if (!*activation.proof)
            return fail(activation.proof->error());
        return {};
    }

    std::atomic<std::int64_t> milliseconds = 0;
    std::atomic<bool> isPassing = true;
    MeasuringPlan plan;
    FaultPlan faults;
    VirtualDrive drive;
    std::unique_ptr<LinkAttachment> attachment;
    DriveLink& link;
    DriveStore store;
    AxisCompensator compensator;
};

/// Readings a tenth of a second apart: enough to see the axis turn beyond the last target, and for
/// a value in a standstill of three seconds.
Result<void> capture(
    Session& session, const MachineLoop::Fault& fault, const std::filesystem::path& file)
{
    AXISCOMP_TRY(const auto status, session.compensator.status(0));
    ReferenceScale scale;
    scale.isInverted = fault.isInstrumentInverted;
    AXISCOMP_TRY(auto readings,
        AxisReadings::open(
            session.link, genericProfile(), status, session.plan, {encoder, reference}, scale, {}));
    AXISCOMP_TRY(
        auto values, RunFile::open(file, session.plan, {readings.state(), "laser", "now"}));
    CaptureRun run(std::move(readings), std::move(values), session.plan, {},
        session.compensator.identify().value());
    session.isPassing = false;
    session.milliseconds = std::chrono::milliseconds(beginning).count() - 500;
    const double seconds =
        ProgramMotion(session.plan, session.plan.steps.front().approach).endSeconds() + 60.0;
    for (int n = 0; n < static_cast<int>(10.0 * seconds); ++n) {
        session.milliseconds += 100;
        if (fault.isSwitchedOff && run.taken() == 100) {
            session.isPassing = true;
            AXISCOMP_CHECK(session.compensator.deactivate(0));
            session.isPassing = false;
        }
        AXISCOMP_TRY(const auto news,
            run.read(session.link,
                [&] {
                    return std::chrono::nanoseconds(
                        std::chrono::milliseconds(session.milliseconds.load()));
                },
                {}));
        if (news.kind == CaptureNews::Kind::Done)
            return {};
        if (news.kind == CaptureNews::Kind::Stopped || news.kind == CaptureNews::Kind::Refused)
            return fail(ErrorCode::MeasurementState, {{"reason", news.text}});
    }
    return fail(ErrorCode::MeasurementState,
        {{"reason",
            Verbatim{"the program ended after " + std::to_string(run.taken()) + " values"}}});
}

Result<Measurement> measurementIn(const std::filesystem::path& file)
{
    AXISCOMP_TRY(const auto bytes, loadFile(file, 10'000'000));
    AXISCOMP_TRY(const auto* const format, chooseMeasurementFormat(asText(bytes), "runs.csv", {}));
    auto reading = format->read(asText(bytes), {});
    if (!reading.measurement)
        return fail(measurementError("runs.csv", reading));
    return *std::move(reading.measurement);
}

} // namespace

Result<Measurement> MachineLoop::measure(
    const std::optional<CompensationTable>& table, const Fault& fault)
{
    ++m_measurements;
    Session session(m_kind, machineOf(m_seed * 10 + m_measurements),
        planOf(m_seed * 10 + m_measurements, m_size), m_folder.path().toStdString());
    if (table)
        AXISCOMP_CHECK(session.use(*table));
    const std::filesystem::path file =
        m_folder.filePath(QStringLiteral("runs%1.csv").arg(m_measurements)).toStdString();
    AXISCOMP_CHECK(capture(session, fault, file));
    return measurementIn(file);
}

FitSettings MachineLoop::linear()
{
    FitSettings settings;
    settings.lookupAt = LookupAt::Encoder;
    settings.grid = {{.distance = 10.0}};
    settings.holdsEnds = true;
    return settings;
}

FitSettings MachineLoop::smooth()
{
    FitSettings settings = linear();
    settings.method = FitMethod::Smooth;
    settings.periods = {{lead}, 1};
    settings.grid = {{.distance = 0.5}};
    return settings;
}

Result<FitReport> MachineLoop::fit(const Measurement& measurement, const FitSettings& settings,
    const std::optional<CompensationTable>& onto)
{
    KnownTables active;
    StateRequest request;
    request.onFile = measurement.header.compensation;
    request.hasRawReadings = hasRawReadings(measurement);
    if (onto) {
        active = {Verbatim{"the table before"}, {*onto}, {tableCrc(*onto)}};
        request.onto = &active;
    }
    AXISCOMP_TRY(const auto state, findState(request));
    auto report = fitMeasurement(measurement, settings, state);
    if (report) // what it points to ends here
        report->state.active = nullptr;
    return report;
}

} // namespace axiscomp::test
