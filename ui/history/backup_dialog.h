// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_operations.h"
#include "core/write/kept_backup.h"
#include "ui/async/background_job.h"
#include "ui/data/table_change.h"
#include "ui/dialogs/file_picker.h"
#include "ui/session/axis_entry.h"

#include <QDialog>

#include <memory>
#include <vector>

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace axiscomp::ui {

class TableThumbnail;
class WarningList;
class WizardController;

/// The backups of the current drive, newest first, each with its table; one of them is chosen to be
/// restored. Nothing is written here: the preview follows.
class BackupDialog : public QDialog {
    Q_OBJECT

public:
    /// picker asks for a backup file that is elsewhere.
    BackupDialog(WizardController& controller, const DriveProfile& profile,
        std::filesystem::path storeRoot, FilePicker picker, QWidget* parent = nullptr);
    ~BackupDialog() override;

Q_SIGNALS:
    void chosen(const axiscomp::BackupChoice& choice);

protected:
    void changeEvent(QEvent* event) override;

private:
    using Backups = std::vector<KeptBackup>;

    void build();
    void retranslate();
    void read();
    void askForFile();
    void take(const Backups& backups, bool isFile);
    void fill();
    void showCurrent();
    void showPicture(const KeptBackup& backup);
    void drawPicture(const TableChange& change);
    [[nodiscard]] const AxisEntry* entryOf(int axis) const;
    [[nodiscard]] std::string unitOf(const KeptBackup& backup) const;
    [[nodiscard]] QString nameOf(const KeptBackup& backup) const;
    void updateButtons();
    [[nodiscard]] QTreeWidgetItem* itemFor(const KeptBackup& backup) const;
    [[nodiscard]] const KeptBackup* current() const;
    [[nodiscard]] bool isOther(const KeptBackup& backup) const;
    [[nodiscard]] QString obstacle() const;

    WizardController& m_controller;
    std::shared_ptr<const DriveProfile> m_profile; ///< for other threads
    std::filesystem::path m_storeRoot;
    FilePicker m_picker;
    DriveIdentity m_drive;
    Backups m_backups;
    bool m_isRead = false;
    NewestJob<TableChange> m_pictureJob;
    QLabel* m_introduction;
    QTreeWidget* m_list;
    TableThumbnail* m_picture;
    WarningList* m_warnings;
    QCheckBox* m_acceptOther;
    QPushButton* m_file;
    QDialogButtonBox* m_buttons;
};

} // namespace axiscomp::ui
