// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/find_drives_dialog.h"

#include "core/base/error.h"
#include "ui/async/background_job.h"
#include "ui/style/busy_mark.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/text/endpoint_text.h"
#include "ui/text/message_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

namespace axiscomp::ui {

namespace {

enum SightingColumn { SightedAddressColumn, PortColumn, AnswerColumn, SightingColumnCount };
constexpr int sightingEndpointRole = Qt::UserRole;
constexpr int sightingSymbolSize = 14;

} // namespace

FindDrivesDialog::FindDrivesDialog(Options options, QWidget* parent)
    : QDialog(parent)
    , m_options(std::move(options))
    , m_introduction(new PlainLabel)
    , m_anyBaudRate(new QCheckBox)
    , m_search(new QPushButton)
    , m_rangeLabel(new PlainLabel)
    , m_range(new QComboBox)
    , m_searchNetwork(new QPushButton)
    , m_busy(new BusyMark)
    , m_stop(new QPushButton)
    , m_list(new QTreeWidget)
    , m_note(new PlainLabel)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setObjectName(QStringLiteral("findDrivesDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connectParts();
    retranslate();
    proposeNetworks();
    search();
}

void FindDrivesDialog::build()
{
    m_introduction->setWordWrap(true);
    m_anyBaudRate->setObjectName(QStringLiteral("anyBaudRate"));
    m_search->setObjectName(QStringLiteral("searchAgain"));
    m_rangeLabel->setBuddy(m_range);
    m_range->setObjectName(QStringLiteral("networkRange"));
    m_range->setEditable(true);
    m_range->setInsertPolicy(QComboBox::NoInsert);
    m_searchNetwork->setObjectName(QStringLiteral("searchNetwork"));
    m_stop->setObjectName(QStringLiteral("stopSearch"));
    for (QPushButton* button : {m_search, m_searchNetwork, m_stop})
        button->setAutoDefault(false);
    m_list->setObjectName(QStringLiteral("foundDrives"));
    m_list->setColumnCount(SightingColumnCount);
    m_list->setRootIsDecorated(false);
    m_list->setAlternatingRowColors(true);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(true);
    m_note->setObjectName(QStringLiteral("searchNote"));
    m_note->setWordWrap(true);
    m_buttons->setObjectName(QStringLiteral("findDrivesButtons"));
    auto* places = new QGridLayout;
    places->setColumnStretch(1, 1);
    places->addWidget(m_anyBaudRate, 0, 0, 1, 2);
    places->addWidget(m_search, 0, 2);
    places->addWidget(m_rangeLabel, 1, 0);
    places->addWidget(m_range, 1, 1);
    places->addWidget(m_searchNetwork, 1, 2);
    auto* progress = new QHBoxLayout;
    progress->addWidget(m_busy);
    progress->addWidget(m_note, 1);
    progress->addWidget(m_stop);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_introduction);
    layout->addLayout(places);
    layout->addWidget(m_list, 1);
    layout->addLayout(progress);
    layout->addWidget(m_buttons);
    resize(900, 420);
}

void FindDrivesDialog::connectParts()
{
    connect(m_search, &QPushButton::clicked, this, &FindDrivesDialog::search);
    connect(m_searchNetwork, &QPushButton::clicked, this, &FindDrivesDialog::searchNetwork);
    connect(m_range, &QComboBox::editTextChanged, this, &FindDrivesDialog::updateNetwork);
    connect(m_stop, &QPushButton::clicked, this, [this] {
        m_isStopped = true;
        m_scan.stop();
    });
    connect(m_list, &QTreeWidget::itemChanged, this, &FindDrivesDialog::updateButtons);
    connect(&m_scan, &DriveSearchJob::sighted, this, &FindDrivesDialog::add);
    connect(&m_scan, &DriveSearchJob::finished, this, &FindDrivesDialog::showEnd);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_buttons, &QDialogButtonBox::accepted, this, [this] {
        Q_EMIT endpointsChosen(chosen());
        accept();
    });
}

void FindDrivesDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void FindDrivesDialog::retranslate()
{
    setWindowTitle(tr("Find Drives"));
    QString introduction =
        tr("Asks every serial port of this computer for a drive; nothing else is sent. A port that "
           "is not listed can be entered as an address, such as serial:/dev/ttyUSB0?baud=921600.");
    if (m_options.network.candidates)
        introduction += u' '
            + tr("A network is asked only when you confirm its addresses: each of them gets one "
                 "request.");
    m_introduction->setText(introduction);
    m_anyBaudRate->setText(tr("Try all common &baud rates at every port"));
    m_anyBaudRate->setToolTip(tr("Takes a few seconds for each port without an answer"));
    m_search->setText(tr("&Search Again"));
    m_search->setToolTip(tr("Search all ports again"));
    m_rangeLabel->setText(tr("&Network:"));
    m_range->setAccessibleName(tr("Addresses of a network"));
    m_range->setToolTip(tr("Such as 192.168.1.0/24, 192.168.1.10-40 or one address, with :8080 "
                           "behind it for another port than 80"));
    m_range->lineEdit()->setPlaceholderText(tr("192.168.1.0/24", "example of a range"));
    m_stop->setText(tr("S&top"));
    m_stop->setToolTip(tr("Ask no more; what was found stays"));
    m_list->setHeaderLabels({tr("Address"), tr("Port"), tr("Answer")});
    m_list->setAccessibleName(tr("What was found"));
    for (QWidget* widget : {static_cast<QWidget*>(m_range), static_cast<QWidget*>(m_stop)})
        widget->setAccessibleDescription(widget->toolTip());
    if (m_scan.isRunning())
        showProgress();
    else
        showEnd();
    updateButtons();
}

/// A computer is asked for its networks on another thread.
void FindDrivesDialog::proposeNetworks()
{
    for (QWidget* widget : {static_cast<QWidget*>(m_rangeLabel), static_cast<QWidget*>(m_range),
             static_cast<QWidget*>(m_searchNetwork)})
        widget->setVisible(static_cast<bool>(m_options.network.candidates));
    if (!m_options.network.candidates || !m_options.network.ownNetworks)
        return;
    whenDone(inBackground<std::vector<std::string>>(m_options.network.ownNetworks), this,
        [this](const std::vector<std::string>& networks) {
            const QString typed = m_range->currentText();
            for (const std::string& network : networks)
                m_range->addItem(QString::fromStdString(network));
            if (!typed.isEmpty())
                m_range->setEditText(typed);
        });
}

void FindDrivesDialog::search()
{
    m_network.reset();
    start(Place::Ports, DriveSearch{}.mostAtOnce,
        [candidates = m_options.candidates, otherThan = m_options.otherThan,
            anyBaudRate = m_anyBaudRate->isChecked()] {
            return candidates(otherThan, anyBaudRate);
        });
}

/// The button names how many addresses are asked: pressing it confirms them.
void FindDrivesDialog::searchNetwork()
{
    const auto range = parseNetworkRange(m_range->currentText().toStdString());
    if (!range)
        return;
    m_network = *range;
    start(Place::Network, m_options.network.mostAtOnce,
        [candidates = m_options.network.candidates, otherThan = m_options.otherThan,
            range = *range] { return candidates(range, otherThan); });
}

void FindDrivesDialog::start(
    Place place, std::size_t mostAtOnce, std::function<std::vector<DriveCandidate>()> candidates)
{
    m_place = place;
    m_list->clear();
    m_places = 0;
    m_drives = 0;
    m_isStopped = false;
    m_busy->setBusy(true);
    m_scan.start(m_options.linkFactory, std::move(candidates), mostAtOnce);
    showProgress();
    updateButtons();
}

void FindDrivesDialog::add(const DriveSighting& sighting)
{
    if (!sighting.drive && sighting.drive.error().code == ErrorCode::Cancelled)
        return;
    ++m_places;
    if (sighting.drive)
        ++m_drives;
    // Most addresses of a network are nobody's.
    if (m_place == Place::Ports || sighting.drive || !isUnreachable(sighting.drive.error().code))
        list(sighting);
    showProgress();
    updateButtons();
}

