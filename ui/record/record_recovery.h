// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/record_file.h"

#include <QDateTime>
#include <QTimer>

#include <filesystem>

namespace axiscomp::ui {

/// Keeps what is not saved of a record, so that a crash takes no more than the last seconds; and
/// finds what programs have left that did not end well.
class RecordRecovery : public QObject {
    Q_OBJECT

public:
    static constexpr std::chrono::seconds usualInterval{20};

    /// folder: made when something is kept. file must outlive this.
    RecordRecovery(RecordFile& file, std::filesystem::path folder, QObject* parent = nullptr);
    /// What was kept of unsaved changes stays, unless end() was called.
    ~RecordRecovery() override;

    void setInterval(std::chrono::milliseconds interval);
    /// Also without waiting for the interval; on another thread.
    void keep();
    /// What is on the shelf is not wanted any more; what is changed after that is kept again.
    void forget();
    /// What is unsaved is not wanted, and nothing is kept any more.
    void end();

    /// A record that was kept by a program that does not run any more. Nobody else can take it as
    /// long as this has it.
    struct Found {
        std::shared_ptr<const CalibrationRecord> record;
        QString path; ///< of its file; empty: it had none
        std::string sha256; ///< of what that file had then
        QDateTime time; ///< when it was kept
    };
    /// found() follows when there is one, looked() always.
    void look();
    [[nodiscard]] const std::optional<Found>& waiting() const { return m_found; }
    /// The one that is waiting becomes the record; it stays kept until it is saved.
    void take();
    /// The one that is waiting is not wanted; another one may follow.
    void discard();

Q_SIGNALS:
    void found(); ///< waiting()
    void looked(); ///< whether there was one or not

private:
    struct Shelf;
    struct Finding;
    [[nodiscard]] static std::shared_ptr<Shelf> newShelf(const std::filesystem::path& folder);
    [[nodiscard]] static std::optional<Finding> search(const std::filesystem::path& folder);
    [[nodiscard]] bool isKept() const;
    void clear();

    RecordFile& m_file;
    std::filesystem::path m_folder;
    QTimer m_timer;
    std::shared_ptr<Shelf> m_shelf; ///< where this one's record is kept
    /// What is on it.
    struct Kept {
        OpenedRecord record;
        FileDigests files;

        friend bool operator==(const Kept&, const Kept&) = default;
    };
    std::optional<Kept> m_kept;
    bool m_isUsed = false; ///< something may be on it
    bool m_isEnded = false;
    std::optional<Found> m_found;
    std::shared_ptr<Shelf> m_foundShelf;
};

} // namespace axiscomp::ui
