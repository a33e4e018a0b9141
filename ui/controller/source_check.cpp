// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/source_check.h"

#include "ui/async/background_job.h"
#include "ui/text/message_text.h"

#include <QPointer>

#include <algorithm>

namespace axiscomp::ui {

namespace {

/// As a person may have written it: path, URI or address.
bool isWrittenAs(const DimSource& source, const std::string& drive, const QString& text)
{
    const std::string written = text.toStdString();
    return normalisedPath(written) == source.path || written == sourceUri(drive, source.path)
        || text.compare(QStringLiteral("0x%1").arg(source.address, 0, 16), Qt::CaseInsensitive)
        == 0;
}

} // namespace

SourceCheck::SourceCheck(const DriveList& drives, SetupModel& setup, WizardLog& log)
    : m_drives(drives)
    , m_setup(setup)
    , m_log(log)
{
}

SourceCheck::Pending& SourceCheck::pending(int dimension)
{
    return m_pending.at(static_cast<std::size_t>(dimension - 1));
}

bool SourceCheck::isBeingChecked(int dimension) const
{
    return m_pending.at(static_cast<std::size_t>(dimension - 1)).isBeingChecked;
}

void SourceCheck::choose(int dimension, const QString& text)
{
    const int number = ++pending(dimension).number;
    const QString wanted = text.trimmed();
    if (wanted.isEmpty()) {
        accept(dimension, {});
        return;
    }
    DriveConnection* drive = m_drives.connection();
    if (drive && drive->findings()) {
        const DriveFindings& findings = *drive->findings();
        const auto known = std::ranges::find_if(findings.sources, [&](const DimSource& source) {
            return isWrittenAs(source, findings.drive.name, wanted);
        });
        if (known != findings.sources.end()) {
            accept(dimension, *known);
            return;
        }
    }
    if (!drive || !drive->findings() || !drive->isConnected()) {
        refuse(dimension,
            [] { return tr("The drive is not connected: the source cannot be checked."); });
        return;
    }
    pending(dimension).isBeingChecked = true;
    m_setup.setProblem(sourceField(dimension), nullptr);
    const auto resolve = [source = wanted.toStdString()](
                             AxisCompensator& compensator, const OperationOptions& operation) {
        return compensator.resolveSource(source, operation);
    };
    whenDone(drive->session().run<DimSource>(resolve), this,
        [this, dimension, number, drive = QPointer<DriveConnection>(drive)](
            const Result<DimSource>& source) {
            if (!source && isLinkFailure(source.error().code) && drive)
                drive->lose(source.error());
            if (number != pending(dimension).number)
                return;
            if (source)
                accept(dimension, *source);
            else
                refuse(dimension, [error = source.error()] { return errorText(error); });
        });
    Q_EMIT checked(dimension);
}

void SourceCheck::accept(int dimension, const DimSource& source)
{
    const EditedSetup& edited = m_setup.edited();
    for (int other = 1; other <= edited.dimensionality && source.isSet(); ++other) {
        if (other == dimension || !(edited.sources[static_cast<std::size_t>(other - 1)] == source))
            continue;
        const auto [first, second] = std::minmax(dimension, other);
        const Error error{ErrorCode::SourceRepeated,
            {{"source", source.path}, {"first", first}, {"second", second}}, {}};
        refuse(dimension, [error] { return errorText(error); });
        return;
    }
    pending(dimension).isBeingChecked = false;
    m_setup.setProblem(sourceField(dimension), nullptr);
    m_setup.setSource(dimension, source);
    Q_EMIT checked(dimension);
}

void SourceCheck::refuse(int dimension, const Wording& problem)
{
    pending(dimension).isBeingChecked = false;
    m_setup.setProblem(sourceField(dimension), problem);
    m_log.add(LogLine::Kind::Warning, problem);
    Q_EMIT checked(dimension);
}

void SourceCheck::forgetProblem(int dimension)
{
    Pending& check = pending(dimension);
    const Field field = sourceField(dimension);
    const bool isNews = check.isBeingChecked || !m_setup.problem(field).isEmpty();
    ++check.number;
    check.isBeingChecked = false;
    m_setup.setProblem(field, nullptr);
    if (isNews)
        Q_EMIT checked(dimension);
}

void SourceCheck::forget()
{
    for (int dimension = 1; dimension <= 3; ++dimension)
        forgetProblem(dimension);
}

void SourceCheck::retranslate()
{
    for (int dimension = 1; dimension <= 3; ++dimension) {
        if (!m_setup.problem(sourceField(dimension)).isEmpty())
            Q_EMIT checked(dimension);
    }
}

} // namespace axiscomp::ui
