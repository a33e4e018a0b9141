// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "ui/controller/multi_axis_outcome.h"
#include "ui/controller/wizard_controller_p.h"

#include <algorithm>

namespace axiscomp::ui {

std::vector<AxisEntry> WizardController::usableAxes() const
{
    return d->usableAxes();
}

std::vector<DimSource> WizardController::sourcesForSeveral() const
{
    const auto& data = d->file.file().data;
    const EditedSetup& edited = d->setup.edited();
    std::vector<DimSource> sources;
    const auto count = data ? static_cast<std::size_t>(data->grid.dimensions()) : 0;
    for (std::size_t n = 0; n < count; ++n) {
        if (!edited.sources.at(n).isSet())
            return {};
        sources.push_back(edited.sources[n]);
    }
    return sources;
}

bool WizardController::planSeveral(const std::vector<ColumnForAxis>& columns, bool keepsSources)
{
    d->update();
    if (!action(Action::WriteSeveral).isEnabled)
        return false;
    dropSeveral();
    d->planSeveral(columns, keepsSources);
    return true;
}

void WizardController::dropSeveral()
{
    d->several.stop.request_stop();
    ++d->several.number;
    d->several.tables.clear();
    d->several.plans.reset();
}

const std::optional<Result<std::vector<WritePlan>>>& WizardController::severalPlans() const
{
    return d->several.plans;
}

void WizardController::writeSeveral()
{
    d->writeSeveral();
}

std::vector<AxisEntry> WizardController::Private::usableAxes() const
{
    std::vector<AxisEntry> usable;
    if (!current)
        return usable;
    std::ranges::copy_if(axes, std::back_inserter(usable), [this](const AxisEntry& entry) {
        return entry.isUsable && entry.endpoint == current->endpoint;
    });
    return usable;
}

void WizardController::Private::planSeveral(
    const std::vector<ColumnForAxis>& columns, bool keepsSources)
{
    WriteRequest common;
    common.dimensionality = file.file().data->grid.dimensions();
    common.persistency = setup.edited().persistency;
    if (!keepsSources) {
        for (const DimSource& source : q.sourcesForSeveral())
            common.sources.push_back(requestedSource(source));
    }
    for (const ColumnForAxis& column : columns)
        several.tables.push_back({column.axis, file.table(column.column), common});
    several.stop = std::stop_source();
    const auto ask = [tables = several.tables](
                         AxisCompensator& compensator, const OperationOptions& operation) {
        return planTables(compensator, tables, operation);
    };
    whenDone(connection()->session().run<std::vector<WritePlan>>(ask, several.stop.get_token()), &q,
        [this, number = several.number](const Result<std::vector<WritePlan>>& plans) {
            if (number == several.number)
                severalPlanned(plans);
        });
}

void WizardController::Private::severalPlanned(const Result<std::vector<WritePlan>>& plans)
{
    several.plans = plans;
    if (!plans && isLinkFailure(plans.error().code))
        axisFailed(plans.error());
    // What has been shown is what is written: a drive that has changed since refuses it.
    for (std::size_t n = 0; plans && n < several.tables.size(); ++n)
        several.tables[n].request.expected = plans->at(n).before;
    Q_EMIT q.severalPlanned();
}

/// Of the tables, in their order.
std::vector<AxisEntry> WizardController::Private::severalAxes() const
{
    const std::vector<AxisEntry> usable = usableAxes();
    std::vector<AxisEntry> asked;
    for (const AxisTable& table : several.tables) {
        const auto entry = std::ranges::find_if(
            usable, [&](const AxisEntry& candidate) { return candidate.axis.index == table.axis; });
        asked.push_back(entry == usable.end() ? AxisEntry() : *entry);
        asked.back().axis.index = table.axis; // also of one that has gone meanwhile
    }
    return asked;
}

void WizardController::Private::severalWritten(const Result<SeveralReport>& report)
{
    q.dropSeveral();
    show([axes = several.axes, isPersistent = several.isPersistent, report] {
        return severalOutcome(axes, isPersistent, report);
    });
    Q_EMIT q.severalWritten();
}

/// The table of the shown axis when it is among those that were written.
std::optional<SurveyedTable> WizardController::Private::writtenToShownAxis(
    const Result<SeveralReport>& report) const
{
    for (std::size_t n = 0; report && n < report->writes.size(); ++n) {
        if (several.tables[n].axis == current->axis && holdsNewState(report->writes[n]))
            return several.tables[n].table;
    }
    return {};
}

} // namespace axiscomp::ui
