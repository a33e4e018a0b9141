// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/message_presenter.h"

#include "ui/controller/wizard_controller.h"
#include "ui/page/message_stack.h"

#include <QFileInfo>

#include <algorithm>

namespace axiscomp::ui {

namespace {

const QLatin1StringView outcomeId("outcomeMessage");
const QLatin1StringView fileId("fileChangedMessage");
const QLatin1StringView demoId("demoMessage");
const QLatin1StringView failureId("failureMessage");
const QLatin1StringView connectionId("connectionMessage");
const QLatin1StringView unfinishedId("unfinishedMessage");
const QLatin1StringView unreachableId("unreachableMessage");

/// The drive that the page is about, when it cannot be reached.
const DriveState* lostDrive(const WizardController& controller)
{
    const int axis = controller.currentAxis();
    for (const DriveState& drive : controller.drives()) {
        const bool isCurrent = axis < 0
            || drive.endpoint == controller.axes().at(static_cast<std::size_t>(axis)).endpoint;
        if (isCurrent && drive.connection == DriveState::Connection::Lost)
            return &drive;
    }
    return nullptr;
}

} // namespace

MessagePresenter::MessagePresenter(
    WizardController& controller, MessageStack& messages, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_messages(messages)
{
    connect(&controller, &WizardController::outcomeChanged, this, &MessagePresenter::showOutcome);
    connect(
        &controller, &WizardController::dataFileChanged, this, &MessagePresenter::showFileChange);
    connect(&controller, &WizardController::drivesChanged, this, &MessagePresenter::showConnection);
    connect(&controller, &WizardController::currentAxisChanged, this,
        &MessagePresenter::showConnection);
    for (const auto changed : {&WizardController::drivesChanged, &WizardController::axesChanged,
             &WizardController::currentAxisChanged})
        connect(&controller, changed, this, &MessagePresenter::followUnreachable);
    for (const auto changed : {&WizardController::statusChanged, &WizardController::actionsChanged,
             &WizardController::busyChanged, &WizardController::currentAxisChanged})
        connect(&controller, changed, this, &MessagePresenter::showUnfinishedWrite);
}

void MessagePresenter::offerDemo()
{
    Message message;
    message.id = demoId;
    message.text =
        tr("This is the built-in demo drive. Try everything; no real drive is affected.");
    message.buttons = {{QStringLiteral("setUpDrivesButton"), tr("Wor&k with Real Drives…"),
        [this] { Q_EMIT connectionsRequested(); }}};
    m_messages.show(message);
}

void MessagePresenter::showFailure(const QString& sentence)
{
    Message message;
    message.id = failureId;
    message.tone = Tone::Error;
    message.text = sentence;
    m_messages.show(message);
}

void MessagePresenter::retranslate()
{
    if (m_messages.contains(demoId))
        offerDemo();
    if (m_messages.contains(outcomeId))
        showOutcome();
    m_offered.clear();
    showUnfinishedWrite();
    showFileChange();
    showConnection();
    followUnreachable();
}

void MessagePresenter::showConnection()
{
    const DriveState* drive = lostDrive(m_controller);
    if (!drive) {
        m_messages.remove(connectionId);
        return;
    }
    Message message;
    message.id = connectionId;
    message.tone = Tone::Error;
    message.text = m_controller.setup().isDirty()
        ? tr("%1 Your changes are kept; reconnecting …").arg(drive->problem)
        : tr("%1 Reconnecting …").arg(drive->problem);
    if (drive->certificate)
        message.buttons = {{QStringLiteral("lookAtCertificateButton"), tr("S&how Certificate…"),
            [this, certificate = *drive->certificate] {
                Q_EMIT certificateRequested(certificate);
            }}};
    if (m_messages.text(message.id) != message.text)
        m_messages.show(message);
}

void MessagePresenter::showUnreachable(const QString& endpoint)
{
    const auto drive = std::ranges::find(m_controller.drives(), endpoint, &DriveState::endpoint);
    if (drive == m_controller.drives().end())
        return;
    m_unreachable = endpoint;
    sayUnreachable(*drive);
}

void MessagePresenter::forgetUnreachable()
{
    m_unreachable.clear();
    m_messages.remove(unreachableId);
}

void MessagePresenter::followUnreachable()
{
    if (!m_messages.contains(unreachableId)) // put away
        m_unreachable.clear();
    if (m_unreachable.isEmpty())
        return;
    const auto drive =
        std::ranges::find(m_controller.drives(), m_unreachable, &DriveState::endpoint);
    const int current = m_controller.currentAxis();
    const bool isShown = current >= 0
        && m_controller.axes().at(static_cast<std::size_t>(current)).endpoint == m_unreachable;
    if (isShown || drive == m_controller.drives().end())
        forgetUnreachable();
    else if (m_controller.usableAxisOf(m_unreachable) >= 0)
        sayAnswered(*drive);
    else
        sayUnreachable(*drive);
}

/// It may be minutes later: another axis would come under the pointer that is about to press.
void MessagePresenter::sayAnswered(const DriveState& drive)
{
    Message message;
    message.id = unreachableId;
    message.tone = Tone::Information;
    message.text = tr("%1 answers now.").arg(drive.name.isEmpty() ? drive.endpoint : drive.name);
    message.buttons = {{QStringLiteral("displayDriveButton"), tr("Displa&y Drive"),
        [this, endpoint = drive.endpoint] {
            forgetUnreachable();
            Q_EMIT driveChosen(endpoint);
        }}};
    if (m_messages.text(message.id) != message.text)
        m_messages.show(message);
}

void MessagePresenter::sayUnreachable(const DriveState& drive)
{
    const QString name = drive.name.isEmpty() ? drive.endpoint : drive.name;
    Message message;
    message.id = unreachableId;
    message.tone = Tone::Error;
    if (drive.connection == DriveState::Connection::Connecting) {
        message.tone = Tone::Information;
        message.text = tr("%1 is being asked …").arg(name);
    } else if (drive.connection == DriveState::Connection::Connected) {
        message.text = tr("%1 has no axis with compensation registers.").arg(name);
    } else {
        message.text = tr("%1 does not answer. %2", "drive, reason").arg(name, drive.problem);
    }
    if (drive.connection != DriveState::Connection::Connecting)
        message.buttons = {
            {QStringLiteral("tryAgainButton"), tr("Tr&y Again"), [this, endpoint = drive.endpoint] {
                 m_controller.tryDrive(endpoint);
                 showUnreachable(endpoint);
             }}};
    if (m_messages.text(message.id) != message.text)
        m_messages.show(message);
}

void MessagePresenter::showOutcome()
{
    Message message;
    message.id = outcomeId;
    message.tone = m_controller.isOutcomeAnError() ? Tone::Error
        : m_controller.isOutcomeAWarning()         ? Tone::Warning
                                                   : Tone::Success;
    message.text = m_controller.outcome();
    if (message.text.isEmpty() || message.text == m_controller.unfinishedWrite())
        m_messages.remove(message.id);
    else if (m_messages.text(message.id) != message.text)
        m_messages.show(message);
}

/// In the page, not in the way: everything else can be done before this is decided.
void MessagePresenter::showUnfinishedWrite()
{
    const QString text = m_controller.unfinishedWrite();
    const ActionState finish = m_controller.action(Action::FinishWrite);
    const ActionState undo = m_controller.action(Action::UndoWrite);
    if (text.isEmpty() || text == m_putAway || m_controller.busy().isBusy) {
        m_messages.remove(unfinishedId);
        m_offered.clear();
        if (text.isEmpty())
            m_putAway.clear();
        return;
    }
    Message message;
    message.id = unfinishedId;
    message.tone = Tone::Warning;
    message.text = text;
    for (const ActionState& state : {finish, undo}) {
        if (!state.isEnabled && !message.text.contains(state.reason))
            message.text += u' ' + state.reason;
    }
    message.buttons = {{QStringLiteral("finishWriteButton"), tr("&Finish Write"),
                           [this] { m_controller.finishWrite(); }, finish.isEnabled, finish.reason},
        {QStringLiteral("undoWriteButton"), tr("Undo Wri&te"), [this] { m_controller.undoWrite(); },
            undo.isEnabled, undo.reason},
        {QStringLiteral("laterButton"), tr("&Keep for Later"),
            [this] { putUnfinishedWriteAway(); }}};
    message.isClosable = false;
    const QString offered = message.text + finish.reason + undo.reason;
    if (m_offered == offered && m_messages.contains(unfinishedId))
        return;
    m_offered = offered;
    m_messages.show(message);
}

void MessagePresenter::putUnfinishedWriteAway()
{
    m_putAway = m_controller.unfinishedWrite();
}

void MessagePresenter::showFileChange()
{
    const DataFile& file = m_controller.dataFile();
    if (!file.hasChangedOnDisk || file.isReading) {
        m_messages.remove(fileId);
        return;
    }
    Message message;
    message.id = fileId;
    message.text = tr("%1 has changed on disk.").arg(QFileInfo(file.path).fileName());
    message.buttons = {{QStringLiteral("readAgainButton"), tr("Read A&gain"),
        [this] { m_controller.readDataAgain(); }}};
    if (m_messages.text(message.id) != message.text)
        m_messages.show(message);
}

} // namespace axiscomp::ui
