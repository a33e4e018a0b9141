// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include "core/text/number_text.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive_p.h"

#include <algorithm>
#include <cassert>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t maximumAxes = 64;

std::function<DriveTime()> timeSinceNow()
{
    return [start = std::chrono::steady_clock::now()] {
        return std::chrono::duration_cast<DriveTime>(std::chrono::steady_clock::now() - start);
    };
}

/// The axes of a machine; homed unless those that were asked for are not.
std::vector<VirtualAxis> axesOf(
    const MachineDescription& machine, const std::vector<VirtualAxis>& asked)
{
    std::vector<VirtualAxis> axes;
    for (const MachineAxis& each : machine.axes) {
        VirtualAxis axis;
        axis.name = each.name;
        axis.unit = each.isAngular ? "Degree" : "Millimeter";
        axis.low = each.low;
        axis.high = each.high;
        // Different periods, so that all places of a plane or a volume are visited.
        axis.periodSeconds += 7.0 * static_cast<double>(axes.size());
        axis.homed = asked.empty() || asked.front().homed;
        axis.saysTravel = true;
        axes.push_back(std::move(axis));
    }
    return axes;
}

tl::unexpected<Error> unplayable(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

/// Whether the machine can play the program.
Result<void> checkProgram(const MachineDescription& machine, const MeasuringPlan& plan)
{
    const auto axis = std::ranges::find(machine.axes, plan.axis, &MachineAxis::name);
    std::vector<std::string> names;
    for (const MachineAxis& each : machine.axes)
        names.push_back(each.name);
    if (axis == machine.axes.end())
        return unplayable(
            AXISCOMP_TEXT("Error", "the plan is for axis {axis}; the machine has: {known}")
                .with("axis", plan.axis)
                .with("known", std::move(names)));
    if (axis->isAngular != plan.isAngular)
        return unplayable(AXISCOMP_TEXT("Error",
            "the plan and axis {axis} of the machine differ: one is in mm, the other in deg")
                              .with("axis", plan.axis));
    if (plan.steps.empty() || !(plan.feedPerMinute > 0.0) || !(plan.dwellSeconds > 0.0))
        return unplayable(AXISCOMP_TEXT("Error",
            "the plan needs a feed and a dwell above 0: lines such as // feed: 1000 mm/min and // "
            "dwell: 5 s"));
    // An overrun leads beyond the ends of what is measured.
    const double margin = (axis->high - axis->low) / 10.0;
    for (const MeasuringStep& step : plan.steps)
        for (const double place : {step.approach, step.target})
            if (place < axis->low - margin || place > axis->high + margin)
                return unplayable(AXISCOMP_TEXT("Error",
                    "step {step} of the plan goes to {place}, more than a tenth beyond the travel "
                    "of axis {axis}, {low} to {high}")
                                      .with("step", step.step)
                                      .with("place", Quantity{roundedText(place)})
                                      .with("axis", plan.axis)
                                      .with("low", Quantity{roundedText(axis->low)})
                                      .with("high", Quantity{roundedText(axis->high)}));
    return {};
}

Result<void> checkMachine(const VirtualDriveOptions& options)
{
    if (options.program && !options.machine)
        return unplayable(
            AXISCOMP_TEXT("Error", "a program needs a machine that plays it (--machine)"));
    if (options.machine && options.machine->axes.empty())
        return unplayable(AXISCOMP_TEXT("Error", "a machine has at least one axis"));
    return options.program ? checkProgram(*options.machine, *options.program) : Result<void>();
}

} // namespace

VirtualDrive::Private::Private(const DriveProfile& usedProfile, VirtualDriveOptions usedOptions)
    : profile(usedProfile)
    , options(std::move(usedOptions))
    , memory(usedProfile)
{
    if (!options.clock)
        options.clock = timeSinceNow();
    if (!options.wallClock)
        options.wallClock = [] { return std::chrono::system_clock::now(); };
    if (options.machine)
        options.axes = axesOf(*options.machine, options.axes);
    options.axes.resize(std::clamp<std::size_t>(options.axes.size(), 1, maximumAxes));
    int index = 0;
    for (const VirtualAxis& axis : options.axes)
        axes.push_back({AxisMotion(axis, index++), Homing(axis.homed), {}});
    if (options.machine)
        beginMachine();
    defineRegisters();
    settleEncoders();
    for (std::size_t i = 0; machine && i < axes.size(); ++i)
        machine->reversals.emplace_back(options.machine->axes[i].reversalWidth, axes[i].encoder);
    advance();
}

VirtualDrive::VirtualDrive(std::unique_ptr<Private> made) : d(std::move(made)) { }

VirtualDrive::VirtualDrive(const DriveProfile& profile, VirtualDriveOptions options)
    : d(std::make_unique<Private>(profile, std::move(options)))
{
    assert(d->options.stateFolder.empty());
    (void)d->applyParameters();
}

VirtualDrive::~VirtualDrive() = default;

