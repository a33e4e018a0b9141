// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/backup.h"
#include "ui/dialogs/several_writes_dialog.h"

#include <memory>
#include <optional>

class QCheckBox;
class QLabel;

namespace axiscomp::ui {

/// A backup of a whole drive for the current one: all axes, and the tables that no axis uses. One
/// of a drive with another serial number has to be confirmed.
class RestoreDriveDialog : public SeveralWritesDialog {
    Q_OBJECT

public:
    /// The controller has an axis that can be written.
    RestoreDriveDialog(WizardController& controller, QString path, QWidget* parent = nullptr);

protected:
    [[nodiscard]] QString obstacle() const override;
    [[nodiscard]] bool isObstacleAnError() const override;
    [[nodiscard]] bool isWaiting() const override { return !m_backup; }
    [[nodiscard]] bool ask() override;
    void setChoosable(bool isChoosable) override;
    void retranslateChoices() override;

private:
    using Loaded = Result<std::shared_ptr<const DriveBackup>>;

    void take(const Loaded& backup);
    /// Of the drive that the backup is of; none: it says none, or cannot be read.
    [[nodiscard]] std::optional<DriveIdentity> drive() const;
    [[nodiscard]] bool isOther() const;
    [[nodiscard]] QString contentText() const;

    const QString m_path;
    std::optional<Loaded> m_backup; ///< none: it is being read
    QLabel* m_content;
    QCheckBox* m_accept;
};

} // namespace axiscomp::ui
