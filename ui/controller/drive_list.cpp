// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/drive_list.h"

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

DriveList::DriveList(const WizardOptions& options, WizardLog& log, LastOutcome& outcome)
    : m_options(options)
    , m_log(log)
    , m_outcome(outcome)
{
}

DriveList::~DriveList()
{
    const auto all = findChildren<DriveConnection*>(QString(), Qt::FindDirectChildrenOnly);
    for (DriveConnection* connection : all) {
        connection->disconnect(this);
        connection->close();
    }
    for (DriveConnection* connection : all)
        delete connection;
}

void DriveList::setEndpoints(const QStringList& wanted)
{
    const QStringList endpoints = cleaned(wanted);
    const std::vector<DriveConnection*> before = m_connections;
    for (DriveConnection* connection : before) {
        if (!endpoints.contains(connection->endpointAsGiven()))
            remove(connection);
    }
    std::vector<DriveConnection*> ordered;
    for (const QString& endpoint : endpoints) {
        const auto known =
            std::ranges::find(m_connections, endpoint, &DriveConnection::endpointAsGiven);
        ordered.push_back(known == m_connections.end() ? add(endpoint) : *known);
    }
    m_connections = std::move(ordered);
    listDrives();
    listAxes();
}

QStringList DriveList::endpoints() const
{
    QStringList endpoints;
    for (const DriveConnection* connection : m_connections)
        endpoints.append(connection->endpointAsGiven());
    return endpoints;
}

void DriveList::refresh()
{
    for (DriveConnection* connection : m_connections)
        connection->explore();
}

void DriveList::tryAgain(const QString& endpoint)
{
    if (DriveConnection* found = connectionTo(endpoint))
        found->tryAgain();
}

DriveConnection* DriveList::connectionTo(const QString& endpoint) const
{
    const auto found = std::ranges::find(m_connections, endpoint, &DriveConnection::endpoint);
    return found == m_connections.end() ? nullptr : *found;
}

DriveConnection* DriveList::add(const QString& endpoint)
{
    auto* added = new DriveConnection(endpoint, m_options.linkFactory, *m_options.profile,
        m_options.storeRoot, m_options.timeout, m_options.reconnectInterval, this);
    connect(added, &DriveConnection::stateChanged, this, [this] {
        listDrives();
        listAxes();
    });
    connect(added, &DriveConnection::found, this,
        [this, added](bool wasAnother) { take(added, wasAnother); });
    connect(added, &DriveConnection::lost, this, [this, added](const Error& error) {
        m_log.add(
            LogLine::Kind::Error, [error] { return errorText(error); },
            added->endpoint() + QStringLiteral(": ") + errorOutcome(error).detail);
    });
    connect(&added->session(), &DriveSession::progressed, this,
        [this, added](
            const QString& step, double fraction) { Q_EMIT progressed(added, step, fraction); });
    added->explore();
    return added;
}

void DriveList::remove(DriveConnection* connection)
{
    std::erase(m_connections, connection);
    Q_EMIT removed(connection);
    if (m_current && m_current->endpoint == connection->endpoint())
        leave();
    connection->retire();
}

void DriveList::leave()
{
    m_current.reset();
    m_currentIndex = -1;
    Q_EMIT axisLeft();
}

void DriveList::listDrives()
{
    std::vector<DriveState> now;
    for (const DriveConnection* connection : m_connections)
        now.push_back(connection->state());
    if (now == m_drives)
        return;
    m_drives = std::move(now);
    Q_EMIT drivesChanged();
}

void DriveList::nameAxes()
{
    std::vector<DriveAxes> found;
    for (const DriveConnection* connection : m_connections)
        found.push_back(connection->axes());
    m_axes = axisEntries(found);
}

/// The entries may have moved: the current axis is found again by its drive and index.
void DriveList::listAxes()
{
    nameAxes();
    const int before = m_currentIndex;
    m_currentIndex = m_current ? indexOf(*m_current) : -1;
    if (m_current && m_currentIndex < 0)
        leave();
    Q_EMIT axesChanged();
    if (!m_current) {
        const auto usable = std::ranges::find_if(m_axes, &AxisEntry::isUsable);
        if (usable != m_axes.end()) {
            choose(keyOf(*usable));
            return;
        }
    }
    if (m_currentIndex != before)
        Q_EMIT currentAxisChanged();
}

DriveList::AxisKey DriveList::keyOf(const AxisEntry& entry)
{
    return {entry.endpoint, entry.axis.index};
}

int DriveList::indexOf(const AxisKey& key) const
{
    const auto position = std::ranges::find(m_axes, key, keyOf);
    return position == m_axes.end() ? -1 : static_cast<int>(position - m_axes.begin());
}

void DriveList::select(int index)
{
    choose(keyOf(m_axes.at(static_cast<std::size_t>(index))));
}

void DriveList::choose(const AxisKey& key)
{
    // Before the first axis a file can be open, and one of its tables chosen.
    if (m_current)
        leave();
    m_current = key;
    m_currentIndex = indexOf(key);
    m_outcome.dismiss();
    Q_EMIT currentAxisChanged();
    Q_EMIT axisReady(true);
}

const AxisEntry& DriveList::currentEntry() const
{
    return m_axes.at(static_cast<std::size_t>(m_currentIndex));
}

DriveConnection* DriveList::connection() const
{
    return m_current ? connectionTo(m_current->endpoint) : nullptr;
}

std::vector<AxisEntry> DriveList::usableAxes() const
{
    std::vector<AxisEntry> usable;
    if (!m_current)
        return usable;
    std::ranges::copy_if(m_axes, std::back_inserter(usable), [this](const AxisEntry& entry) {
        return entry.isUsable && entry.endpoint == m_current->endpoint;
    });
    return usable;
}

const std::vector<DimSource>& DriveList::sourceShortlist() const
{
    static const std::vector<DimSource> none;
    const DriveConnection* drive = connection();
    return drive && drive->findings() ? drive->findings()->sources : none;
}

void DriveList::take(DriveConnection* found, bool wasAnother)
{
    const QString name = found->name();
    const QString endpoint = found->endpoint();
    m_log.add(LogLine::Kind::Information,
        [name, endpoint] { return tr("Connected to %1 (%2).").arg(name, endpoint); });
    if (found != connection())
        return;
    if (wasAnother) {
        // Changes were made for another machine.
        const AxisKey key = *m_current;
        leave();
        m_current = key;
        listAxes();
        if (m_current != key)
            return;
        m_outcome.refuse([name, endpoint] {
            return tr("A different drive now answers at %1: %2. Unwritten changes were discarded.")
                .arg(endpoint, name);
        });
    }
    Q_EMIT axisReady(wasAnother);
}

void DriveList::retranslate()
{
    listDrives();
    nameAxes();
    Q_EMIT axesChanged();
}

Error connectionEndedTo(const QString& endpoint)
{
    return {ErrorCode::NotConnected,
        {{"endpoint", endpoint.toStdString()},
            {"reason", AXISCOMP_TEXT("Error", "the connection was ended")}},
        {}};
}

} // namespace axiscomp::ui
