// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reliability/soak/operation.h"
#include "tests/reliability/soak/soak_drive.h"

#include <deque>
#include <random>

namespace axiscomp::test {

/// Chooses what happens next, from one stream of random numbers: the same seed and the same answers
/// of the drive give the same operations.
class OperationChoice {
public:
    OperationChoice(std::uint32_t seed, std::size_t programs, SoakDrive& drive);

    /// One operation on its own, sometimes with a fault.
    [[nodiscard]] Operation next(const DrivePicture& now);
    /// Operations of different programs at the same time. What they bring about does not depend on
    /// their order, but for which of two writes to one axis is the last.
    [[nodiscard]] std::vector<Operation> nextGroup(const DrivePicture& now);
    [[nodiscard]] bool isGroupNext() { return oneIn(8); }

    /// A backup that may be restored later.
    void remember(const DriveBackup& backup);

private:
    [[nodiscard]] std::size_t below(std::size_t count);
    [[nodiscard]] bool oneIn(std::size_t count) { return below(count) == 0; }
    [[nodiscard]] Action action(const DrivePicture& now, int axis);
    [[nodiscard]] WriteRequest request(const DrivePicture& now, int axis);
    [[nodiscard]] WriteRequest wholeRequest();
    [[nodiscard]] std::vector<std::string> sources(int dimensions);
    [[nodiscard]] CompensationTable table(int dimensions);
    [[nodiscard]] std::optional<std::string> slotToName(const DrivePicture& now, int axis);
    [[nodiscard]] Mishap mishap(Action action);
    void prepare(Operation& operation, const DrivePicture& now);
    [[nodiscard]] std::optional<DriveBackup> previous(int axis);

    std::mt19937 m_random;
    std::size_t m_programs;
    SoakDrive& m_drive;
    DriveStore m_store;
    std::deque<DriveBackup> m_backups;
};

} // namespace axiscomp::test
