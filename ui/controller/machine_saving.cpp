// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/machine_saving.h"

#include "ui/async/background_job.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace axiscomp::ui {

namespace {

struct Joined {
    std::shared_ptr<const MachineSnapshot> snapshot;
    QStringList replaced;
};

QStringList replacedIn(const std::filesystem::path& folder, const MachineSnapshot& snapshot)
{
    QStringList names;
    for (const std::string& file : replacedFiles(snapshot, folder))
        names += QString::fromStdString(file);
    return names;
}

} // namespace

MachineSaving::MachineSaving(const DriveProfile& profile, const DriveList& drives)
    : m_profile(profile)
    , m_drives(drives)
{
}

MachineSaving::~MachineSaving()
{
    m_stop.request_stop();
}

void MachineSaving::drop()
{
    m_stop.request_stop();
    ++m_number;
    m_read.clear();
    m_snapshot.reset();
    m_replaced.clear();
    m_problem.reset();
    m_problemPlace.clear();
    m_stage = Stage::Idle;
}

void MachineSaving::enter(Stage stage)
{
    m_stage = stage;
    Q_EMIT changed();
}

void MachineSaving::giveUp(const Error& error, const QString& place)
{
    drop();
    m_problem = error;
    m_problemPlace = place;
    enter(Stage::Failed);
}

void MachineSaving::save(const QStringList& endpoints, const QString& name, const QString& folder)
{
    drop();
    m_stop = std::stop_source();
    m_name = name;
    m_folder = folder;
    m_endpoints = endpoints;
    m_read.resize(static_cast<std::size_t>(endpoints.size()));
    enter(Stage::Reading);
    using Snapshot = std::shared_ptr<DriveSnapshot>;
    for (std::size_t n = 0; n < m_read.size() && m_stage == Stage::Reading; ++n) {
        const QString& endpoint = endpoints.at(static_cast<qsizetype>(n));
        DriveConnection* connection = m_drives.connectionTo(endpoint);
        if (!connection || !connection->isConnected())
            return giveUp(connection && connection->problem() ? *connection->problem()
                                                              : connectionEndedTo(endpoint),
                endpoint);
        const auto read = [&profile = m_profile, store = connection->session().storeRoot(),
                              place = endpoint.toStdString()](AxisCompensator& compensator,
                              const OperationOptions& options) -> Result<Snapshot> {
            AXISCOMP_TRY(auto snapshot, snapshotDrive(compensator, profile, store, place, options));
            return std::make_shared<DriveSnapshot>(std::move(snapshot));
        };
        whenDone(connection->session().run<Snapshot>(read, m_stop.get_token()), this,
            [this, n, number = m_number](const Result<Snapshot>& snapshot) {
                if (number == m_number)
                    take(n, snapshot);
            });
    }
    if (m_read.empty())
        join(); // which says that these make no machine
}

/// All of them, or none: a machine file without one of its drives would be another machine.
void MachineSaving::take(std::size_t index, const Result<std::shared_ptr<DriveSnapshot>>& snapshot)
{
    if (!snapshot)
        return giveUp(snapshot.error(), m_endpoints.at(static_cast<qsizetype>(index)));
    m_read[index] = *snapshot;
    if (std::ranges::all_of(m_read, [](const auto& read) { return read != nullptr; }))
        join();
}

void MachineSaving::join()
{
    const auto joined = inBackground<Result<Joined>>(
        [read = std::exchange(m_read, {}), name = m_name.toStdString(),
            folder = QFileInfo(m_folder).filesystemAbsoluteFilePath()]() -> Result<Joined> {
            std::vector<DriveSnapshot> drives;
            for (const auto& drive : read)
                drives.push_back(std::move(*drive));
            AXISCOMP_TRY(auto snapshot, joinSnapshots(name, std::move(drives)));
            Joined result;
            result.replaced = replacedIn(folder, snapshot);
            result.snapshot = std::make_shared<const MachineSnapshot>(std::move(snapshot));
            return result;
        });
    whenDone(joined, this, [this, number = m_number](const Result<Joined>& result) {
        if (number != m_number)
            return;
        if (!result)
            return giveUp(result.error());
        m_snapshot = result->snapshot;
        m_replaced = result->replaced;
        if (m_replaced.isEmpty())
            write();
        else
            enter(Stage::Asking);
    });
}

void MachineSaving::replace()
{
    if (m_stage == Stage::Asking)
        write();
}

/// A file that has appeared since it was asked is not replaced: it is asked again.
void MachineSaving::write()
{
    enter(Stage::Saving);
    const auto saved = inBackground<Result<QStringList>>(
        [snapshot = m_snapshot, folder = QFileInfo(m_folder).filesystemAbsoluteFilePath(),
            asked = m_replaced]() -> Result<QStringList> {
            QStringList replaced = replacedIn(folder, *snapshot);
            const auto wasAskedFor = [&](const QString& name) { return asked.contains(name); };
            if (!std::ranges::all_of(replaced, wasAskedFor))
                return replaced;
            AXISCOMP_CHECK(saveSnapshot(*snapshot, folder));
            return QStringList{};
        });
    whenDone(saved, this, [this, number = m_number](const Result<QStringList>& notAskedFor) {
        if (number != m_number)
            return;
        if (!notAskedFor)
            return giveUp(notAskedFor.error());
        m_replaced = *notAskedFor;
        enter(m_replaced.isEmpty() ? Stage::Saved : Stage::Asking);
    });
}

} // namespace axiscomp::ui