Result<std::unique_ptr<VirtualDrive>> VirtualDrive::create(
    const DriveProfile& profile, VirtualDriveOptions options)
{
    if (options.axes.size() > maximumAxes)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error", "a virtual drive has at most {most} axes, not {count}")
                    .with("most", maximumAxes)
                    .with("count", options.axes.size())}});
    for (const VirtualAxis& axis : options.axes)
        if (!(axis.low < axis.high) || !(axis.periodSeconds > 0.0))
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "an axis needs a range with low below high, and a period above 0 s")}});
    AXISCOMP_CHECK(checkMachine(options));
    auto made = std::make_unique<Private>(profile, std::move(options));
    if (const Result<void> applied = made->applyParameters(); !applied)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error", "a parameter does not fit: {reason}")
                    .with("reason", textOf(applied.error()))}});
    if (!made->options.stateFolder.empty())
        if (const Result<void> opened = made->openState(); !opened)
            return fail(opened.error());
    return std::unique_ptr<VirtualDrive>(new VirtualDrive(std::move(made)));
}

const DriveProfile& VirtualDrive::profile() const
{
    return d->profile;
}

DriveIdentity VirtualDrive::identity() const
{
    const std::scoped_lock lock(d->mutex);
    std::vector<std::int32_t> words;
    for (const Register* word : d->deviceName)
        words.push_back(std::get<std::int32_t>(word->value));
    return {unpackName(words), d->options.serialNumber, static_cast<int>(d->axes.size())};
}

Result<std::vector<RegisterReading>> VirtualDrive::readRegisters(
    const std::vector<std::string>& paths)
{
    if (paths.size() > DriveLink::maximumReads)
        return fail(ErrorCode::DriveRejected,
            {{"reason",
                AXISCOMP_TEXT("Error", "a request reads at most {most} registers, not {count}")
                    .with("most", DriveLink::maximumReads)
                    .with("count", paths.size())}});
    const std::scoped_lock lock(d->mutex);
    d->advance();
    std::vector<RegisterReading> result;
    result.reserve(paths.size());
    for (const std::string& path : paths) {
        const Register* found = d->tree.find(path);
        if (found == nullptr)
            return fail(
                ErrorCode::UnknownRegister, {{"path", path}, {"nearest", d->tree.nearest(path)}});
        result.push_back(found->reading());
    }
    return result;
}

std::vector<RegisterReading> VirtualDrive::readTree(const std::string& prefix)
{
    const std::scoped_lock lock(d->mutex);
    d->advance();
    std::vector<RegisterReading> result;
    for (const Register* found : d->tree.under(prefix))
        result.push_back(found->reading());
    return result;
}

Result<void> VirtualDrive::writeRegisters(const std::vector<RegisterWrite>& writes)
{
    const std::scoped_lock lock(d->mutex);
    d->advance();
    return d->write(writes);
}

RegisterEntry VirtualDrive::registerEntry(const std::string& path) const
{
    const std::scoped_lock lock(d->mutex);
    const Register* found = d->tree.find(path);
    if (found == nullptr)
        return {};
    return {found->role != RegisterRole::ReadOnly, found->enumValues};
}

std::vector<DriveFile> VirtualDrive::listFiles()
{
    const std::scoped_lock lock(d->mutex);
    std::vector<DriveFile> result;
    for (std::size_t i = 0; i < d->memory.slotCount(); ++i) {
        const TableSlot& slot = d->profile.tableSlots[i];
        const auto& ram = d->memory.slot(i).ram;
        result.push_back(
            {slot.file, static_cast<std::uint32_t>(ram ? ram->bytes.size() : 0), slot.maximumSize});
    }
    return result;
}

Result<Bytes> VirtualDrive::download(const std::string& path)
{
    const std::scoped_lock lock(d->mutex);
    const auto slot = std::ranges::find(d->profile.tableSlots, path, &TableSlot::file);
    if (slot == d->profile.tableSlots.end())
        return fail(ErrorCode::UnknownFile, {{"path", path}});
    const auto& ram =
        d->memory.slot(static_cast<std::size_t>(slot - d->profile.tableSlots.begin())).ram;
    return ram ? ram->bytes : Bytes{};
}

Result<void> VirtualDrive::upload(const std::string& path, ByteView bytes)
{
    const std::scoped_lock lock(d->mutex);
    d->advance();
    return d->upload(path, bytes);
}

void VirtualDrive::reboot()
{
    const std::scoped_lock lock(d->mutex);
    d->advance();
    d->reboot();
}

std::optional<double> VirtualDrive::instrumentReading()
{
    const std::scoped_lock lock(d->mutex);
    d->advance();
    if (!d->machine)
        return std::nullopt;
    return d->referencePosition(d->machine->truth.description().instrument.axis);
}

void VirtualDrive::storeNextWrong()
{
    const std::scoped_lock lock(d->mutex);
    d->storeWrong = true;
}

} // namespace axiscomp::drivecomm
