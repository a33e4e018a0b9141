// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/machine_application.h"

#include "core/machine/machine_texts.h"
#include "core/text/utf8.h"
#include "ui/text/message_text.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <utility>

namespace axiscomp::ui {

namespace {

struct Totals {
    QStringList written;
    QStringList switched;
    QStringList notProved; ///< of those
    QStringList failed;
    QStringList notWritten;
    QStringList notSwitched;
    std::optional<Error> first;

    void add(const QString& name, const AxisOutcome& outcome);
};

/// An axis that is switched as wanted may still await its write, and the other way round.
void Totals::add(const QString& name, const AxisOutcome& outcome)
{
    if (outcome.problem) {
        failed += name;
        first = first ? first : outcome.problem;
        return;
    }
    if (outcome.report)
        written += name;
    if (outcome.activation)
        switched += name;
    if (outcome.activation && outcome.activation->notProved())
        notProved += name;
    if (outcome.awaitsWrite)
        notWritten += name;
    if (outcome.awaitsSwitch)
        notSwitched += name;
}

LogLine::Kind kindOf(const AxisOutcome& outcome)
{
    if (outcome.problem)
        return LogLine::Kind::Error;
    const bool isProofMissing = outcome.activation && outcome.activation->notProved();
    return isProofMissing ? LogLine::Kind::Warning : LogLine::Kind::Information;
}

Totals totalsOf(const std::vector<MachineApplication::Written>& drives)
{
    Totals totals;
    for (const MachineApplication::Written& drive : drives) {
        if (drive.problem) {
            totals.failed += drive.planned.name;
            totals.first = totals.first ? totals.first : drive.problem;
        }
        for (std::size_t n = 0; n < drive.outcomes.size(); ++n)
            totals.add(axisOfDriveText(drive.planned.name, drive.planned.look->plan->axes[n].name),
                drive.outcomes[n]);
    }
    return totals;
}

class ApplicationOutcome {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::MachineApplication)

public:
    [[nodiscard]] static Outcome of(
        const QString& file, const std::vector<MachineApplication::Written>& drives)
    {
        const Totals totals = totalsOf(drives);
        const QStringList done = doneIn(totals);
        if (!totals.first && done.isEmpty())
            return {tr("All drives already had what %1 says; nothing was written.").arg(file),
                false, {}};
        if (!totals.first)
            return {(QStringList{tr("%1 is applied.").arg(file)} + done).join(u' '), false, {},
                !totals.notProved.isEmpty()};
        QStringList sentences{
            tr("%1 is not applied as a whole: %2").arg(file, errorText(*totals.first)),
            tr("Failed: %1.").arg(listText(totals.failed))};
        sentences += done;
        if (!totals.notWritten.isEmpty())
            sentences += tr("Not written: %1.").arg(listText(totals.notWritten));
        if (!totals.notSwitched.isEmpty())
            sentences += tr("Not switched: %1.").arg(listText(totals.notSwitched));
        sentences += tr("Applying it again does the rest.");
        return {sentences.join(u' '), true, errorOutcome(*totals.first).detail};
    }
    [[nodiscard]] static QString ofAxis(
        const QString& drive, const AxisPlan& plan, const AxisOutcome& outcome)
    {
        const QString name = axisOfDriveText(drive, plan.name);
        const QString what = translated(outcomeText(outcome));
        const QString said = outcome.now
            ? tr("%1: %2; it holds: %3.", "axis, what became of it, and its table")
                  .arg(name, what, translated(heldText(*outcome.now)))
            : tr("%1: %2; what it holds is not known.", "axis, and what became of it")
                  .arg(name, what);
        const QString more = outcome.problem ? errorText(*outcome.problem)
            : outcome.activation             ? proofText(*outcome.activation)
                                             : QString();
        return more.isEmpty() ? said : said + u' ' + more;
    }

private:
    [[nodiscard]] static QStringList doneIn(const Totals& totals)
    {
        QStringList sentences;
        if (!totals.written.isEmpty())
            sentences += tr("Written and verified: %1.").arg(listText(totals.written));
        if (!totals.switched.isEmpty())
            sentences += tr("Switched: %1.").arg(listText(totals.switched));
        if (!totals.notProved.isEmpty())
            sentences += tr("Not proved: %1.").arg(listText(totals.notProved));
        return sentences;
    }
};

} // namespace

