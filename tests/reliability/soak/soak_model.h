// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reliability/soak/operation.h"
#include "tests/reliability/soak/soak_drive.h"

#include <map>
#include <set>

namespace axiscomp::test {

/// What the drive holds, and what it would hold after a reboot.
struct Moment {
    DrivePicture now;
    DrivePicture afterReboot;
};

/// Knows which states an axis may have, and checks after every operation that it has one of them
/// and that everything else is as it was. Its checks give one sentence for each thing that is not.
class SoakModel {
public:
    explicit SoakModel(SoakDrive& drive);

    [[nodiscard]] std::vector<std::string> check(const Operation& operation, const Ending& ending,
        const Moment& before, const Moment& after);
    /// Of operations at the same time: their order is not known.
    [[nodiscard]] std::vector<std::string> check(const std::vector<Operation>& group,
        const std::vector<Ending>& endings, const Moment& before, const Moment& after);

private:
    // soak_model.cpp: the states of the axes
    [[nodiscard]] static const DrivePicture& keptFrom(const Operation& operation,
        const Ending& ending, int axis, const Moment& before, const Moment& after);
    [[nodiscard]] std::optional<AxisPicture> wanted(
        const Operation& operation, int axis, const DrivePicture& before);
    [[nodiscard]] AxisPicture finished(const Operation& operation);
    [[nodiscard]] static DriveBackup backupOf(const JournalEntry& journal);
    [[nodiscard]] std::optional<AxisPicture> heldBy(const DriveBackup& backup, int axis);
    [[nodiscard]] std::optional<AxisPicture> wantedByBackup(const DriveBackup& backup, int axis);
    void checkAxis(const Operation& operation, const Ending& ending, int axis, const Moment& before,
        const Moment& after);
    void checkAxisTogether(const std::vector<Operation>& group, const std::vector<Ending>& endings,
        int axis, const Moment& before, const Moment& after);
    void checkFlash(const Operation& operation, const Ending& ending, int axis,
        const Moment& before, const Moment& after);
    [[nodiscard]] bool isSwitchedOffInPlace(const Operation& operation, const Ending& ending,
        int axis, const AxisPicture& before, const AxisPicture& after);
    void learn(int axis, const AxisPicture& picture);
    void checkReachable(int axis, const Moment& moment);
    void checkHiding(const Operation& operation, const Ending& ending, const Moment& before,
        const Moment& after);
    void noteUncounted(const Operation& operation, const Ending& ending);

    // soak_report_checks.cpp: what the program said
    void checkReports(const Operation& operation, const Ending& ending, const Moment& before,
        const Moment& after);
    void checkWriteReport(
        const WriteReport& report, const Ending& ending, const Moment& before, const Moment& after);
    void checkBackup(const DriveBackup& backup, const std::vector<AxisPicture>& axes);
    void checkSettled(const Operation& operation, AxisCompensator::UnfinishedOutcome outcome,
        const DrivePicture& after);

    // soak_bystander_checks.cpp: what must stay as it is
    void checkSlots(
        const Operation& operation, const DrivePicture& before, const DrivePicture& after);
    void noteOwners(
        const DrivePicture& before, const DrivePicture& after, std::optional<int> axis = {});
    void checkForeignSlots(
        const std::vector<Operation>& group, const DrivePicture& before, const DrivePicture& after);
    void checkJournal(const Operation& operation, const Ending& ending, int axis,
        const DrivePicture& before, const DrivePicture& after);
    void checkJournals(const Operation& operation, const Ending& ending, const DrivePicture& before,
        const DrivePicture& after);
    void checkStore(const DrivePicture& after);
    void checkOutputs(const DrivePicture& after);

    void expect(bool isTrue, const std::string& otherwise)
    {
        if (!isTrue)
            m_problems.push_back(otherwise);
    }

    SoakDrive& m_drive;
    DriveStore m_store;
    std::uint64_t m_firstCycles; ///< before any program had to do with the drive
    std::vector<std::string> m_problems;
    /// Sources and table of each axis that once belonged together.
    std::vector<std::set<std::pair<std::array<std::uint32_t, 3>, Bytes>>> m_known;
    std::map<std::string, int> m_owners; ///< the axis that last put its table into a slot
    std::vector<bool> m_journalMayBeOpen;
    /// Programs that were killed in a write, perhaps between a flash operation and its record.
    std::uint64_t m_deaths = 0;
    WallTime m_lastUncounted{}; ///< when a flash operation may have been spent that is not recorded
};

/// The fault has rebooted the drive, or may have.
[[nodiscard]] bool mayHaveRebooted(const Operation& operation, const Ending& ending);
/// The operation concerns the setup of this axis.
[[nodiscard]] bool changesSetupOf(const Operation& operation, int axis);

} // namespace axiscomp::test