void FindDrivesDialog::list(const DriveSighting& sighting)
{
    auto* item = new QTreeWidgetItem(m_list);
    const QString endpoint = QString::fromStdString(sighting.endpoint);
    item->setData(SightedAddressColumn, sightingEndpointRole, endpoint);
    item->setText(SightedAddressColumn, shownEndpoint(endpoint));
    item->setText(PortColumn, QString::fromStdString(sighting.description));
    const Tone tone = sighting.drive ? Tone::Success : Tone::Error;
    item->setIcon(AnswerColumn,
        symbolPixmap(sighting.drive ? Symbol::Success : Symbol::Error, frameColor(tone, palette()),
            sightingSymbolSize, devicePixelRatioF()));
    if (sighting.drive) {
        item->setText(AnswerColumn,
            tr("%1, serial number %2, axes: %3")
                .arg(QString::fromStdString(sighting.drive->name))
                .arg(sighting.drive->serialNumber)
                .arg(sighting.drive->axes));
        item->setCheckState(SightedAddressColumn, Qt::Checked);
    } else {
        item->setText(AnswerColumn, errorText(sighting.drive.error()));
        item->setFlags(item->flags() & ~Qt::ItemIsUserCheckable);
    }
    item->setToolTip(AnswerColumn, item->text(AnswerColumn));
}

void FindDrivesDialog::showProgress()
{
    if (!m_busy->isBusy())
        return;
    m_note->setText(m_network ? tr("Asked %1 of %2 addresses; drives found: %3")
                                    .arg(m_places)
                                    .arg(m_network->count())
                                    .arg(m_drives)
                              : tr("Searching …"));
}

void FindDrivesDialog::showEnd()
{
    m_busy->setBusy(false);
    if (m_network)
        m_note->setText((m_isStopped ? tr("Stopped. Addresses asked: %1; drives found: %2")
                                     : tr("Addresses asked: %1; drives found: %2"))
                            .arg(m_places)
                            .arg(m_drives));
    else if (m_places == 0 && !m_isStopped)
        m_note->setText(tr("All serial ports of this computer are already in the list."));
    else
        m_note->setText(tr("Ports searched: %1; drives found: %2").arg(m_places).arg(m_drives));
    updateButtons();
}

void FindDrivesDialog::updateButtons()
{
    m_search->setEnabled(!m_busy->isBusy());
    m_stop->setEnabled(m_busy->isBusy());
    updateNetwork();
    QPushButton* add = m_buttons->button(QDialogButtonBox::Ok);
    add->setText(tr("&Add to the Connections"));
    add->setEnabled(!chosen().isEmpty());
    add->setToolTip(add->isEnabled() ? QString() : tr("No drive is chosen"));
}

void FindDrivesDialog::updateNetwork()
{
    const QString text = m_range->currentText().trimmed();
    const auto range = parseNetworkRange(text.toStdString());
    m_searchNetwork->setText(
        range ? tr("Ask A&ddresses (%1)").arg(range->count()) : tr("Ask A&ddresses"));
    m_searchNetwork->setEnabled(range && !m_busy->isBusy());
    QString toolTip = tr("Each address gets one request over http, for the list of its files; what "
                         "answers as a drive does is asked who it is");
    if (text.isEmpty())
        toolTip = tr("Enter the addresses first");
    else if (!range)
        toolTip = errorText(range.error());
    m_searchNetwork->setToolTip(toolTip);
    m_searchNetwork->setAccessibleDescription(toolTip);
    // What is wrong with a range is said while it is typed.
    if (!m_busy->isBusy() && !range && !text.isEmpty())
        m_note->setText(toolTip);
}

QStringList FindDrivesDialog::chosen() const
{
    QStringList endpoints;
    for (int row = 0; row < m_list->topLevelItemCount(); ++row) {
        const QTreeWidgetItem& item = *m_list->topLevelItem(row);
        if (item.checkState(SightedAddressColumn) == Qt::Checked)
            endpoints += item.data(SightedAddressColumn, sightingEndpointRole).toString();
    }
    return endpoints;
}

} // namespace axiscomp::ui
