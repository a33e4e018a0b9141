// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/connections_dialog.h"

#include "ui/dialogs/certificate_button.h"
#include "ui/dialogs/find_drives_dialog.h"
#include "ui/style/busy_mark.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/style/tone_label.h"
#include "ui/text/endpoint_text.h"
#include "ui/text/message_text.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QUrl>

namespace axiscomp::ui {

namespace {

enum ConnectionColumn { AddressColumn, DriveColumn, StateColumn, ConnectionColumnCount };
constexpr int endpointRole = Qt::UserRole; ///< as typed, password included
constexpr int connectionSymbolSize = 14;

QPushButton* dialogButton(const char* name, Symbol symbol)
{
    auto* button = new QPushButton;
    button->setObjectName(QLatin1StringView(name));
    button->setIcon(symbolIcon(symbol));
    button->setAutoDefault(false);
    return button;
}

QString endpointOf(const QTreeWidgetItem& item)
{
    return item.data(AddressColumn, endpointRole).toString();
}

/// For changing it: the password stays behind.
QString editableText(const QString& endpoint)
{
    const QUrl url(endpoint, QUrl::StrictMode);
    return url.password().isEmpty() ? endpoint : url.toString(QUrl::RemovePassword);
}

} // namespace

ConnectionsDialog::ConnectionsDialog(
    const WizardController& controller, ProbeOptions options, QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_options(std::move(options))
    , m_probe(m_options)
    , m_introduction(new PlainLabel)
    , m_list(new QTreeWidget)
    , m_edit(dialogButton("editConnection", Symbol::Edit))
    , m_remove(dialogButton("removeConnection", Symbol::Remove))
    , m_test(dialogButton("testConnection", Symbol::Connections))
    , m_certificate(new CertificateButton(m_options.storeRoot))
    , m_find(dialogButton("findDrives", Symbol::Refresh))
    , m_demo(dialogButton("addDemo", Symbol::Add))
    , m_addressLabel(new PlainLabel)
    , m_address(new QLineEdit)
    , m_add(dialogButton("addConnection", Symbol::Add))
    , m_busy(new BusyMark)
    , m_note(new ToneLabel)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setObjectName(QStringLiteral("connectionsDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connectButtons();
    for (const QString& endpoint : controller.endpoints())
        addItem(endpoint);
    m_list->setCurrentItem(m_list->topLevelItem(0));
    retranslate();
    m_address->setFocus();
}

void ConnectionsDialog::build()
{
    buildList();
    m_introduction->setWordWrap(true);
    m_address->setObjectName(QStringLiteral("connectionAddress"));
    m_address->setClearButtonEnabled(true);
    m_addressLabel->setBuddy(m_address);
    m_add->setAutoDefault(true);
    m_note->setObjectName(QStringLiteral("connectionNote"));
    m_note->setWordWrap(true);
    m_note->setMinimumHeight(2 * m_note->fontMetrics().lineSpacing());
    m_note->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_buttons->setObjectName(QStringLiteral("connectionButtons"));
    m_buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("acceptConnections"));
    m_buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("rejectConnections"));
    m_find->setVisible(static_cast<bool>(m_options.portCandidates));
    auto* side = new QVBoxLayout;
    for (QPushButton* button : std::initializer_list<QPushButton*>{
             m_edit, m_remove, m_test, m_certificate, m_find, m_demo})
        side->addWidget(button);
    side->addStretch(1);
    auto* list = new QHBoxLayout;
    list->addWidget(m_list, 1);
    list->addLayout(side);
    auto* address = new QHBoxLayout;
    address->addWidget(m_addressLabel);
    address->addWidget(m_address, 1);
    address->addWidget(m_busy);
    address->addWidget(m_add);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_introduction);
    layout->addLayout(list, 1);
    layout->addLayout(address);
    layout->addWidget(m_note);
    layout->addWidget(m_buttons);
    resize(760, 420);
}

void ConnectionsDialog::buildList()
{
    m_list->setObjectName(QStringLiteral("connections"));
    m_list->setColumnCount(ConnectionColumnCount);
    m_list->setRootIsDecorated(false);
    m_list->setAlternatingRowColors(true);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(true);
}

