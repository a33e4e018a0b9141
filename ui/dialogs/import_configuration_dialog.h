// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/several_writes_dialog.h"

namespace axiscomp::ui {

class StationChoice;

/// The compensation parameters of a TAM configuration for the current drive: of which station.
class ImportConfigurationDialog : public SeveralWritesDialog {
    Q_OBJECT

public:
    /// The controller has an axis that can be written.
    ImportConfigurationDialog(
        WizardController& controller, QString path, QWidget* parent = nullptr);

protected:
    [[nodiscard]] QString obstacle() const override;
    [[nodiscard]] bool isObstacleAnError() const override;
    [[nodiscard]] bool isWaiting() const override;
    [[nodiscard]] bool ask() override;
    void setChoosable(bool isChoosable) override;
    void retranslateChoices() override;

private:
    const QString m_path;
    StationChoice* m_station;
};

} // namespace axiscomp::ui
