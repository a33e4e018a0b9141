// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/soak/operation_choice.h"

#include "core/io/local_file.h"
#include "core/table/tam_table.h"
#include "tests/support/compensator_fixture.h"

#include <algorithm>

namespace axiscomp::test {

namespace {

constexpr std::size_t keptBackups = 8;

struct Weight {
    Action action;
    std::size_t weight;
};
constexpr std::array weights{Weight{Action::Write, 34}, Weight{Action::SetPersistency, 6},
    Weight{Action::RestorePrevious, 4}, Weight{Action::RestoreOld, 4}, Weight{Action::Upload, 3},
    Weight{Action::Activate, 8}, Weight{Action::Evaluate, 5}, Weight{Action::Deactivate, 5},
    Weight{Action::Prove, 4}, Weight{Action::Status, 5}, Weight{Action::Plan, 4},
    Weight{Action::Backup, 3}, Weight{Action::Download, 3}, Weight{Action::Reboot, 2},
    Weight{Action::Home, 4}, Weight{Action::PassTime, 6}};

constexpr std::array groupActions{Action::Write, Action::Write, Action::Write, Action::Status,
    Action::Backup, Action::Download, Action::Plan, Action::Activate, Action::Deactivate,
    Action::Evaluate};

constexpr std::array faults{LinkFault::RequestLost, LinkFault::ReplyLost, LinkFault::ReplyGarbled,
    LinkFault::Refused, LinkFault::DriveGone, LinkFault::DriveGoneAfter, LinkFault::Reboot,
    LinkFault::StoresWrong, LinkFault::UserStops, LinkFault::ProgramDies,
    LinkFault::ProgramDiesAfter};

} // namespace

OperationChoice::OperationChoice(std::uint32_t seed, std::size_t programs, SoakDrive& drive)
    : m_random(seed)
    , m_programs(programs)
    , m_drive(drive)
    , m_store(drive.store())
{
}

std::size_t OperationChoice::below(std::size_t count)
{
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(m_random);
}

void OperationChoice::remember(const DriveBackup& backup)
{
    m_backups.push_back(backup);
    if (m_backups.size() > keptBackups)
        m_backups.pop_front();
}

Operation OperationChoice::next(const DrivePicture& now)
{
    Operation operation;
    operation.program = below(m_programs);
    operation.axis = static_cast<int>(below(SoakDrive::axes));
    operation.action = action(now, operation.axis);
    prepare(operation, now);
    const bool isByProgram = operation.action < Action::Reboot;
    if (isByProgram && below(5) < 2)
        operation.mishap = mishap(operation.action);
    return operation;
}

std::vector<Operation> OperationChoice::nextGroup(const DrivePicture& now)
{
    std::vector<Operation> group(m_programs);
    for (std::size_t program = 0; program < m_programs; ++program) {
        Operation& operation = group[program];
        operation.program = program;
        operation.axis = static_cast<int>(below(SoakDrive::axes));
        operation.action = groupActions[below(groupActions.size())];
        prepare(operation, now);
        if (operation.action == Action::Write)
            operation.request = wholeRequest();
        if (oneIn(6))
            operation.mishap = Mishap{oneIn(2) ? LinkFault::ReplyLost : LinkFault::ProgramDies, {},
                1 + static_cast<int>(below(30))};
    }
    return group;
}

Action OperationChoice::action(const DrivePicture& now, int axis)
{
    if (const auto journal = m_store.journal(SoakDrive::serialNumber, axis);
        journal && *journal && oneIn(2))
        return std::array{Action::Settle, Action::Finish, Action::Undo}[below(3)];
    // A compensation that is on refuses every write: it is not left on for long.
    if (now.isOn(axis) && oneIn(2))
        return oneIn(3) ? Action::Prove : Action::Deactivate;
    std::size_t sum = 0;
    for (const Weight& row : weights)
        sum += row.weight;
    std::size_t chosen = below(sum);
    for (const Weight& row : weights) {
        if (chosen < row.weight)
            return row.action;
        chosen -= row.weight;
    }
    return Action::Status;
}

void OperationChoice::prepare(Operation& operation, const DrivePicture& now)
{
    const auto& slots = m_drive.drive().profile().tableSlots;
    switch (operation.action) {
    case Action::Write:
    case Action::Plan:
        operation.request = request(now, operation.axis);
        return;
    case Action::SetPersistency:
        operation.persistency = oneIn(2) ? Persistency::Persistent : Persistency::Volatile;
        return;
    case Action::RestorePrevious:
        operation.backup = previous(operation.axis);
        break;
    case Action::RestoreOld:
        if (!m_backups.empty())
            operation.backup = m_backups[below(m_backups.size())];
        break;
    case Action::Settle:
    case Action::Finish:
    case Action::Undo:
        operation.journal = m_store.journal(SoakDrive::serialNumber, operation.axis).value();
        if (operation.journal->newTable)
            operation.file = m_store.keptTable(*operation.journal->newTable).value();
        return;
    case Action::Upload: {
        const auto& foreign = SoakDrive::foreignSlots();
        operation.path = m_drive.drive().profile().slotNamed(foreign[below(foreign.size())])->file;
        operation.file = encodeTamTable(
            table(1 + static_cast<int>(below(3))), false, m_drive.drive().profile().layout)
                             .value();
        return;
    }
    case Action::Download:
        operation.path = slots[below(slots.size())].file;
        return;
    case Action::PassTime:
        operation.time = std::chrono::seconds(1 + below(900));
        return;
    default:
        return;
    }
    if (!operation.backup)
        operation.action = Action::Backup;
}

/// The newest backup that a write to the axis left, as the window's "Restore previous" takes it.
std::optional<DriveBackup> OperationChoice::previous(int axis)
{
    const auto files = m_store.backups(SoakDrive::serialNumber, axis);
    if (files.empty())
        return {};
    const auto text = loadFile(files.front(), maximumBackupSize).value();
    return readBackup(asText(text), files.front().string()).value();
}

WriteRequest OperationChoice::wholeRequest()
{
    WriteRequest request;
    request.dimensionality = 1 + static_cast<int>(below(3));
    request.table = table(request.dimensionality);
    request.sources = sources(request.dimensionality);
    request.persistency = oneIn(3) ? Persistency::Persistent : Persistency::Volatile;
    return request;
}

WriteRequest OperationChoice::request(const DrivePicture& now, int axis)
{
    WriteRequest request = wholeRequest();
    if (oneIn(6)) { // the table stays, its sources and persistency may change
        const AxisPicture& picture = now.axes[static_cast<std::size_t>(axis)];
        request.table.reset();
        request.dimensionality = static_cast<int>(std::max<std::ptrdiff_t>(
            1, std::ranges::count_if(picture.sources, [](std::uint32_t s) { return s != 0; })));
        request.sources = sources(request.dimensionality);
        if (oneIn(3))
            request.sources.clear();
        if (oneIn(3))
            request.persistency.reset();
    } else if (oneIn(6)) {
        request.slot = slotToName(now, axis);
    }
    return request;
}

/// An empty slot, or the axis's own.
std::optional<std::string> OperationChoice::slotToName(const DrivePicture& now, int axis)
{
    std::vector<std::string> names;
    for (const TableSlot& slot : m_drive.drive().profile().tableSlots) {
        const auto& foreign = SoakDrive::foreignSlots();
        const bool isForeign = std::ranges::find(foreign, slot.name) != foreign.end();
        if (!isForeign && (!now.slots.contains(slot.name) || now.userOf(slot.name) == axis))
            names.push_back(slot.name);
    }
    return names.empty() ? std::nullopt : std::optional(names[below(names.size())]);
}

std::vector<std::string> OperationChoice::sources(int dimensions)
{
    std::vector<std::string> all{
        "Application/Variables/Floats[0]", "Application/Variables/Floats[1]"};
    for (int axis = 0; axis < SoakDrive::axes; ++axis) {
        const std::string path = "Axes[" + std::to_string(axis) + "]/Signals/";
        all.push_back(path + "PositionController/MasterPosition");
        all.push_back(path + "PositionController/Encoders[0]/Position");
        all.push_back(path + "PathPlanner/Position");
    }
    std::ranges::shuffle(all, m_random);
    all.resize(static_cast<std::size_t>(dimensions));
    return all;
}

/// One of a few, so that the same one comes again; sometimes one that needs a large slot.
CompensationTable OperationChoice::table(int dimensions)
{
    const int seed = static_cast<int>(below(12));
    if (dimensions == 3 && oneIn(12))
        return exampleTable(3, seed, 26);
    return exampleTable(dimensions, seed, 2 + static_cast<std::uint32_t>(below(5)));
}

Mishap OperationChoice::mishap(Action action)
{
    using Kind = drivecomm::FaultSpec::Kind;
    constexpr std::array onTheWire{
        Kind::Garble, Kind::DropAfter, Kind::RebootAfter, Kind::StoresWrong};
    const bool isLong = action <= Action::Undo && action != Action::Settle;
    Mishap mishap;
    mishap.exchange = 1 + static_cast<int>(below(isLong ? 36 : 6));
    if (!oneIn(4)) {
        mishap.fault = faults[below(faults.size())];
        return mishap;
    }
    const Kind kind = onTheWire[below(onTheWire.size())];
    auto number = static_cast<std::uint64_t>(mishap.exchange);
    if (kind == Kind::DropAfter)
        number = 1 + below(isLong ? 20'000 : 3'000);
    if (kind == Kind::StoresWrong)
        number = 1 + below(6);
    mishap.onTheWire = drivecomm::FaultSpec{kind, number, {}};
    return mishap;
}

} // namespace axiscomp::test
