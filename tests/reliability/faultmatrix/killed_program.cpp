// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reliability/faultmatrix/killed_program.h"
#include "tests/support/patience.h"

#include "tests/app/program_run.h"

#include <QFile>

#include <atomic>
#include <csignal>

namespace axiscomp::test {

namespace {

/// The program as a user of a drive has it: its files, its memory, and the drive's address.
class ProgramFixture {
public:
    explicit ProgramFixture(const KilledProgram& program)
        : m_kind(program.kind)
        , trial(*program.scenario)
        , served(m_kind.attach(trial.drive, trial.faults))
    {
        // The store of the trial, which made the old state.
        m_box.setVariable(QStringLiteral("XDG_STATE_HOME"), trial.folder.path());
        if (trial.scenario().deletes)
            return;
        const auto file =
            encodeTamTable(*trial.fullRequest().table, false, drivecomm::genericProfile().layout);
        m_data = m_box.file(QStringLiteral("new.TAMtbl"), asByteArray(*file));
    }

    [[nodiscard]] QStringList writeArguments(bool withTable) const
    {
        if (trial.scenario().deletes)
            return {"delete", "--drive", url(), "--axis", "0"};
        const WriteRequest request = trial.fullRequest();
        QStringList arguments{"write", "--drive", url(), "--axis", "0", "--dims", "2", "--source1",
            QString::fromStdString(request.sources[0]), "--source2",
            QString::fromStdString(request.sources[1])};
        if (withTable)
            arguments << "--data" << m_data;
        const bool isPersistent = trial.scenario().after == Persistency::Persistent;
        arguments << (isPersistent ? "--persistent" : "--volatile");
        return arguments;
    }
    [[nodiscard]] std::unique_ptr<QProcess> startWrite() const
    {
        return m_box.start(axiscompProgram(), writeArguments(!trial.scenario().keepsTable));
    }
    [[nodiscard]] ProgramRun writeAgain() const { return m_box.run(writeArguments(true)); }
    [[nodiscard]] ProgramRun status() const
    {
        return m_box.run({"status", "--drive", url(), "--axis", "0", "--json"});
    }
    /// Every request that has reached the drive is carried out.
    void settle()
    {
        if (m_kind.servesInOrder)
            return; // the next program asks after it
        served.reset();
        served = m_kind.attach(trial.drive, trial.faults);
    }

private:
    static QByteArray asByteArray(ByteView bytes)
    {
        return QByteArray::fromStdString(std::string(asText(bytes)));
    }
    [[nodiscard]] QString url() const { return QString::fromStdString(served->url()); }

    AttachmentKind m_kind;
    Sandbox m_box;
    QString m_data;

public:
    WriteTrial trial;
    std::unique_ptr<LinkAttachment> served;
};

/// "driveHolds" of `status` against what the drive holds.
std::string judgeStatus(const ProgramRun& status, WriteTrial& trial, const HeldStates& states)
{
    if (status.code != 0)
        return "status failed: " + status.text().toStdString();
    const CompensatorFixture::State now = trial.state();
    const QString held =
        status.json().value("unfinishedWrite").toObject().value("driveHolds").toString();
    const bool isTrue = held.isEmpty() || held == "Old" ? now == states.old
        : held == "New" || held == "NewUnsaved"         ? trial.isNew(now, states)
        : held == "Neither"                             ? trial.isSwitchedOff(now)
                                                        : false;
    if (!isTrue)
        return "status said \"" + held.toStdString() + "\", " + trial.stateText(now, states);
    if (trial.text("Axes[0]/Signals/Compensations/Axis/State") != "Disabled")
        return "the compensation is on";
    return {};
}

} // namespace

RecordedProgram recordProgram(const KilledProgram& program)
{
    ProgramFixture bench(program);
    RecordedProgram recorded;
    recorded.wrong = bench.trial.unready();
    recorded.states.old = bench.trial.state();
    bench.trial.requested = [&](bool) { ++recorded.requests; };
    const auto process = bench.startWrite();
    const bool hasEnded = process->waitForFinished(patienceMs);
    bench.settle();
    bench.trial.requested = {};
    if (!hasEnded || process->exitStatus() != QProcess::NormalExit || process->exitCode() != 0)
        recorded.wrong = "the write failed: " + process->readAllStandardError().toStdString();
    recorded.states.wanted = bench.trial.state();
    return recorded;
}

std::string runKilled(const KilledProgram& program, const RecordedProgram& recorded, int request)
{
    ProgramFixture bench(program);
    if (!bench.trial.unready().empty())
        return bench.trial.unready();
    std::atomic<pid_t> id = 0;
    std::atomic<int> seen = 0;
    bench.trial.requested = [&](bool) {
        if (++seen != request)
            return;
        id.wait(0); // the program may be quicker than who started it
        ::kill(id, SIGKILL);
        if (program.isRequestLost)
            bench.trial.faults.add({drivecomm::FaultSpec::Kind::Reject, 0, "DriveRejected"});
    };
    const auto process = bench.startWrite();
    id = static_cast<pid_t>(process->processId());
    id.notify_all();
    const bool hasEnded = process->waitForFinished(patienceMs);
    if (!hasEnded || process->exitStatus() != QProcess::CrashExit)
        return "the program was not killed: " + process->readAllStandardError().toStdString();
    bench.settle();
    const ProgramRun status = bench.status();
    bench.trial.faults.clear();
    if (auto wrong = judgeStatus(status, bench.trial, recorded.states); !wrong.empty())
        return wrong;
    const ProgramRun again = bench.writeAgain();
    // It may have been deleted already.
    const bool isThere = program.scenario->deletes && again.err.startsWith("error: NoTable");
    if (again.code != 0 && !isThere)
        return "the next write failed: " + again.text().toStdString();
    bench.settle();
    if (!bench.trial.holdsWanted(recorded.states))
        return "after the next write "
            + bench.trial.stateText(bench.trial.state(), recorded.states);
    return {};
}

} // namespace axiscomp::test
