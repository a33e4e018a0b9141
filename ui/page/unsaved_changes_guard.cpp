// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/unsaved_changes_guard.h"

#include "ui/controller/wizard_controller.h"
#include "ui/page/message_stack.h"

namespace axiscomp::ui {

namespace {

QString questionId()
{
    return QStringLiteral("leaveQuestion");
}

QString currentLabel(const WizardController& controller)
{
    const int axis = controller.currentAxis();
    return axis < 0 ? QString() : controller.axes().at(static_cast<std::size_t>(axis)).label;
}

} // namespace

UnsavedChangesGuard::UnsavedChangesGuard(
    WizardController& controller, MessageStack& messages, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_messages(messages)
{
    // Queued: the outcome of what has ended is told right after that it has ended.
    connect(&controller, &WizardController::busyChanged, this, &UnsavedChangesGuard::follow,
        Qt::QueuedConnection);
    connect(
        &controller.setup(), &SetupModel::fieldChanged, this, &UnsavedChangesGuard::forgetQuestion);
}

QString UnsavedChangesGuard::unsavedRecord() const
{
    return m_record.unsaved ? m_record.unsaved() : QString();
}

bool UnsavedChangesGuard::isUnsettled() const
{
    return m_controller.setup().isDirty() || !unsavedRecord().isEmpty();
}

/// What it was about has gone.
void UnsavedChangesGuard::forgetQuestion()
{
    const bool isDue = m_isAboutClosing ? isUnsettled() : m_controller.setup().isDirty();
    if (!isDue && !m_controller.isWriting())
        m_messages.remove(questionId());
}

void UnsavedChangesGuard::followRecord()
{
    if (m_isAboutClosing && m_messages.contains(questionId()))
        forgetQuestion();
}

void UnsavedChangesGuard::loseChanges(Reason reason, std::function<void()> action)
{
    if (m_controller.setup().isDirty())
        askAboutChanges(reason, std::move(action));
    else
        action();
}

bool UnsavedChangesGuard::mayClose()
{
    if (m_isAgreed)
        return true;
    if (m_controller.isWriting()) {
        askWhileWriting();
        return false;
    }
    if (isUnsettled()) {
        askBeforeClosing();
        return false;
    }
    return true;
}

void UnsavedChangesGuard::closeNow()
{
    m_messages.remove(questionId());
    agree();
}

void UnsavedChangesGuard::retranslate()
{
    if (!m_messages.contains(questionId()))
        return;
    const auto ask = m_ask; // it sets m_ask
    ask();
}

void UnsavedChangesGuard::closeWhen(Closing when)
{
    m_closing = when;
    follow();
}

void UnsavedChangesGuard::askWhileWriting()
{
    m_isAboutClosing = true;
    m_ask = [this] { askWhileWriting(); };
    Message question;
    question.id = questionId();
    question.tone = Tone::Warning;
    question.text = tr("A write is in progress. Stopping rolls it back first.");
    question.buttons = {
        {QStringLiteral("stopAndCloseButton"), tr("&Stop and Close"),
            [this] {
                m_controller.cancel();
                closeWhen(Closing::WhenIdle);
            }},
        {QStringLiteral("closeWhenDoneButton"), tr("Close When Don&e"),
            [this] { closeWhen(Closing::WhenWritten); }},
        {QStringLiteral("stayButton"), tr("Sta&y"), [this] { m_closing = Closing::No; }},
    };
    question.isClosable = false;
    m_messages.show(question);
}

QString UnsavedChangesGuard::agreement(Reason reason)
{
    switch (reason) {
    case Reason::ChangeAxis:
        return tr("Discard and Chan&ge Axis");
    case Reason::ChangeConnections:
        return tr("Discard and Chan&ge Connections");
    case Reason::Close:
        break;
    }
    return tr("Close Without Writin&g");
}

/// Once, for the fields and the record together.
void UnsavedChangesGuard::askBeforeClosing()
{
    const QString record = unsavedRecord();
    if (record.isEmpty()) {
        askAboutChanges(Reason::Close, [this] { agree(); });
        return;
    }
    m_ask = [this] { askBeforeClosing(); };
    m_isAboutClosing = true;
    Message question;
    question.id = questionId();
    question.tone = Tone::Warning;
    question.text = record;
    if (m_controller.setup().isDirty())
        question.text =
            tr("%1 has changes that are not written to the drive.").arg(currentLabel(m_controller))
            + u' ' + record;
    question.buttons = {
        {QStringLiteral("saveAndCloseButton"), tr("Save Record, &Then Close"),
            [this] { m_record.save([this] { agree(); }); }},
        {QStringLiteral("loseChangesButton"), tr("Close Without Savin&g"),
            [this] {
                m_record.discard();
                agree();
            }},
        {QStringLiteral("stayButton"), tr("Sta&y"), [] {}},
    };
    question.isClosable = false;
    m_messages.show(question);
}

void UnsavedChangesGuard::askAboutChanges(Reason reason, std::function<void()> action)
{
    m_isAboutClosing = reason == Reason::Close;
    m_ask = [this, reason, action] { askAboutChanges(reason, action); };
    Message question;
    question.id = questionId();
    question.tone = Tone::Warning;
    question.text =
        tr("%1 has changes that are not written to the drive.").arg(currentLabel(m_controller));
    question.buttons = {
        {QStringLiteral("loseChangesButton"), agreement(reason), std::move(action)},
        {QStringLiteral("stayButton"), tr("Sta&y"), [] {}},
    };
    question.isClosable = false;
    m_messages.show(question);
}

void UnsavedChangesGuard::follow()
{
    if (m_controller.isWriting())
        return;
    const Closing closing = std::exchange(m_closing, Closing::No);
    if (closing == Closing::No)
        return;
    m_messages.remove(questionId());
    // What could not be put back, or was not written, is to be read before the window goes.
    const auto& status = m_controller.status();
    const bool isUnsettledOnDrive = status && status->unfinishedWrite;
    const bool hasFailed = closing == Closing::WhenWritten && m_controller.isOutcomeAnError();
    if (isUnsettledOnDrive || hasFailed)
        return;
    // The write has settled the fields; the record is asked about before it is lost.
    if (unsavedRecord().isEmpty())
        agree();
    else
        askBeforeClosing();
}

void UnsavedChangesGuard::agree()
{
    m_isAgreed = true;
    Q_EMIT closeAgreed();
}

} // namespace axiscomp::ui
