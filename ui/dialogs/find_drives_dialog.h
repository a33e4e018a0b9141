// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/drive_search_job.h"
#include "ui/session/port_candidates.h"

#include <QDialog>

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace axiscomp::ui {

class BusyMark;

/// Looks for drives at the serial ports of this computer, shows what answers and what does not and
/// why, and gives the addresses of those that the user wants.
class FindDrivesDialog : public QDialog {
    Q_OBJECT

public:
    struct Options {
        LinkFactory linkFactory;
        PortCandidates candidates;
        std::vector<std::string> otherThan; ///< addresses whose ports are left out
    };
    explicit FindDrivesDialog(Options options, QWidget* parent = nullptr);

Q_SIGNALS:
    void endpointsChosen(const QStringList& endpoints);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void search();
    void add(const DriveSighting& sighting);
    void showEnd();
    void updateButtons();
    [[nodiscard]] QStringList chosen() const;

    Options m_options;
    DriveSearchJob m_scan;
    QLabel* m_introduction;
    QCheckBox* m_anyBaudRate;
    QPushButton* m_search;
    BusyMark* m_busy;
    QTreeWidget* m_list;
    QLabel* m_note;
    QDialogButtonBox* m_buttons;
    int m_places = 0;
};

} // namespace axiscomp::ui
