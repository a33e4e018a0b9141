// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace axiscomp::ui {

class MessageStack;
class WizardController;
struct DriveState;
struct RejectedCertificate;

/// What the page tells on its own: how an operation ended, that the open file has changed, that the
/// drive is the demo.
class MessagePresenter : public QObject {
    Q_OBJECT

public:
    MessagePresenter(
        WizardController& controller, MessageStack& messages, QObject* parent = nullptr);

    /// Nothing is configured: the demo drive is what there is.
    void offerDemo();
    void showFailure(const QString& sentence);
    void retranslate();
    /// The drive of the page cannot be reached: also after this was put away.
    void showConnection();
    /// The user wants this drive, which cannot be used now: why, by its name, until it answers;
    /// then that it can be gone to. The page goes nowhere by itself.
    void showUnreachable(const QString& endpoint);
    void forgetUnreachable();

Q_SIGNALS:
    void driveChosen(const QString& endpoint); ///< that was not reachable, and is now
    void connectionsRequested();
    void certificateRequested(const axiscomp::ui::RejectedCertificate& certificate);

private:
    void showOutcome();
    void followUnreachable();
    void sayUnreachable(const DriveState& drive);
    void sayAnswered(const DriveState& drive);
    void showFileChange();
    void showUnfinishedWrite();
    void putUnfinishedWriteAway();

    WizardController& m_controller;
    MessageStack& m_messages;
    QString m_putAway; ///< what the user wants to decide later
    QString m_unreachable; ///< the address of the drive that the user wants; empty: none
    QString m_offered; ///< the offer that is shown, with its reasons
};

} // namespace axiscomp::ui