MachineApplication::MachineApplication(DriveList& drives, AxisState& axis, OperationRunner& runner,
    WizardLog& log, LastOutcome& outcome)
    : m_drives(drives)
    , m_axis(axis)
    , m_runner(runner)
    , m_log(log)
    , m_outcome(outcome)
{
    connect(&drives, &DriveList::progressed, this, &MachineApplication::showProgress);
    connect(&drives, &DriveList::removed, this, &MachineApplication::abandon);
    // The outcome of the current drive is shown before that of all drives together.
    connect(&runner, &OperationRunner::ended, this, &MachineApplication::endWhenDone);
    connect(&runner, &OperationRunner::busyChanged, this, &MachineApplication::endWhenDone);
}

MachineApplication::~MachineApplication()
{
    m_stop.request_stop();
}

bool MachineApplication::isRunning() const
{
    return std::ranges::any_of(m_written, &Written::isUnderWay);
}

void MachineApplication::start(
    const QString& fileName, std::vector<Planned> drives, const MachineContext& context)
{
    ++m_run;
    m_fileName = fileName;
    m_isEnded = false;
    m_stop = std::stop_source();
    m_written.clear();
    for (Planned& planned : drives) {
        m_written.emplace_back();
        m_written.back().planned = std::move(planned);
        m_written.back().isUnderWay = true;
    }
    m_log.add(LogLine::Kind::Information,
        [fileName] { return tr("Begin: applying the machine file %1.").arg(fileName); });
    for (std::size_t n = 0; n < m_written.size(); ++n) {
        DriveConnection* connection = m_drives.connectionTo(m_written[n].planned.endpoint);
        if (!connection || !connection->isConnected())
            take(n, fail(connectionEndedTo(m_written[n].planned.endpoint)));
        else if (connection == m_drives.connection() && m_drives.hasCurrent())
            beginCurrent(n, context);
        else
            begin(n, context);
    }
    Q_EMIT started();
    Q_EMIT progressed();
    endWhenDone();
}

Result<MachineApplication::Outcomes> MachineApplication::applied(AxisCompensator& compensator,
    const DrivePlan& plan, const MachineContext& context, const OperationOptions& options)
{
    AXISCOMP_TRY(auto outcomes, applyPlan(compensator, plan, context, options));
    return std::make_shared<const std::vector<AxisOutcome>>(std::move(outcomes));
}

void MachineApplication::begin(std::size_t index, const MachineContext& context)
{
    DriveSession& session = m_drives.connectionTo(m_written[index].planned.endpoint)->session();
    MachineContext own = context;
    own.storeRoot = session.storeRoot();
    const auto apply = [look = m_written[index].planned.look, own](AxisCompensator& compensator,
                           const OperationOptions& options) -> Result<Outcomes> {
        return applied(compensator, *look->plan, own, options);
    };
    whenDone(session.run<Outcomes>(apply, m_stop.get_token()), this,
        [this, index, run = m_run](const Result<Outcomes>& outcomes) {
            if (run != m_run || !m_written[index].isUnderWay)
                return;
            take(index, outcomes);
            endWhenDone();
        });
}

/// The page sees that its drive is busy, and takes what the axis has afterwards as its own doing.
void MachineApplication::beginCurrent(std::size_t index, const MachineContext& context)
{
    const Planned& planned = m_written[index].planned;
    const auto look = planned.look;
    m_runner.run<Outcomes>(
        Task::WriteSeveral,
        [look, context, shown = m_drives.currentAxis()](AxisCompensator& compensator,
            const std::filesystem::path& store, const OperationOptions& options) {
            MachineContext own = context;
            own.storeRoot = store;
            Result<Outcomes> outcomes = applied(compensator, *look->plan, own, options);
            OperationOptions quiet = options;
            quiet.stop = {};
            quiet.progress = {};
            return OperationEnd<Outcomes>{
                std::move(outcomes), readAxis(compensator, store, shown, quiet)};
        },
        [this, index, run = m_run](const OperationEnd<Outcomes>& end) {
            m_runner.expect({}); // what the axis has now is downloaded
            m_axis.take(end.now);
            if (run == m_run && m_written[index].isUnderWay)
                take(index, end.outcome);
        },
        [planned, file = m_fileName](const Result<Outcomes>& outcomes) {
            Written written;
            written.planned = planned;
            if (outcomes)
                written.outcomes = **outcomes;
            else
                written.problem = outcomes.error();
            return ApplicationOutcome::of(file, {written});
        },
        [name = planned.name] { return name; });
}

