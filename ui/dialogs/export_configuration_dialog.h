// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/async/background_job.h"
#include "ui/controller/wizard_controller.h"

#include <QDialog>

#include <memory>

class QLabel;
class QPushButton;

namespace axiscomp {
struct DriveProfile;
}

namespace axiscomp::ui {

class BusyMark;
class RowList;
class StationChoice;
class ToneLabel;

/// The compensation parameters of the current drive for a TAM configuration: for which station, and
/// what they are. chosen() has the new text of the file; nothing is written here.
class ExportConfigurationDialog : public QDialog {
    Q_OBJECT

public:
    /// The controller has an axis; both references must outlive this.
    ExportConfigurationDialog(WizardController& controller, const DriveProfile& profile,
        QString path, QWidget* parent = nullptr);
    ~ExportConfigurationDialog() override;

Q_SIGNALS:
    void chosen(const std::shared_ptr<const TamConfiguration>& from, const std::string& text);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void follow();
    void retranslate();
    void readDrive();
    void readAgain();
    void takeParameters();
    void showParameters();
    void compute();
    void leaveLostDrive();
    void showState();
    [[nodiscard]] bool isSame() const;
    [[nodiscard]] bool isError() const;
    [[nodiscard]] QString reason() const;

    WizardController& m_controller;
    const DriveProfile& m_profile;
    const QString m_path;
    const std::vector<AxisEntry> m_axes;
    bool m_isAsked = false; ///< the drive, for its parameters
    std::optional<Result<std::string>> m_text; ///< of the file with the parameters
    NewestJob<Result<std::string>> m_job;
    QLabel* m_introduction;
    StationChoice* m_station;
    QLabel* m_title;
    RowList* m_rows;
    BusyMark* m_busy;
    ToneLabel* m_reason;
    QPushButton* m_save;
    QPushButton* m_cancel;
};

} // namespace axiscomp::ui