void ConnectionsDialog::connectButtons()
{
    connect(m_edit, &QPushButton::clicked, this, [this] { startEditing(m_list->currentItem()); });
    connect(m_list, &QTreeWidget::itemActivated, this, &ConnectionsDialog::startEditing);
    connect(m_remove, &QPushButton::clicked, this, &ConnectionsDialog::removeCurrent);
    connect(m_test, &QPushButton::clicked, this, &ConnectionsDialog::testCurrent);
    connect(m_certificate, &CertificateButton::trusted, this, [this] {
        Q_EMIT certificateTrusted();
        testCurrent();
    });
    connect(m_certificate, &CertificateButton::forgotten, this, [this](const QString& endpoint) {
        showNote(tr("The certificate of %1 is no longer trusted.").arg(endpoint), false);
    });
    connect(m_certificate, &CertificateButton::failed, this,
        [this](const QString& sentence) { showNote(sentence, true); });
    connect(m_find, &QPushButton::clicked, this, &ConnectionsDialog::find);
    connect(m_demo, &QPushButton::clicked, this, [this] {
        addItem(QStringLiteral("demo:"));
        test(QStringLiteral("demo:"));
        updateButtons();
    });
    connect(m_add, &QPushButton::clicked, this, &ConnectionsDialog::checkAddress);
    connect(m_address, &QLineEdit::textChanged, this, [this] {
        showNote({}, false);
        updateButtons();
    });
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ConnectionsDialog::updateButtons);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_buttons, &QDialogButtonBox::accepted, this, [this] {
        Q_EMIT endpointsAccepted(endpoints());
        accept();
    });
    connect(
        &m_controller, &WizardController::drivesChanged, this, &ConnectionsDialog::showKnownStates);
    connect(
        &m_controller, &WizardController::actionsChanged, this, &ConnectionsDialog::updateButtons);
}

void ConnectionsDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void ConnectionsDialog::retranslate()
{
    setWindowTitle(tr("Connections"));
    m_introduction->setText(
        tr("Drives are reached through their web server, such as http://192.168.1.20, or a serial "
           "line, such as serial:/dev/ttyUSB0. A web address may contain a user name and password "
           "(http://user:password@host); they are used until the program ends and never stored."));
    m_list->setHeaderLabels({tr("Address"), tr("Drive"), tr("State")});
    m_list->setAccessibleName(tr("Connections"));
    m_edit->setText(tr("&Edit"));
    m_edit->setToolTip(tr("Change the address of the chosen connection"));
    m_remove->setText(tr("&Remove"));
    m_remove->setToolTip(tr("Remove the chosen connection"));
    m_test->setText(tr("&Test"));
    m_test->setToolTip(tr("Ask the drive at the selected address to identify itself"));
    m_demo->setText(tr("De&mo Drive"));
    m_certificate->retranslate();
    m_find->setText(tr("&Find …"));
    m_find->setToolTip(tr("Search the serial ports of this computer for drives"));
    m_demo->setToolTip(tr("Add the built-in demo drive to try everything without hardware"));
    m_addressLabel->setText(tr("&Address"));
    m_address->setPlaceholderText(QStringLiteral("http://192.168.1.20"));
    m_address->setAccessibleName(tr("Address"));
    m_address->setAccessibleDescription(
        tr("The address of a drive's web server, or a serial port"));
    m_address->setToolTip(m_address->accessibleDescription());
    m_buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Discard the changes (Esc)"));
    showKnownStates();
    updateButtons();
}

void ConnectionsDialog::addItem(const QString& endpoint)
{
    QTreeWidgetItem* item = itemOf(endpoint);
    if (!item) {
        item = new QTreeWidgetItem(m_list);
        item->setData(AddressColumn, endpointRole, endpoint);
        item->setText(AddressColumn, shownEndpoint(endpoint));
    }
    m_list->setCurrentItem(item);
    showKnownStates();
}

void ConnectionsDialog::showKnownStates()
{
    for (int row = 0; row < m_list->topLevelItemCount(); ++row) {
        QTreeWidgetItem& item = *m_list->topLevelItem(row);
        for (const DriveState& drive : m_controller.drives()) {
            if (drive.endpoint != shownEndpoint(endpointOf(item)))
                continue;
            item.setText(DriveColumn, drive.isDemo ? tr("%1 (demo)").arg(drive.name) : drive.name);
            if (drive.certificate)
                m_certificate->addRejected(*drive.certificate);
            const bool isConnected = drive.connection == DriveState::Connection::Connected;
            const bool isLost = drive.connection == DriveState::Connection::Lost;
            item.setText(StateColumn,
                isConnected  ? tr("connected")
                    : isLost ? drive.problem
                             : tr("connecting …"));
            item.setToolTip(StateColumn, item.text(StateColumn));
        }
    }
}

void ConnectionsDialog::showState(QTreeWidgetItem& item, const Result<DriveIdentity>& identity)
{
    const Tone tone = identity ? Tone::Success : Tone::Error;
    if (identity)
        m_certificate->removeRejected(endpointOf(item));
    else if (const auto rejected = rejectedCertificate(identity.error()))
        m_certificate->addRejected(*rejected);
    item.setIcon(StateColumn,
        symbolPixmap(identity ? Symbol::Success : Symbol::Error, frameColor(tone, palette()),
            connectionSymbolSize, devicePixelRatioF()));
    if (identity)
        item.setText(DriveColumn, QString::fromStdString(identity->name));
    item.setText(StateColumn,
        identity ? tr("answers; serial number %1, axes: %2")
                       .arg(identity->serialNumber)
                       .arg(identity->axes)
                 : errorText(identity.error()));
    item.setToolTip(StateColumn, item.text(StateColumn));
}

void ConnectionsDialog::testCurrent()
{
    if (const QTreeWidgetItem* item = m_list->currentItem())
        test(endpointOf(*item));
}