void MachineApplication::take(std::size_t index, const Result<Outcomes>& outcomes)
{
    Written& written = m_written[index];
    written.isUnderWay = false;
    if (outcomes)
        written.outcomes = **outcomes;
    else
        written.problem = outcomes.error();
    note(written);
    tellColumns(written);
    if (DriveConnection* connection = m_drives.connectionTo(written.planned.endpoint);
        connection && written.problem && isLinkFailure(written.problem->code))
        connection->lose(*written.problem);
    Q_EMIT progressed();
}

/// What was written to each axis stays in the log.
void MachineApplication::note(const Written& written)
{
    const Planned& planned = written.planned;
    if (written.problem)
        m_log.add(LogLine::Kind::Error, [name = planned.name, error = *written.problem] {
            return tr("%1: %2", "drive and problem").arg(name, errorText(error));
        });
    for (std::size_t n = 0; n < written.outcomes.size(); ++n)
        m_log.add(kindOf(written.outcomes[n]), [planned, n, outcome = written.outcomes[n]] {
            return ApplicationOutcome::ofAxis(planned.name, planned.look->plan->axes[n], outcome);
        });
}

void MachineApplication::tellColumns(const Written& written)
{
    const Planned& planned = written.planned;
    for (std::size_t n = 0; n < written.outcomes.size(); ++n) {
        const auto& report = written.outcomes[n].report;
        const auto& table = planned.look->plan->axes[n].request.table;
        const QString file = planned.files.value(static_cast<qsizetype>(n));
        if (report && table && !file.isEmpty())
            Q_EMIT columnWritten(
                planned.endpoint, report->now, file, QString::fromStdString(table->name));
    }
}

void MachineApplication::endWhenDone()
{
    if (m_isEnded || isRunning() || m_runner.task())
        return;
    m_isEnded = true;
    m_outcome.show(
        [file = m_fileName, drives = m_written] { return ApplicationOutcome::of(file, drives); });
    Q_EMIT ended();
}

void MachineApplication::stop()
{
    if (!isRunning() || m_stop.stop_requested())
        return;
    m_stop.request_stop();
    if (m_runner.task() == Task::WriteSeveral)
        m_runner.cancel();
    Q_EMIT progressed();
}

void MachineApplication::showProgress(
    const DriveConnection* of, const QString& step, double fraction)
{
    for (Written& written : m_written) {
        if (!written.isUnderWay || m_drives.connectionTo(written.planned.endpoint) != of)
            continue;
        written.step = step;
        written.fraction = fraction;
        Q_EMIT progressed();
    }
}

/// Nobody says any more what becomes of it.
void MachineApplication::abandon(const DriveConnection* connection)
{
    for (std::size_t n = 0; n < m_written.size(); ++n)
        if (m_written[n].isUnderWay && m_written[n].planned.endpoint == connection->endpoint())
            take(n, fail(connectionEndedTo(connection->endpoint())));
    endWhenDone();
}

double MachineApplication::fraction() const
{
    if (m_written.empty())
        return 0.0;
    double sum = 0.0;
    for (const Written& written : m_written)
        sum += written.isUnderWay ? std::min(written.fraction, 0.99) : 1.0;
    return sum / static_cast<double>(m_written.size());
}

Outcome MachineApplication::outcome() const
{
    return ApplicationOutcome::of(m_fileName, m_written);
}

QString axisOfDriveText(const QString& drive, const std::string& axis)
{
    return qString(shownText(axis)) + QStringLiteral(" · ") + drive;
}

} // namespace axiscomp::ui
