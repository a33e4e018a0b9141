// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/drive_search_job.h"
#include "ui/session/port_candidates.h"

#include <QDialog>

#include <optional>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace axiscomp::ui {

class BusyMark;

/// Looks for drives at the serial ports of this computer and, when the user has confirmed a range
/// of addresses, in a network; shows what answers and what does not and why, and gives the
/// addresses of those that the user wants.
class FindDrivesDialog : public QDialog {
    Q_OBJECT

public:
    struct Options {
        LinkFactory linkFactory;
        PortCandidates candidates;
        NetworkPlaces network;
        std::vector<std::string> otherThan; ///< addresses whose ports are left out
    };
    explicit FindDrivesDialog(Options options, QWidget* parent = nullptr);

Q_SIGNALS:
    void endpointsChosen(const QStringList& endpoints);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum class Place { Ports, Network };

    void build();
    void connectParts();
    void retranslate();
    void proposeNetworks();
    void search();
    void searchNetwork();
    void start(Place place, std::size_t mostAtOnce,
        std::function<std::vector<DriveCandidate>()> candidates);
    void add(const DriveSighting& sighting);
    void list(const DriveSighting& sighting);
    void showProgress();
    void showEnd();
    void updateButtons();
    void updateNetwork();
    [[nodiscard]] QStringList chosen() const;

    Options m_options;
    DriveSearchJob m_scan;
    QLabel* m_introduction;
    QCheckBox* m_anyBaudRate;
    QPushButton* m_search;
    QLabel* m_rangeLabel;
    QComboBox* m_range;
    QPushButton* m_searchNetwork;
    BusyMark* m_busy;
    QPushButton* m_stop;
    QTreeWidget* m_list;
    QLabel* m_note;
    QDialogButtonBox* m_buttons;
    Place m_place = Place::Ports;
    std::optional<NetworkRange> m_network; ///< that is, or was, searched
    int m_places = 0; ///< asked so far
    int m_drives = 0; ///< found so far
    bool m_isStopped = false;
};

} // namespace axiscomp::ui
