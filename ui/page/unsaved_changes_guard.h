// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

namespace axiscomp::ui {

class MessageStack;
class WizardController;

/// Asks, within the page, before something is lost: unwritten changes when another axis is chosen
/// or the window is closed, and a write that runs or a record that is not saved when it is closed.
class UnsavedChangesGuard : public QObject {
    Q_OBJECT

public:
    UnsavedChangesGuard(
        WizardController& controller, MessageStack& messages, QObject* parent = nullptr);

    /// What changes that are not written would be lost for.
    enum class Reason { ChangeAxis, ChangeConnections, Close };

    /// Does it at once when nothing is unwritten, otherwise when the user agrees.
    void loseChanges(Reason reason, std::function<void()> action);
    /// The record that is lost with the window.
    struct WatchedRecord {
        /// What is unsaved, as a sentence; empty: nothing of it.
        std::function<QString()> unsaved;
        std::function<void(std::function<void()> done)> save; ///< done: only when it is saved
        std::function<void()> discard; ///< what is unsaved is not wanted
    };
    void watchRecord(WatchedRecord record) { m_record = std::move(record); }
    /// It has been changed, or saved.
    void followRecord();
    /// False: the user is asked, closeAgreed may follow.
    [[nodiscard]] bool mayClose();
    /// Without questions; closeAgreed follows at once, also while a write is running.
    void closeNow();
    /// A question that is open is asked in the new language.
    void retranslate();

Q_SIGNALS:
    void closeAgreed();

private:
    enum class Closing { No, WhenIdle, WhenWritten };
    void closeWhen(Closing when);
    void askWhileWriting();
    void askAboutChanges(Reason reason, std::function<void()> action);
    /// Whether there is something to lose by closing.
    [[nodiscard]] bool isUnsettled() const;
    [[nodiscard]] QString unsavedRecord() const;
    void askBeforeClosing();
    void forgetQuestion();
    [[nodiscard]] static QString agreement(Reason reason);
    void follow();
    void agree();

    WizardController& m_controller;
    MessageStack& m_messages;
    WatchedRecord m_record;
    Closing m_closing = Closing::No;
    std::function<void()> m_ask; ///< the question that was asked last
    bool m_isAboutClosing = false; ///< that question
    bool m_isAgreed = false;
};

} // namespace axiscomp::ui
