// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "ui/controller/wizard_controller_p.h"
#include "ui/text/message_text.h"

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

WizardController::Private::SourceField& WizardController::Private::sourceField(int dimension)
{
    return sourceFields.at(static_cast<std::size_t>(dimension - 1));
}

void WizardController::Private::chooseSource(int dimension, const QString& text)
{
    SourceField& field = sourceField(dimension);
    ++field.check;
    field.isBeingChecked = false;
    field.problem = nullptr;
    const QString wanted = text.trimmed();
    DriveConnection* drive = connection();
    const auto notConnected = [] {
        return tr("The drive is not connected: the source cannot be checked.");
    };
    if (wanted.isEmpty()) {
        acceptSource(dimension, {});
        return;
    }
    if (!drive || !drive->findings()) {
        refuseSource(dimension, notConnected);
        return;
    }
    const DriveFindings& findings = *drive->findings();
    const auto known = std::ranges::find_if(findings.sources,
        [&](const DimSource& source) { return isWrittenAs(source, findings.drive.name, wanted); });
    if (known != findings.sources.end()) {
        acceptSource(dimension, *known);
        return;
    }
    if (!drive->isConnected()) {
        refuseSource(dimension, notConnected);
        return;
    }
    field.isBeingChecked = true;
    const auto resolve = [source = wanted.toStdString()](
                             AxisCompensator& compensator, const OperationOptions& operation) {
        return compensator.resolveSource(source, operation);
    };
    whenDone(drive->session().run<DimSource>(resolve), &q,
        [this, dimension, check = field.check, drive = QPointer<DriveConnection>(drive)](
            const Result<DimSource>& source) {
            if (!source && isLinkFailure(source.error().code) && drive)
                drive->lose(source.error());
            if (check != sourceField(dimension).check)
                return;
            if (source)
                acceptSource(dimension, *source);
            else
                refuseSource(dimension, [error = source.error()] { return errorText(error); });
        });
    Q_EMIT q.sourceChecked(dimension);
    update();
}

void WizardController::Private::acceptSource(int dimension, const DimSource& source)
{
    const EditedSetup& edited = setup.edited();
    for (int other = 1; other <= edited.dimensionality && source.isSet(); ++other) {
        if (other == dimension || !(edited.sources[static_cast<std::size_t>(other - 1)] == source))
            continue;
        const auto [first, second] = std::minmax(dimension, other);
        const Error error{ErrorCode::SourceRepeated,
            {{"source", source.path}, {"first", std::to_string(first)},
                {"second", std::to_string(second)}},
            {}};
        refuseSource(dimension, [error] { return errorText(error); });
        return;
    }
    SourceField& field = sourceField(dimension);
    field.isBeingChecked = false;
    field.problem = nullptr;
    setup.setSource(dimension, source);
    Q_EMIT q.sourceChecked(dimension);
    update();
}

void WizardController::Private::refuseSource(int dimension, const Wording& problem)
{
    SourceField& field = sourceField(dimension);
    field.isBeingChecked = false;
    field.problem = problem;
    log(LogLine::Kind::Warning, problem);
    Q_EMIT q.sourceChecked(dimension);
    update();
}

void WizardController::Private::forgetSourceProblems()
{
    for (int dimension = 1; dimension <= 3; ++dimension) {
        SourceField& field = sourceField(dimension);
        const bool isNews = field.isBeingChecked || field.problem;
        ++field.check;
        field.isBeingChecked = false;
        field.problem = nullptr;
        if (isNews)
            Q_EMIT q.sourceChecked(dimension);
    }
}

} // namespace axiscomp::ui
