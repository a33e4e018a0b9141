// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/wizard_controller_p.h"
#include "ui/session/axis_list.h"
#include "ui/text/endpoint_text.h"
#include "ui/text/message_text.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

/// Without empty ones, and one per drive address: the last one, whose password is the newest.
QStringList cleaned(const QStringList& endpoints)
{
    QStringList clean;
    for (const QString& endpoint : endpoints) {
        const QString text = endpoint.trimmed();
        if (text.isEmpty())
            continue;
        const auto known = std::ranges::find(clean, shownEndpoint(text), shownEndpoint);
        if (known == clean.end())
            clean.append(text);
        else
            *known = text;
    }
    return clean;
}

} // namespace

void WizardController::Private::setEndpoints(const QStringList& wanted)
{
    const QStringList endpoints = cleaned(wanted);
    const std::vector<DriveConnection*> before = connections;
    for (DriveConnection* connection : before) {
        if (!endpoints.contains(connection->endpointAsGiven()))
            removeConnection(connection);
    }
    std::vector<DriveConnection*> ordered;
    for (const QString& endpoint : endpoints) {
        const auto known = std::ranges::find(
            connections, endpoint, [](const DriveConnection* c) { return c->endpointAsGiven(); });
        ordered.push_back(known == connections.end() ? addConnection(endpoint) : *known);
    }
    connections = std::move(ordered);
    listDrives();
    listAxes();
}

DriveConnection* WizardController::Private::addConnection(const QString& endpoint)
{
    auto* added = new DriveConnection(endpoint, options.linkFactory, profile, options.storeRoot,
        options.timeout, options.reconnectInterval, &q);
    connect(added, &DriveConnection::stateChanged, &q, [this] {
        listDrives();
        listAxes();
    });
    connect(added, &DriveConnection::found, &q,
        [this, added](bool wasAnother) { driveFound(added, wasAnother); });
    connect(added, &DriveConnection::lost, &q,
        [this, added](const Error& error) { driveLost(added, error); });
    connect(&added->session(), &DriveSession::progressed, &q,
        [this, added](
            const QString& step, double fraction) { showProgress(added, step, fraction); });
    added->explore();
    return added;
}

void WizardController::Private::removeConnection(DriveConnection* removed)
{
    std::erase(connections, removed);
    if (taskConnection == removed) {
        taskConnection.clear();
        taskStop.request_stop();
        endTask();
    }
    if (current && current->endpoint == removed->endpoint())
        leaveAxis();
    removed->retire();
}

/// Nothing is chosen any more.
void WizardController::Private::leaveAxis()
{
    current.reset();
    currentIndex = -1;
    ++reading;
    status.reset();
    unfinished.reset();
    flashUse.reset();
    hasBackup = false;
    hasCompensation = true;
    readProblem.reset();
    liveProblem.reset();
    plan.reset();
    proof.reset();
    readAgain.stop();
    live.watch(nullptr, 0);
    driveTable.clear();
    isLeaving = true;
    setup.clear();
    isLeaving = false;
    forgetSourceProblems();
}

void WizardController::Private::listDrives()
{
    std::vector<DriveState> now;
    for (const DriveConnection* connection : connections)
        now.push_back(connection->state());
    if (now == drives)
        return;
    drives = std::move(now);
    Q_EMIT q.drivesChanged();
    update();
}

void WizardController::Private::nameAxes()
{
    std::vector<DriveAxes> found;
    for (const DriveConnection* connection : connections)
        found.push_back(connection->axes());
    axes = axisEntries(found);
}

/// The entries may have moved: the current axis is found again by its drive and index.
void WizardController::Private::listAxes()
{
    nameAxes();
    const auto position = std::ranges::find_if(axes, [this](const AxisEntry& entry) {
        return current == AxisKey{entry.endpoint, entry.axis.index};
    });
    const int before = currentIndex;
    currentIndex = position == axes.end() ? -1 : static_cast<int>(position - axes.begin());
    if (current && currentIndex < 0)
        leaveAxis();
    Q_EMIT q.axesChanged();
    if (!current) {
        const auto usable = std::ranges::find_if(axes, &AxisEntry::isUsable);
        if (usable != axes.end()) {
            select(*usable);
            return;
        }
    }
    if (currentIndex != before)
        Q_EMIT q.currentAxisChanged();
    update();
}

void WizardController::Private::select(const AxisEntry& entry)
{
    // Before the first axis a file can be open, and one of its tables chosen.
    if (current)
        leaveAxis();
    else
        forgetSourceProblems();
    const AxisKey key{entry.endpoint, entry.axis.index};
    current = key;
    const auto position = std::ranges::find_if(axes, [&key](const AxisEntry& other) {
        return AxisKey{other.endpoint, other.axis.index} == key;
    });
    currentIndex = static_cast<int>(position - axes.begin());
    hasCompensation = position->axis.hasCompensation();
    dismissOutcome();
    live.watch(connection(), key.axis);
    Q_EMIT q.currentAxisChanged();
    Q_EMIT q.statusChanged();
    readAxisNow();
    noteSelectedTable();
    update();
}

DriveConnection* WizardController::Private::connectionOf(const QString& endpoint) const
{
    const auto found = std::ranges::find(
        connections, endpoint, [](const DriveConnection* c) { return c->endpoint(); });
    return found == connections.end() ? nullptr : *found;
}

DriveConnection* WizardController::Private::connection() const
{
    return current ? connectionOf(current->endpoint) : nullptr;
}

void WizardController::Private::driveFound(DriveConnection* found, bool wasAnother)
{
    const QString name = found->name();
    const QString endpoint = found->endpoint();
    log(LogLine::Kind::Information,
        [name, endpoint] { return tr("Connected to %1 (%2).").arg(name, endpoint); });
    if (found != connection())
        return;
    if (wasAnother) {
        // Changes were made for another machine.
        const AxisKey key = *current;
        leaveAxis();
        current = key;
        listAxes();
        if (current != key)
            return;
        hasCompensation = axes[static_cast<std::size_t>(currentIndex)].axis.hasCompensation();
        live.watch(found, key.axis);
        refuse([name, endpoint] {
            return tr("A different drive now answers at %1: %2. Unwritten changes were discarded.")
                .arg(endpoint, name);
        });
        Q_EMIT q.statusChanged();
    }
    readAxisNow();
}

void WizardController::Private::driveLost(DriveConnection* lost, const Error& error)
{
    log(
        LogLine::Kind::Error, [error] { return errorText(error); },
        lost->endpoint() + QStringLiteral(": ") + errorOutcome(error).detail);
    update();
}

} // namespace axiscomp::ui
