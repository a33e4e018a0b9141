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

bool WizardController::planMultiAxis(const std::vector<ColumnForAxis>& columns, bool keepsSources)
{
    d->update();
    if (!action(Action::WriteSeveral).isEnabled)
        return false;
    dropSeveral();
    d->planMultiAxis(columns, keepsSources);
    return true;
}

void WizardController::dropSeveral()
{
    d->multiAxis.stop.request_stop();
    ++d->multiAxis.number;
    d->multiAxis.tables.clear();
    d->multiAxis.plans.reset();
}

const std::optional<Result<std::vector<WritePlan>>>& WizardController::multiAxisPlans() const
{
    return d->multiAxis.plans;
}

void WizardController::writeMultiAxis()
{
    d->writeMultiAxis();
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

void WizardController::Private::planMultiAxis(
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
        multiAxis.tables.push_back({column.axis, file.table(column.column), common});
    multiAxis.stop = std::stop_source();
    const auto ask = [tables = multiAxis.tables](
                         AxisCompensator& compensator, const OperationOptions& operation) {
        return planTables(compensator, tables, operation);
    };
    whenDone(connection()->session().run<std::vector<WritePlan>>(ask, multiAxis.stop.get_token()),
        &q, [this, number = multiAxis.number](const Result<std::vector<WritePlan>>& plans) {
            if (number == multiAxis.number)
                multiAxisPlanned(plans);
        });
}

void WizardController::Private::multiAxisPlanned(const Result<std::vector<WritePlan>>& plans)
{
    multiAxis.plans = plans;
    if (!plans && isLinkFailure(plans.error().code))
        axisFailed(plans.error());
    // What has been shown is what is written: a drive that has changed since refuses it.
    for (std::size_t n = 0; plans && n < multiAxis.tables.size(); ++n)
        multiAxis.tables[n].request.expected = plans->at(n).before;
    Q_EMIT q.multiAxisPlanned();
}

/// Of the tables, in their order.
std::vector<AxisEntry> WizardController::Private::multiAxisAxes() const
{
    const std::vector<AxisEntry> usable = usableAxes();
    std::vector<AxisEntry> asked;
    for (const AxisTable& table : multiAxis.tables) {
        const auto entry = std::ranges::find_if(
            usable, [&](const AxisEntry& candidate) { return candidate.axis.index == table.axis; });
        asked.push_back(entry == usable.end() ? AxisEntry() : *entry);
        asked.back().axis.index = table.axis; // also of one that has gone meanwhile
    }
    return asked;
}

void WizardController::Private::multiAxisWritten(const Result<MultiAxisReport>& report)
{
    q.dropSeveral();
    show([axes = multiAxis.axes, isPersistent = multiAxis.isPersistent, report] {
        return multiAxisOutcome(axes, isPersistent, report);
    });
    Q_EMIT q.multiAxisWritten();
}

/// The table of the shown axis when it is among those that were written.
std::optional<LoadedTable> WizardController::Private::writtenToShownAxis(
    const Result<MultiAxisReport>& report) const
{
    for (std::size_t n = 0; report && n < report->writes.size(); ++n) {
        if (multiAxis.tables[n].axis == current->axis && holdsNewState(report->writes[n]))
            return multiAxis.tables[n].table;
    }
    return {};
}

} // namespace axiscomp::ui
