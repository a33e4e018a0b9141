// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

namespace axiscomp::ui {

class MessageStack;
class WizardController;

/// Asks, within the page, before something is lost: unwritten changes when another axis is chosen
/// or the window is closed, and a write that runs when it is closed.
class UnsavedChangesGuard : public QObject {
    Q_OBJECT

public:
    UnsavedChangesGuard(
        WizardController& controller, MessageStack& messages, QObject* parent = nullptr);

    /// Does it at once when nothing is unwritten, otherwise when the user agrees. action in words:
    /// "Change the Axis".
    void loseChanges(const QString& actionText, std::function<void()> action);
    /// False: the user is asked, closeAgreed may follow.
    [[nodiscard]] bool mayClose();
    /// Without questions; closeAgreed follows at once, also while a write is running.
    void closeNow();

Q_SIGNALS:
    void closeAgreed();

private:
    enum class Closing { No, WhenIdle, WhenWritten };
    void closeWhen(Closing when);
    void askWhileWriting();
    void askAboutChanges(const QString& actionText, std::function<void()> action);
    void follow();
    void agree();

    WizardController& m_controller;
    MessageStack& m_messages;
    Closing m_closing = Closing::No;
    bool m_isAgreed = false;
};

} // namespace axiscomp::ui
