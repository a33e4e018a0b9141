// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/soak/operation.h"

#include "tests/support/verify.h"

namespace axiscomp::test {

namespace {

constexpr std::array faultNames{"request lost", "reply lost", "reply garbled", "refused",
    "drive gone", "drive gone after", "drive reboots", "stores wrong", "user stops", "late",
    "program dies", "program dies after"};

std::string requestText(const WriteRequest& request)
{
    std::string text = std::to_string(request.dimensionality) + "D, ";
    text += request.table ? request.table->name : "no table";
    for (const std::string& source : request.sources)
        text += ", " + source;
    if (request.persistency)
        text += *request.persistency == Persistency::Persistent ? ", persistent" : ", volatile";
    return text + (request.slot ? ", to " + *request.slot : "");
}

/// Keeps a result's value, or its error.
template <typename T, typename Kept> void keep(Result<T> result, Kept& kept, Ending& ending)
{
    if (result)
        kept = std::move(*result);
    else
        ending.error = result.error();
}

void keepReport(Result<WriteReport> report, Ending& ending)
{
    if (report)
        ending.reports.push_back(std::move(*report));
    else
        ending.error = report.error();
}

} // namespace

std::string mishapName(const Mishap& mishap)
{
    using Kind = drivecomm::FaultSpec::Kind;
    if (mishap.fault)
        return faultNames[static_cast<std::size_t>(*mishap.fault)];
    switch (mishap.onTheWire->kind) {
    case Kind::Garble:
        return "on the wire: garbled";
    case Kind::DropAfter:
        return "on the wire: cut";
    case Kind::RebootAfter:
        return "on the wire: drive reboots";
    default:
        return "on the wire: stores wrong";
    }
}

bool Operation::changesSetup() const
{
    return action == Action::Write || action == Action::SetPersistency || action == Action::Finish
        || action == Action::Undo || isRestore();
}

std::string Operation::text() const
{
    std::string text = "program " + std::to_string(program) + ": "
        + actionNames[static_cast<std::size_t>(action)] + ", axis " + std::to_string(axis);
    if (action == Action::Write || action == Action::Plan)
        text += ", " + requestText(request);
    if (action == Action::SetPersistency)
        text += persistency == Persistency::Persistent ? ", persistent" : ", volatile";
    if (!path.empty())
        text += ", " + path;
    if (mishap)
        text += "; " + mishapName(*mishap) + " at "
            + std::to_string(
                mishap->fault ? mishap->exchange : static_cast<int>(mishap->onTheWire->number));
    return text;
}

std::string Ending::name() const
{
    if (hasDied)
        return "died";
    return error ? std::string(errorName(error->code)) : "done";
}

std::string Ending::text() const
{
    std::string text = error ? describe(*error) : name();
    if (!reports.empty() && !reports.back().now.setup.slot.empty())
        text += ", now in " + reports.back().now.setup.slot;
    return hasStruck ? text + " (it struck)" : text;
}

void carryOut(const Operation& operation, AxisCompensator& compensator,
    const OperationOptions& options, Ending& ending)
{
    const int axis = operation.axis;
    switch (operation.action) {
    case Action::Write:
        return keepReport(compensator.write(axis, operation.request, options), ending);
    case Action::SetPersistency:
        return keepReport(compensator.setPersistency(axis, operation.persistency, options), ending);
    case Action::RestorePrevious:
    case Action::RestoreOld:
        if (auto done = compensator.restore(*operation.backup, false, options); !done)
            ending.error = done.error();
        else
            ending.reports = std::move(done->axes);
        return;
    case Action::Upload:
        if (auto done = compensator.upload(operation.path, operation.file, options); !done)
            ending.error = done.error();
        return;
    case Action::Settle:
        return keep(
            compensator.settleUnfinished(*operation.journal, options), ending.settled, ending);
    case Action::Finish:
        return keepReport(compensator.finishUnfinished(*operation.journal, options), ending);
    case Action::Undo:
        return keepReport(compensator.undoUnfinished(*operation.journal, options), ending);
    case Action::Activate:
        return keep(compensator.activate(axis, options), ending.status, ending);
    case Action::Evaluate:
        return keep(compensator.evaluate(axis, options), ending.status, ending);
    case Action::Deactivate:
        return keep(compensator.deactivate(axis, options), ending.status, ending);
    case Action::Prove:
        if (auto proof = compensator.prove(axis, 2, options); !proof)
            ending.error = proof.error();
        return;
    case Action::Status:
        return keep(compensator.status(axis, options), ending.status, ending);
    case Action::Plan:
        return keep(compensator.plan(axis, operation.request, options), ending.plan, ending);
    case Action::Backup:
        return keep(compensator.backup(options), ending.backup, ending);
    case Action::Download:
        return keep(compensator.download(operation.path, options), ending.file, ending);
    case Action::Reboot:
    case Action::Home:
    case Action::PassTime:
        return; // not by a program
    }
}

} // namespace axiscomp::test
