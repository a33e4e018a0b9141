// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/file_picker.h"
#include "ui/record/record_file.h"
#include "ui/record/record_model.h"
#include "ui/record/record_recovery.h"

#include <QMenu>
#include <QObject>
#include <QPointer>

#include <filesystem>
#include <map>
#include <memory>
#include <vector>

namespace axiscomp {
struct AxisStatus;
struct DriveProfile;
} // namespace axiscomp

namespace axiscomp::ui {

class MessageStack;
class PageMenu;
class ProvePage;
class RecordBar;
class UnsavedChangesGuard;
class WizardController;

/// Between the record, its file, the tab Prove and the page: opening, saving, the report, what is
/// kept for a crash, and what the drive does with the table of the record.
class RecordActions : public QObject {
    Q_OBJECT

public:
    /// What the record needs of the page. All must outlive this.
    struct Page {
        MessageStack& messages;
        UnsavedChangesGuard& guard;
        PageMenu& menu;
        QWidget& window; ///< what dialogs belong to
        std::function<const FilePicker&()> picker;
        std::function<QString()> folder; ///< where files are looked for first
    };

    /// storeRoot: unsaved changes are kept in a folder of it. All references must outlive this.
    RecordActions(RecordModel& record, WizardController& controller, const DriveProfile& profile,
        const std::filesystem::path& storeRoot, QObject* parent = nullptr);
    ~RecordActions() override;

    /// These are taken by the page.
    [[nodiscard]] RecordBar* bar() const { return m_bar; }
    [[nodiscard]] ProvePage* prove() const { return m_prove; }
    [[nodiscard]] RecordModel& after() { return m_after; }
    [[nodiscard]] RecordFile& file() { return m_file; }
    [[nodiscard]] RecordRecovery& recovery() { return m_recovery; }
    void attach(const Page& page);
    /// Offers what a program has left that did not end well.
    void lookForUnsaved() { m_recovery.look(); }

    /// Whether a file is one by its name.
    [[nodiscard]] static bool isRecord(const QString& path);
    void begin();
    void askAndOpen();
    /// In place of the one that there is; asks when that is not saved.
    void open(const QString& path);
    void save();
    void saveAs();
    void report();
    /// Whether a source is on the side of the compensation for which the table of the record was
    /// made, or the table is another one; tells why not.
    [[nodiscard]] bool mayWrite();
    /// Why the record, whose table it is, does not note a write to the axis; empty: it does.
    [[nodiscard]] std::vector<Text> doubtsOfWrite() const;
    void retranslate();

Q_SIGNALS:
    void failed(const QString& sentence);

private:
    [[nodiscard]] std::shared_ptr<const CalibrationRecord> recordOfSelected() const;
    void buildMenu();
    void showMenu();
    enum class Reason { Begin, Open };
    void loseRecord(Reason reason, std::function<void()> action);
    void forgetQuestion();
    [[nodiscard]] QString unsavedText() const;
    [[nodiscard]] bool isUnsaved() const;
    void saveThen(std::function<void()> action);
    void goOnAfterSave();
    void saveNow();
    void askWhereToSave();
    void ask(FileQuestion::Purpose purpose, const std::function<void(const QString&)>& answer);
    void tellObstacle(const QString& path, RecordFile::Obstacle obstacle);
    void tellChanged(const QString& names);
    void offerUnsaved();
    void writeReport(const QString& path);
    void noteWrite(const AxisStatus& now);
    void noteProof();
    /// What is noted in the records of a table.
    struct Note {
        std::function<bool(const CalibrationRecord&)> isDue;
        std::function<Result<void>(CalibrationRecord&)> change;
        std::vector<std::shared_ptr<const CalibrationRecord>> done = {}; ///< have it, or refuse it
    };
    void noteInRecords(const Note& note);
    void showNote(Note note,
        const std::map<std::shared_ptr<const CalibrationRecord>,
            Result<std::shared_ptr<const CalibrationRecord>>>& noted);

    RecordModel& m_record;
    RecordModel m_after;
    RecordFile m_file;
    RecordRecovery m_recovery;
    WizardController& m_controller;
    const DriveProfile& m_profile;
    RecordBar* m_bar;
    ProvePage* m_prove;
    std::unique_ptr<Page> m_page;
    QPointer<QMenu> m_menu; ///< of the page's
    QAction* m_new = nullptr;
    QAction* m_open = nullptr;
    QAction* m_save = nullptr;
    QAction* m_saveAs = nullptr;
    QAction* m_report = nullptr;
    int m_notes = 0; ///< that are being made
    std::function<void()> m_afterSave; ///< what the record is saved for
    std::function<void()> m_question; ///< that is asked, for another language
};

} // namespace axiscomp::ui
