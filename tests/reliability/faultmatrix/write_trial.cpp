// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/faultmatrix/write_trial.h"

#include "tests/support/verify.h"

namespace axiscomp::test {

namespace {

constexpr auto V = Persistency::Volatile;
constexpr auto P = Persistency::Persistent;

constexpr std::array scenarios{
    WriteScenario{"first, volatile", V, V, false, true, false},
    WriteScenario{"first, persistent", V, P, false, true, false},
    WriteScenario{"replace, volatile by volatile", V, V, true, true, false},
    WriteScenario{"replace, persistent by persistent", P, P, true, true, false},
    WriteScenario{"replace, persistent by volatile", P, V, true, true, false},
    WriteScenario{"overwrite in place, volatile", V, V, true, false, false},
    WriteScenario{"overwrite in place, persistent", P, P, true, false, false},
    WriteScenario{"make persistent", V, P, true, true, true},
    WriteScenario{"make volatile", P, V, true, true, true},
    WriteScenario{"one by one: replace, persistent by persistent", P, P, true, true, false, true},
    WriteScenario{"one by one: make persistent", V, P, true, true, true, true},
    WriteScenario{"one by one: make volatile", P, V, true, true, true, true},
    WriteScenario{"delete, volatile", V, V, true, true, false, false, true},
    WriteScenario{"delete, persistent", P, V, true, true, false, false, true},
    WriteScenario{"one by one: delete, persistent", P, V, true, true, false, true, true},
};

/// Tables of a drive program: with them there the axis has only one slot.
Result<void> fillOtherSlots(drivecomm::VirtualDrive& drive)
{
    const auto file = encodeTamTable(exampleTable(1, 9), false, drivecomm::genericProfile().layout);
    for (const TableSlot& slot : drivecomm::genericProfile().tableSlots) {
        if (slot.name == "Small1")
            continue;
        if (auto filled = drive.upload(slot.file, *file); !filled)
            return filled;
    }
    return {};
}

const DriveProfile& oneByOneProfile()
{
    static const DriveProfile profile = [] {
        DriveProfile changed = drivecomm::genericProfile();
        changed.writesAtOneInstant = false;
        return changed;
    }();
    return profile;
}

/// A table with its sources and persistency, in whichever slot.
bool sameButSlot(CompensatorFixture::State a, const CompensatorFixture::State& b)
{
    const auto isOff = [](const CompensatorFixture::State& state) {
        return state.registers[0] == "Disabled";
    };
    if (isOff(a) != isOff(b))
        return false;
    a.registers[0] = b.registers[0];
    return a == b;
}

std::string saidBy(const Result<WriteReport>& report)
{
    return report ? "success" : describe(report.error());
}

} // namespace

std::span<const WriteScenario> writeScenarios()
{
    return scenarios;
}

Aftermath aftermathOf(std::size_t number)
{
    return {(number & 1U) != 0, (number & 2U) != 0};
}

WriteTrial::WriteTrial(
    const WriteScenario& scenario, const AttachmentKind& kind, std::uint32_t points)
    : CompensatorFixture(
        kind, scenario.isOneByOne ? oneByOneProfile() : drivecomm::genericProfile())
    , m_scenario(scenario)
    , m_points(points)
{
    if (const auto ready = prepare(); !ready)
        m_unready = "the old state could not be made: " + describe(ready.error());
    m_request = fullRequest();
    if (scenario.keepsTable)
        m_request.table.reset();
    options.stop = m_stop.get_token();
    link.stopUser = [this] { m_stop.request_stop(); };
}

/// By a link of its own: nothing of the attachment is used before the write.
Result<void> WriteTrial::prepare()
{
    if (!m_scenario.isSlotFree) {
        if (auto filled = fillOtherSlots(drive); !filled)
            return filled;
    }
    if (!m_scenario.hasOldTable)
        return {};
    const auto direct = drivecomm::makeDirectLink(drive);
    AxisCompensator before(
        *direct, drivecomm::genericProfile(), store, [this] { return wallTime(); });
    WriteRequest old = exampleRequest(1, m_scenario.before);
    old.table = exampleTable(2, 1, m_points);
    if (auto written = before.write(0, old); !written)
        return fail(written.error());
    return {};
}

WriteRequest WriteTrial::fullRequest() const
{
    if (m_scenario.deletes)
        return deletionRequest();
    const int seed = m_scenario.keepsTable ? 1 : 2;
    WriteRequest request = exampleRequest(seed, m_scenario.after);
    request.table = exampleTable(2, seed, m_points);
    // Otherwise an old table with new sources would not be seen to be a mixture.
    if (m_scenario.hasOldTable)
        std::swap(request.sources[0], request.sources[1]);
    return request;
}

Result<WriteReport> WriteTrial::write()
{
    return compensator.write(0, m_request, options);
}

void WriteTrial::changeFaults(const std::function<void(drivecomm::FaultPlan&)>& change)
{
    const std::scoped_lock lock(m_healing);
    if (!m_hasHealed)
        change(faults);
}

void WriteTrial::heal()
{
    link.heal();
    {
        const std::scoped_lock lock(m_healing);
        m_hasHealed = true;
        faults.clear();
    }
    // A value still to be stored wrong meets a register that nobody uses.
    (void)drive.writeRegisters({{"Application/Variables/Floats[255]", 1.0F}});
}

bool WriteTrial::isSwitchedOff(const State& state) const
{
    return canBeLeftOff() && state.registers[0] == "Disabled";
}

/// State does not say what a slot holds that no axis uses.
bool WriteTrial::hasOldSlotEmpty(const HeldStates& states)
{
    const TableSlot* slot = drivecomm::genericProfile().slotNamed(states.old.registers[0]);
    return slot && drive.download(slot->file).value_or(Bytes{}).empty();
}

bool WriteTrial::isNew(const State& state, const HeldStates& states)
{
    return state == states.wanted && (!m_scenario.deletes || hasOldSlotEmpty(states));
}

bool WriteTrial::holdsWanted(const HeldStates& states)
{
    if (m_scenario.deletes) // a reboot may have taken the sources, which stay as they are
        return state().registers[0] == "Disabled" && hasOldSlotEmpty(states);
    return sameButSlot(state(), states.wanted);
}

std::string WriteTrial::stateText(const State& state, const HeldStates& states) const
{
    std::string text = "the drive holds ";
    if (state == states.old)
        text += "the old state";
    else if (state == states.wanted)
        text += "the new state";
    else
        text += state.registers[0] + " with "
            + (state.table == states.old.table           ? "the old table"
                    : state.table == states.wanted.table ? "the new table"
                    : state.table.empty()                ? "no table"
                                                         : "another table")
            + ", sources " + state.registers[1] + " and " + state.registers[2] + ", persistent "
            + state.persistent;
    return text;
}

std::string WriteTrial::judge(
    const Result<WriteReport>& report, const FaultTraits& traits, const HeldStates& states)
{
    const State now = state();
    const bool isOld = now == states.old;
    const bool isNewNow = isNew(now, states);
    const bool isRebooted =
        traits.reboots && (now == states.oldRebooted || now == states.wantedRebooted);
    const auto wrong = [&](const std::string& what) {
        return what + ": the program said " + saidBy(report) + ", " + stateText(now, states);
    };
    if (text("Axes[0]/Signals/Compensations/Axis/State") != "Disabled")
        return wrong("the compensation is on");
    // What a drive has forgotten may have freed another slot before one was chosen.
    if (report)
        return isNewNow || (traits.reboots && holdsWanted(states))
            ? ""
            : wrong("it is not the new state");
    switch (report.error().code) {
    case ErrorCode::RollbackFailed:
        if (!canBeLeftOff() && !traits.reboots)
            return wrong("nothing had to be put back that could not be");
        return isOld || isNewNow || isRebooted || isSwitchedOff(now)
            ? ""
            : wrong("it is a mixture that could be activated");
    case ErrorCode::OutcomeUnknown:
        return isOld || isNewNow || isRebooted ? "" : wrong("it is neither old nor new");
    default:
        return isOld || isRebooted ? "" : wrong("it is not the old state");
    }
}

std::string WriteTrial::judgeAftermath(const Result<WriteReport>& report, const FaultTraits& traits,
    const HeldStates& states, const Aftermath& aftermath)
{
    if (aftermath.asks)
        if (auto wrong = judgeAnswer(states, traits); !wrong.empty())
            return wrong;
    if (aftermath.reboots)
        if (auto wrong = judgeReboot(report, traits, states); !wrong.empty())
            return wrong;
    const auto again = compensator.write(0, fullRequest());
    const bool isThere = !again
        && again.error().code
            == (m_scenario.deletes ? ErrorCode::NoTable : ErrorCode::NothingToWrite);
    if (!again && !isThere)
        return "the next write failed: " + saidBy(again);
    if (!holdsWanted(states))
        return "after the next write " + stateText(state(), states);
    return {};
}

/// What `status` and the window do when they see a journal.
std::string WriteTrial::judgeAnswer(const HeldStates& states, const FaultTraits& traits)
{
    const auto status = compensator.status(0);
    if (!status)
        return "status failed: " + describe(status.error());
    const State now = state();
    if (!status->unfinishedWrite)
        return {};
    const auto outcome = compensator.settleUnfinished(*status->unfinishedWrite);
    if (!outcome)
        return "settling failed: " + describe(outcome.error());
    using Outcome = AxisCompensator::UnfinishedOutcome;
    const bool isTrue = [&] {
        switch (*outcome) {
        case Outcome::Old:
            return now == states.old;
        case Outcome::New:
        case Outcome::NewUnsaved:
            return isNew(now, states);
        case Outcome::Neither:
            return now != states.old && !isNew(now, states) && (canBeLeftOff() || traits.reboots);
        case Outcome::Unknown: // its backup is there
            return false;
        }
        return false;
    }();
    return isTrue ? ""
                  : "status said outcome " + std::to_string(static_cast<int>(*outcome)) + ", "
            + stateText(now, states);
}

/// What a reboot brings back is one of the two states as well, and the old one unless the program
/// said something else. Parameters that had been saved before the write are not known: putting the
/// old ones back saves them, so that an axis with a volatile table may name it, and not have it.
std::string WriteTrial::judgeReboot(
    const Result<WriteReport>& report, const FaultTraits& traits, const HeldStates& states)
{
    drive.reboot();
    const State now = state();
    const bool isWithoutTable = m_scenario.before == Persistency::Volatile && now.table.empty();
    const bool isOldWithoutTable = isWithoutTable && now.registers == states.old.registers;
    const bool isOld = now == states.oldRebooted || isOldWithoutTable;
    const bool isNewNow =
        now == states.wantedRebooted || (traits.reboots && sameButSlot(now, states.wantedRebooted));
    // The axis names its slot again, which is empty: it cannot be activated.
    const bool isNameOnly =
        m_scenario.deletes && now.table.empty() && now.registers == states.old.registers;
    const bool isUnsaved = traits.losesCommands && (isOld || isSwitchedOff(now) || isNameOnly);
    bool isRight = report ? isNewNow || isUnsaved : isOld;
    if (!report
        && (report.error().code == ErrorCode::OutcomeUnknown
            || report.error().code == ErrorCode::RollbackFailed || traits.reboots))
        isRight = isOld || isNewNow || isSwitchedOff(now) || isWithoutTable;
    return isRight
        ? ""
        : "after a reboot " + stateText(now, states) + "; the program had said " + saidBy(report);
}

HeldStates heldStatesOf(const WriteScenario& scenario, std::uint32_t points)
{
    HeldStates states;
    WriteTrial before(scenario, inProcess(), points);
    states.old = before.state();
    before.drive.reboot();
    states.oldRebooted = before.state();
    WriteTrial after(scenario, inProcess(), points);
    (void)after.write();
    states.wanted = after.state();
    after.drive.reboot();
    states.wantedRebooted = after.state();
    return states;
}

RecordedWrite recordWrite(
    const WriteScenario& scenario, const AttachmentKind& kind, std::uint32_t points)
{
    RecordedWrite recorded;
    WriteTrial trial(scenario, kind, points);
    recorded.wrong = trial.unready();
    // A cut that is never reached counts the bytes.
    constexpr std::uint64_t never = std::uint64_t{1} << 50;
    trial.faults.add({drivecomm::FaultSpec::Kind::DropAfter, never, {}});
    std::uint64_t begin = 0;
    RecordedWrite::Transfer* running = nullptr;
    trial.link.beginning = [&](std::string_view what) {
        const std::uint64_t now = never - trial.faults.bytesUntilDrop().value_or(never);
        if (running)
            running->bytes = now - begin;
        running = nullptr;
        begin = now;
        ++recorded.exchanges;
        if (what == "upload" && recorded.upload.exchange == 0)
            running = &recorded.upload;
        else if (what == "download" && recorded.upload.exchange != 0
            && recorded.readBack.exchange == 0)
            running = &recorded.readBack;
        if (running)
            running->exchange = recorded.exchanges;
    };
    trial.requested = [&](bool isWrite) {
        ++recorded.requests;
        recorded.writeRequests += isWrite ? 1 : 0;
    };
    const auto report = trial.write();
    trial.requested = {};
    if (!report && recorded.wrong.empty())
        recorded.wrong = "the write failed: " + describe(report.error());

    WriteTrial refused(scenario, kind, points);
    refused.link.failAt(recorded.exchanges, LinkFault::Refused);
    if (refused.write())
        recorded.wrong = "a write whose end was refused succeeded";
    recorded.exchangesToPutBack = refused.link.exchanges() - recorded.exchanges;
    return recorded;
}

} // namespace axiscomp::test