void ConnectionsDialog::test(const QString& endpoint)
{
    if (QTreeWidgetItem* item = itemOf(endpoint)) {
        item->setIcon(StateColumn, {});
        item->setText(StateColumn, tr("asking …"));
    }
    m_probe.ask(endpoint, [this, endpoint](const Result<DriveIdentity>& identity) {
        if (QTreeWidgetItem* item = itemOf(endpoint))
            showState(*item, identity);
    });
}

void ConnectionsDialog::find()
{
    std::vector<std::string> known;
    for (const QString& endpoint : endpoints())
        known.push_back(endpoint.toStdString());
    FindDrivesDialog::Options options{
        m_options.linkFactory, m_options.portCandidates, m_options.network, std::move(known)};
    auto* dialog = new FindDrivesDialog(std::move(options), this);
    connect(dialog, &FindDrivesDialog::endpointsChosen, this, [this](const QStringList& found) {
        for (const QString& endpoint : found) {
            addItem(endpoint);
            test(endpoint);
        }
        updateButtons();
    });
    dialog->open();
}

void ConnectionsDialog::startEditing(QTreeWidgetItem* item)
{
    if (!item)
        return;
    m_edited = endpointOf(*item);
    m_address->setText(editableText(m_edited));
    m_address->setFocus();
    m_address->selectAll();
    updateButtons();
}

void ConnectionsDialog::checkAddress()
{
    QString endpoint = completedEndpoint(m_address->text());
    if (endpoint.isEmpty() || m_busy->isBusy())
        return;
    if (!m_edited.isEmpty() && endpoint == editableText(m_edited))
        endpoint = m_edited;
    else
        m_address->setText(endpoint); // as it is taken
    if (endpoint != m_edited && itemOf(endpoint)) {
        showNote(tr("This address is already in the list."), true);
        return;
    }
    m_busy->setBusy(true);
    showNote(tr("Asking %1 …").arg(shownEndpoint(endpoint)), false);
    updateButtons();
    m_probe.ask(endpoint, [this, endpoint](const Result<DriveIdentity>& identity) {
        m_busy->setBusy(false);
        takeAddress(endpoint, identity);
        updateButtons();
    });
}

void ConnectionsDialog::takeAddress(const QString& endpoint, const Result<DriveIdentity>& identity)
{
    if (!identity && identity.error().code == ErrorCode::InvalidEndpoint) {
        showNote(errorText(identity.error()), true);
        m_address->setFocus();
        return;
    }
    if (!m_edited.isEmpty() && m_edited != endpoint)
        delete itemOf(m_edited);
    m_edited.clear();
    m_address->clear();
    addItem(endpoint);
    showState(*itemOf(endpoint), identity);
    if (!identity)
        showNote(tr("Added, but not answering yet: %1").arg(errorText(identity.error())), true);
}

void ConnectionsDialog::removeCurrent()
{
    const QTreeWidgetItem* item = m_list->currentItem();
    if (item && endpointOf(*item) == m_edited)
        m_edited.clear();
    delete item;
    updateButtons();
}

void ConnectionsDialog::showNote(const QString& text, bool isError)
{
    if (isError)
        m_note->setTone(Tone::Error);
    else
        m_note->setMuted();
    m_note->setText(text);
}

void ConnectionsDialog::updateButtons()
{
    const bool hasItem = m_list->currentItem() != nullptr;
    for (QPushButton* button : {m_edit, m_remove, m_test})
        button->setEnabled(hasItem);
    const QTreeWidgetItem* item = m_list->currentItem();
    m_certificate->choose(item ? endpointOf(*item) : QString());
    m_demo->setEnabled(!itemOf(QStringLiteral("demo:")));
    m_add->setText(m_edited.isEmpty() ? tr("A&dd") : tr("Chan&ge"));
    m_add->setToolTip(tr("Checks the address and adds it to the list"));
    m_add->setEnabled(!m_address->text().trimmed().isEmpty() && !m_busy->isBusy());
    m_add->setDefault(m_add->isEnabled());
    QPushButton* accept = m_buttons->button(QDialogButtonBox::Ok);
    accept->setDefault(!m_add->isEnabled());
    accept->setEnabled(!m_controller.isWriting());
    accept->setToolTip(m_controller.isWriting() ? tr("Not possible while a drive is being written")
                                                : tr("Use the drives of the list"));
}

QTreeWidgetItem* ConnectionsDialog::itemOf(const QString& endpoint) const
{
    for (int row = 0; row < m_list->topLevelItemCount(); ++row) {
        if (endpointOf(*m_list->topLevelItem(row)) == endpoint)
            return m_list->topLevelItem(row);
    }
    return nullptr;
}

QStringList ConnectionsDialog::endpoints() const
{
    QStringList list;
    for (int row = 0; row < m_list->topLevelItemCount(); ++row)
        list += endpointOf(*m_list->topLevelItem(row));
    return list;
}

} // namespace axiscomp::ui
