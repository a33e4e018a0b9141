// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/record_recovery.h"

#include "core/io/file_lock.h"
#include "core/io/local_file.h"
#include "core/store/store_folder.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPointer>
#include <QUuid>

#include <algorithm>
#include <mutex>

namespace axiscomp::ui {

namespace {

constexpr const char* ending = ".axcal";
constexpr const char* lockEnding = ".lock";
/// Beside the members of a record: of which file it is.
constexpr const char* originPlace = "/recovery";

std::string originText(const QString& path, const std::string& sha256)
{
    const QJsonObject origin{
        {QStringLiteral("path"), path}, {QStringLiteral("sha256"), QString::fromStdString(sha256)}};
    return QJsonDocument(origin).toJson(QJsonDocument::Compact).toStdString();
}

std::filesystem::path lockOf(std::filesystem::path file)
{
    return file += lockEnding;
}

} // namespace

/// A file in the folder and its lock: who holds the lock has the file. Used on other threads.
struct RecordRecovery::Shelf {
    explicit Shelf(std::filesystem::path place) : file(std::move(place)) { }

    Result<void> put(const CalibrationRecord& record)
    {
        const std::scoped_lock guard(mutex);
        if (isGone)
            return {};
        AXISCOMP_CHECK(makePrivateFolder(file.parent_path()));
        if (!lock) {
            AXISCOMP_TRY(lock, FileLock::tryAcquire(lockOf(file), file));
        }
        return saveRecord(file, record);
    }
    void clear()
    {
        const std::scoped_lock guard(mutex);
        isGone = true;
        if (!lock)
            return; // nothing was put there
        static_cast<void>(removeFile(file));
        static_cast<void>(removeFile(lockOf(file)));
        lock.reset();
    }

    const std::filesystem::path file;
    std::mutex mutex;
    std::optional<FileLock> lock;
    bool isGone = false;
};

struct RecordRecovery::Finding {
    Found found;
    std::shared_ptr<Shelf> shelf;
};

RecordRecovery::RecordRecovery(RecordFile& file, std::filesystem::path folder, QObject* parent)
    : QObject(parent)
    , m_file(file)
    , m_folder(std::move(folder))
    , m_shelf(newShelf(m_folder))
{
    connect(&m_timer, &QTimer::timeout, this, &RecordRecovery::keep);
    connect(&file, &RecordFile::saved, this, &RecordRecovery::forget);
    m_timer.start(usualInterval);
}

RecordRecovery::~RecordRecovery()
{
    if (!isKept())
        m_shelf->clear();
}

std::shared_ptr<RecordRecovery::Shelf> RecordRecovery::newShelf(const std::filesystem::path& folder)
{
    const std::string name = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    return std::make_shared<Shelf>(folder / (name + ending));
}

void RecordRecovery::setInterval(std::chrono::milliseconds interval)
{
    m_timer.start(interval);
}

void RecordRecovery::end()
{
    m_isEnded = true;
    m_shelf->clear(); // at once: the program may end before another thread comes to it
}

bool RecordRecovery::isKept() const
{
    return !m_isEnded && m_file.isModified() && !m_file.isEmpty();
}

void RecordRecovery::clear()
{
    m_kept.reset();
    static_cast<void>(inBackground<bool>([shelf = std::exchange(m_shelf, newShelf(m_folder))] {
        shelf->clear();
        return true;
    }));
}

void RecordRecovery::forget()
{
    if (std::exchange(m_isUsed, false))
        clear();
}

void RecordRecovery::keep()
{
    if (!isKept()) {
        forget();
        return;
    }
    m_file.whenRead([this, context = QPointer(this)](const RecordParts& now) {
        if (!context)
            return;
        Kept current{{now.record.record, now.after.record}, fileDigests(now.record, now.after)};
        if (!isKept() || m_kept == current)
            return;
        m_kept = std::move(current);
        RecordParts parts = now;
        parts.leavesOutUnusable = true;
        m_isUsed = true;
        const auto put =
            inBackground<bool>([parts = std::move(parts), shelf = m_shelf,
                                   origin = originText(m_file.path(), m_file.sha256())] {
                auto made = assembled(parts);
                if (!made)
                    return false;
                made->others[originPlace] = origin;
                return shelf->put(*made).has_value();
            });
        whenDone(put, this, [this](bool isPut) {
            if (!isPut)
                m_kept.reset(); // it is tried again
        });
    });
}

std::optional<RecordRecovery::Finding> RecordRecovery::search(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files = filesIn(folder);
    std::erase_if(files, [](const auto& file) { return file.extension() != ending; });
    // The newest first.
    std::ranges::sort(files, std::ranges::greater(),
        [](const auto& file) { return QFileInfo(file).lastModified().toMSecsSinceEpoch(); });
    for (const std::filesystem::path& file : files) {
        auto shelf = std::make_shared<Shelf>(file);
        auto lock = FileLock::tryAcquire(lockOf(file), file);
        if (!lock || !*lock)
            continue; // its program runs
        shelf->lock = *std::move(lock);
        auto record = loadRecord(file);
        if (!record)
            continue; // gone meanwhile, or of a newer version
        Finding finding{{nullptr, {}, {}, QFileInfo(file).lastModified()}, std::move(shelf)};
        const auto origin = record->others.find(originPlace);
        if (origin != record->others.end()) {
            const QJsonObject known =
                QJsonDocument::fromJson(QByteArray::fromStdString(origin->second)).object();
            finding.found.path = known.value(QStringLiteral("path")).toString();
            finding.found.sha256 = known.value(QStringLiteral("sha256")).toString().toStdString();
            record->others.erase(origin);
        }
        finding.found.record = std::make_shared<const CalibrationRecord>(*std::move(record));
        return finding;
    }
    return std::nullopt;
}

void RecordRecovery::look()
{
    const auto result =
        inBackground<std::optional<Finding>>([folder = m_folder] { return search(folder); });
    whenDone(result, this, [this](const std::optional<Finding>& finding) {
        if (finding && !m_found) {
            m_found = finding->found;
            m_foundShelf = finding->shelf;
            Q_EMIT found();
        }
        Q_EMIT looked();
    });
}

void RecordRecovery::take()
{
    if (!m_found)
        return;
    forget();
    m_shelf = std::exchange(m_foundShelf, nullptr);
    const Found taken = *std::exchange(m_found, std::nullopt);
    m_file.take(taken.record, taken.path, taken.sha256);
    m_isUsed = true;
    keep();
}

void RecordRecovery::discard()
{
    if (!m_found)
        return;
    m_found.reset();
    const auto cleared = inBackground<bool>([shelf = std::exchange(m_foundShelf, nullptr)] {
        shelf->clear();
        return true;
    });
    whenDone(cleared, this, [this](bool) { look(); });
}

} // namespace axiscomp::ui
