// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/async/background_job.h"
#include "ui/record/record_assembly.h"

#include <QObject>

#include <functional>
#include <optional>
#include <string>

namespace axiscomp::ui {

class RecordModel;

/// The file .axcal of the record that is being worked on: opened, saved whole or not at all, and
/// never written over what somebody else has put there. Reads and writes on another thread.
class RecordFile : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this; after shares the history of record.
    RecordFile(RecordModel& record, RecordModel& after, QObject* parent = nullptr);

    /// What is saved keeps its figures there, for who looks at the drive.
    void setStore(const std::filesystem::path& storeRoot) { m_store = storeRoot; }

    [[nodiscard]] const QString& path() const { return m_path; } ///< empty: it has no file yet
    /// Without its folder; of one that has no file yet, a word for that.
    [[nodiscard]] QString name() const;
    /// There is something that the file does not have.
    [[nodiscard]] bool isModified() const;
    /// There is something to save, to report or to lose.
    [[nodiscard]] bool isEmpty() const;
    [[nodiscard]] bool isBusy() const { return m_jobs > 0; }
    /// What the file will have is not known yet: isModified() compares with what it had.
    [[nodiscard]] bool isSaving() const { return m_saves > 0; }

    /// A new one, in place of the one there is.
    void begin();
    /// In place of the one there is, which stays when the file cannot be read, and when another one
    /// is begun or opened before it is.
    void open(const QString& path);
    /// One that was kept when a program ended, with the file that it was of, which may be none.
    void take(std::shared_ptr<const CalibrationRecord> record, const QString& path,
        const std::string& sha256);
    /// Of what was read or written last; empty: nothing.
    [[nodiscard]] const std::string& sha256() const { return m_content.sha256; }

    /// Why a file is not written over without being asked for.
    enum class Obstacle {
        Exists, ///< another file is there
        Changed, ///< it is not what was read or written last
        OtherTable, ///< it says what was written and measured of a table that is not this one
    };
    /// Waits until the measurements are read. overwrites: the obstacle was agreed to.
    void save(const QString& path, bool overwrites = false);

    /// Gives what is to be saved, when the measurements are read: for assembled(). Not at all when
    /// another record is opened before.
    void whenRead(std::function<void(const RecordParts&)> use);

Q_SIGNALS:
    void changed(); ///< path(), name(), isModified(), isEmpty(), isBusy()
    void opened(); ///< or begun
    void saved();
    void openFailed(const axiscomp::Error& error);
    void saveFailed(const axiscomp::Error& error);
    void obstructed(const QString& path, axiscomp::ui::RecordFile::Obstacle obstacle);

private:
    /// What is in a file, or was put there.
    struct Content {
        std::shared_ptr<const CalibrationRecord> record;
        std::string sha256; ///< of the bytes
    };
    struct Saving {
        std::optional<Obstacle> obstacle;
        Content content;
    };
    struct Target {
        std::filesystem::path file;
        bool isOwn = false; ///< it is the file of this record
        bool isModified = false; ///< there is something that it does not have
        std::string sha256; ///< of what is there as far as is known
        bool overwrites = false;
        std::filesystem::path store; ///< which keeps the figures; empty: none
    };
    [[nodiscard]] static Result<Content> read(const std::filesystem::path& file);
    [[nodiscard]] static Result<Saving> write(const RecordParts& parts, const Target& target);
    [[nodiscard]] OpenedRecord current() const;
    [[nodiscard]] RecordParts parts() const;
    /// Whether the file has what there is.
    [[nodiscard]] bool isKnown() const;
    void show(const QString& path, const Content& content);
    void saveNow(const QString& path, bool overwrites);
    void follow();
    void setBusy(bool isBusy);

    RecordModel& m_record;
    RecordModel& m_after;
    QString m_path;
    std::filesystem::path m_store;
    Content m_content; ///< of the file, or what was begun
    OpenedRecord m_known; ///< of which the file is
    FileDigests m_knownFiles; ///< likewise: they may have been read again since
    bool m_isRecovered = false; ///< no file has what was kept
    int m_jobs = 0; ///< that read or write
    int m_saves = 0; ///< of these
    int m_shown = 0; ///< records that were begun or opened so far
    int m_wanted = 0; ///< the same, with those that are being opened
    std::vector<std::function<void(const RecordParts&)>>
        m_waiting; ///< until the measurements are read
};

} // namespace axiscomp::ui
