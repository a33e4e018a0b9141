// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/compensator_fixture.h"

#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace axiscomp::test {

/// A kind of write, and what the drive held before.
struct WriteScenario {
    const char* name;
    Persistency before; ///< of the old table
    Persistency after;
    bool hasOldTable;
    bool isSlotFree; ///< otherwise the axis's only table is overwritten
    bool keepsTable; ///< only persistency and sources change
    bool isOneByOne = false; ///< the drive takes no two registers at one instant
    bool deletes = false; ///< the table: afterwards its slot is empty
};
[[nodiscard]] std::span<const WriteScenario> writeScenarios();

/// The complete states that a drive may hold after a write, and what a reboot makes of them.
struct HeldStates {
    CompensatorFixture::State old;
    CompensatorFixture::State wanted;
    CompensatorFixture::State oldRebooted;
    CompensatorFixture::State wantedRebooted;
};

/// What a fault may bring about beyond a write that fails.
struct FaultTraits {
    bool reboots = false; ///< what was not persistent is gone
    bool losesCommands = false; ///< "saved", says the drive, and nobody can see that it is not
};

/// What happens between an interrupted write and the next one.
struct Aftermath {
    bool asks = false; ///< status, which settles what became of the write
    bool reboots = false; ///< power off and on
};
/// Each of the four in turn.
[[nodiscard]] Aftermath aftermathOf(std::size_t number);

/// A drive in the state before a write, and the write.
///
/// What is wrong comes as a sentence, empty when nothing is: trials run on threads on which a test
/// cannot fail.
class WriteTrial : public CompensatorFixture {
public:
    /// points: of each dimension of the tables
    explicit WriteTrial(const WriteScenario& scenario, const AttachmentKind& kind = inProcess(),
        std::uint32_t points = 6);

    /// Why the old state could not be made.
    [[nodiscard]] const std::string& unready() const { return m_unready; }
    [[nodiscard]] Result<WriteReport> write();
    /// For a request that is being served: makes the faults others, unless the trial has healed.
    void changeFaults(const std::function<void(drivecomm::FaultPlan&)>& change);
    /// No more faults; what was on its way arrives.
    void heal();

    /// Is it the old state or the new one, completely, switched off, and what the program said?
    [[nodiscard]] std::string judge(
        const Result<WriteReport>& report, const FaultTraits& traits, const HeldStates& states);
    /// Asks, reboots, and writes again, which must succeed without help.
    [[nodiscard]] std::string judgeAftermath(const Result<WriteReport>& report,
        const FaultTraits& traits, const HeldStates& states, const Aftermath& aftermath);
    /// The new state, as it was planned.
    [[nodiscard]] bool isNew(const State& state, const HeldStates& states);
    /// The new state, in whichever slot.
    [[nodiscard]] bool holdsWanted(const HeldStates& states);
    /// It cannot be activated, because its one slot was being overwritten or its registers one by
    /// one.
    [[nodiscard]] bool isSwitchedOff(const State& state) const;
    [[nodiscard]] std::string stateText(const State& state, const HeldStates& states) const;

    /// The new state described completely, for a drive that may have lost its table.
    [[nodiscard]] WriteRequest fullRequest() const;
    [[nodiscard]] const WriteRequest& request() const { return m_request; }
    [[nodiscard]] const WriteScenario& scenario() const { return m_scenario; }
    OperationOptions options; ///< of the write

private:
    [[nodiscard]] Result<void> prepare();
    [[nodiscard]] bool canBeLeftOff() const
    {
        return !m_scenario.isSlotFree || m_scenario.isOneByOne || m_scenario.deletes;
    }
    [[nodiscard]] bool hasOldSlotEmpty(const HeldStates& states);
    [[nodiscard]] std::string judgeAnswer(const HeldStates& states, const FaultTraits& traits);
    [[nodiscard]] std::string judgeReboot(
        const Result<WriteReport>& report, const FaultTraits& traits, const HeldStates& states);

    const WriteScenario& m_scenario;
    std::uint32_t m_points;
    std::string m_unready;
    WriteRequest m_request;
    std::stop_source m_stop;
    std::mutex m_healing;
    bool m_hasHealed = false;
};

[[nodiscard]] HeldStates heldStatesOf(const WriteScenario& scenario, std::uint32_t points = 6);

/// What a write does when nothing goes wrong.
struct RecordedWrite {
    struct Transfer {
        int exchange = 0; ///< from 1
        std::uint64_t bytes = 0; ///< on the wire, in both directions
    };
    int exchanges = 0;
    int requests = 0; ///< that the drive sees
    int writeRequests = 0; ///< of these
    Transfer upload; ///< of the new table, when there is one
    Transfer readBack;
    int exchangesToPutBack = 0; ///< when the last exchange is refused
    std::string wrong; ///< why it went wrong all the same
};
[[nodiscard]] RecordedWrite recordWrite(
    const WriteScenario& scenario, const AttachmentKind& kind, std::uint32_t points = 6);

} // namespace axiscomp::test
