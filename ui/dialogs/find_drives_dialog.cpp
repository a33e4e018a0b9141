// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/find_drives_dialog.h"

#include "ui/style/busy_mark.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/text/endpoint_text.h"
#include "ui/text/message_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
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
    , m_busy(new BusyMark)
    , m_list(new QTreeWidget)
    , m_note(new PlainLabel)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setObjectName(QStringLiteral("findDrivesDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(m_search, &QPushButton::clicked, this, &FindDrivesDialog::search);
    connect(m_list, &QTreeWidget::itemChanged, this, &FindDrivesDialog::updateButtons);
    connect(&m_scan, &DriveSearchJob::sighted, this, &FindDrivesDialog::add);
    connect(&m_scan, &DriveSearchJob::finished, this, &FindDrivesDialog::showEnd);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_buttons, &QDialogButtonBox::accepted, this, [this] {
        Q_EMIT endpointsChosen(chosen());
        accept();
    });
    retranslate();
    search();
}

void FindDrivesDialog::build()
{
    m_introduction->setWordWrap(true);
    m_anyBaudRate->setObjectName(QStringLiteral("anyBaudRate"));
    m_search->setObjectName(QStringLiteral("searchAgain"));
    m_search->setAutoDefault(false);
    m_list->setObjectName(QStringLiteral("foundDrives"));
    m_list->setColumnCount(SightingColumnCount);
    m_list->setRootIsDecorated(false);
    m_list->setAlternatingRowColors(true);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(true);
    m_note->setObjectName(QStringLiteral("searchNote"));
    m_note->setWordWrap(true);
    m_buttons->setObjectName(QStringLiteral("findDrivesButtons"));
    auto* bar = new QHBoxLayout;
    bar->addWidget(m_anyBaudRate, 1);
    bar->addWidget(m_busy);
    bar->addWidget(m_search);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_introduction);
    layout->addLayout(bar);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_note);
    layout->addWidget(m_buttons);
    resize(900, 380);
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
    m_introduction->setText(
        tr("Asks every serial port of this computer for a drive; nothing else is sent. A port that "
           "is not listed can be entered as an address, such as serial:/dev/ttyUSB0?baud=921600."));
    m_anyBaudRate->setText(tr("Try all common &baud rates at every port"));
    m_anyBaudRate->setToolTip(tr("Takes a few seconds for each port without an answer"));
    m_search->setText(tr("&Search Again"));
    m_search->setToolTip(tr("Search all ports again"));
    m_list->setHeaderLabels({tr("Address"), tr("Port"), tr("Answer")});
    m_list->setAccessibleName(tr("What was found"));
    if (!m_scan.isRunning())
        showEnd();
    updateButtons();
}

void FindDrivesDialog::search()
{
    m_list->clear();
    m_places = 0;
    m_note->setText(tr("Searching …"));
    m_busy->setBusy(true);
    m_scan.start(m_options.linkFactory,
        [candidates = m_options.candidates, otherThan = m_options.otherThan,
            anyBaudRate = m_anyBaudRate->isChecked()] {
            return candidates(otherThan, anyBaudRate);
        });
    updateButtons();
}

void FindDrivesDialog::add(const DriveSighting& sighting)
{
    ++m_places;
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
    updateButtons();
}

void FindDrivesDialog::showEnd()
{
    m_busy->setBusy(false);
    if (m_places == 0)
        m_note->setText(tr("All serial ports of this computer are already in the list."));
    else
        m_note->setText(
            tr("Ports searched: %1; drives found: %2").arg(m_places).arg(chosen().size()));
    updateButtons();
}

void FindDrivesDialog::updateButtons()
{
    m_search->setEnabled(!m_busy->isBusy());
    QPushButton* add = m_buttons->button(QDialogButtonBox::Ok);
    add->setText(tr("&Add to the Connections"));
    add->setEnabled(!chosen().isEmpty());
    add->setToolTip(add->isEnabled() ? QString() : tr("No drive is chosen"));
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
