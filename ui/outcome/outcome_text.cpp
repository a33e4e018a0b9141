// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/outcome/outcome_text.h"

#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace axiscomp::ui {

namespace {

class Outcomes {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::Outcome)

public:
    [[nodiscard]] static QString oldStateHeld()
    {
        return tr("The drive holds the complete old state.");
    }
    [[nodiscard]] static Outcome written(const WriteReport& report);
    [[nodiscard]] static Outcome notWritten(const Error& error);
    [[nodiscard]] static Outcome switched(Switch wanted, const Activation& activation);
    [[nodiscard]] static Outcome notSwitched(const Error& error);
    [[nodiscard]] static QString proved(const Proof& proof, const AxisInfo& axis);
    [[nodiscard]] static QString shown(const Activation& activation, const Proof& proof);
    [[nodiscard]] static Outcome contradicted(const Error& error);
    [[nodiscard]] static Outcome restored(const Restoration& restoration);
    [[nodiscard]] static Outcome recovered(bool finishes, const Result<WriteReport>& report);
    [[nodiscard]] static QString settled(const SettledWrite& settledWrite);
    [[nodiscard]] static QString unfinished(const SettledWrite& settled);
};

QString errorDetail(const Error& error)
{
    const std::string_view name = errorName(error.code);
    QString detail = QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()))
        + QStringLiteral(": ") + QString::fromStdString(sentence(error));
    if (!error.detail.empty())
        detail += QStringLiteral(" [") + QString::fromStdString(error.detail) + u']';
    return detail;
}

Outcome Outcomes::written(const WriteReport& report)
{
    if (!report.plan.deletedSlot.empty())
        return {tr("Deleted and verified: %1 is empty, and the axis uses no table.")
                    .arg(QString::fromStdString(report.plan.deletedSlot)),
            false, QStringLiteral("backup: ") + QString::fromStdString(report.backup.string())};
    const QString persistency = report.now.setup.persistency == Persistency::Persistent
        ? tr("It is stored in flash.")
        : tr("It is volatile: a reboot of the drive restores the stored state.");
    return {tr("Written and verified: the drive holds the new state. %1").arg(persistency), false,
        QStringLiteral("backup: ") + QString::fromStdString(report.backup.string())};
}

Outcome Outcomes::notWritten(const Error& error)
{
    Outcome outcome{errorText(error), true, errorDetail(error)};
    switch (error.code) {
    case ErrorCode::NothingToWrite:
        return {tr("Nothing to write: the drive already has all of this."), false, outcome.detail};
    case ErrorCode::OutcomeUnknown: // these two say themselves what the drive holds
    case ErrorCode::RollbackFailed:
        return outcome;
    case ErrorCode::OtherDrive:
    case ErrorCode::ChangedMeanwhile: // by somebody else, or by a restart
        outcome.text += u' ' + tr("Nothing was written.");
        return outcome;
    case ErrorCode::Cancelled:
        outcome.text = tr("The write was stopped.");
        break;
    default:
        break;
    }
    outcome.text += u' ' + oldStateHeld();
    return outcome;
}

QString Outcomes::proved(const Proof& proof, const AxisInfo& axis)
{
    QString difference = smallValueText(proof.largestDifference, axis.unit);
    if (difference.startsWith(u'+'))
        difference.remove(0, 1); // a size
    return tr("Proved over %1 of the table: largest difference %2.")
        .arg(percentageText(proof.provedShare), difference);
}

QString Outcomes::shown(const Activation& activation, const Proof& proof)
{
    if (const auto why = activation.notProved())
        return tr("Not proved.") + u' ' + sentenceText(*why);
    return proof.extent == Proof::Extent::IndicesOnly ? tr("Its table indices are right.")
                                                      : proved(proof, activation.status.axis);
}

Outcome Outcomes::switched(Switch wanted, const Activation& activation)
{
    if (wanted == Switch::Deactivate)
        return {tr("The compensation is off."), false, {}};
    const QString state = wanted == Switch::Activate
        ? tr("The compensation is active.")
        : tr("The compensation is being evaluated: the drive adds nothing.");
    if (!activation.proof)
        return {state, false, {}};
    const Result<Proof>& proof = *activation.proof;
    if (proof)
        return {state + u' ' + shown(activation, *proof), activation.notProved().has_value(), {}};
    const QString reason = proof.error().code == ErrorCode::Cancelled ? tr("The proof was stopped.")
                                                                      : errorText(proof.error());
    if (activation.isPutBack && activation.status.isOn())
        return {tr("The proof failed, and the drive evaluates again as before. %1").arg(reason),
            true, errorDetail(proof.error())};
    if (activation.isPutBack)
        return {tr("The proof failed, and the compensation was switched off again. %1").arg(reason),
            true, errorDetail(proof.error())};
    return {tr("%1 But the proof failed: deactivate it unless you know why. %2").arg(state, reason),
        true, errorDetail(proof.error())};
}

Outcome Outcomes::notSwitched(const Error& error)
{
    Outcome outcome = errorOutcome(error);
    if (error.context.contains("compensation"))
        outcome.text += u' '
            + tr("The compensation may be on, and is not proved. Connect again to see what it "
                 "does.");
    return outcome;
}

/// The axis moves: switching off here and now is for the user to decide.
Outcome Outcomes::contradicted(const Error& error)
{
    return {tr("The compensation is active, but the drive contradicts its table. Stop the axis and "
               "deactivate. %1")
                .arg(errorText(error)),
        true, errorDetail(error)};
}

Outcome Outcomes::restored(const Restoration& restoration)
{
    const QString time = localTimeText(restoration.backupTime);
    const QString text = restoration.isBeforeWrite
        ? tr("Restored: the drive holds the state from before the write of %1.").arg(time)
        : restoration.otherDrive
        ? tr("Restored: the drive holds the state in the backup file of %1, made of the drive with "
             "the serial number %2.")
              .arg(time)
              .arg(*restoration.otherDrive)
        : tr("Restored: the drive holds the state in the backup file of %1.").arg(time);
    return {text, false,
        QStringLiteral("backup: ") + QString::fromStdString(restoration.backup.string())};
}

Outcome Outcomes::recovered(bool finishes, const Result<WriteReport>& report)
{
    if (!report)
        return {tr("%1 The write is still unfinished.").arg(errorText(report.error())), true,
            errorDetail(report.error())};
    return {finishes ? tr("Finished and verified: the drive holds the complete new state.")
                     : tr("Undone and verified: the drive holds the complete old state."),
        false, QStringLiteral("backup: ") + QString::fromStdString(report->backup.string())};
}

QString Outcomes::settled(const SettledWrite& settledWrite)
{
    using Unfinished = AxisCompensator::UnfinishedOutcome;
    switch (settledWrite.outcome) {
    case Unfinished::Old:
        return tr("The drive holds the complete old state.");
    case Unfinished::New:
        return tr("The drive holds the complete new state; nothing more to do.");
    case Unfinished::NewUnsaved:
        if (settledWrite.recovery.isBackupUnread)
            return tr("The drive holds the complete new state, but its parameters may not be "
                      "saved, and the backup of the old state cannot be read: write again to save "
                      "them, or restore another backup.");
        return tr("The drive holds the complete new state, but its parameters may not be saved.");
    case Unfinished::Unknown:
        return tr("Which state the drive holds is not known, since the backup of the old one "
                  "cannot be read: write again or restore another backup before activating the "
                  "axis.");
    case Unfinished::Neither:
        break;
    }
    return tr("The drive holds neither the old nor the new state: finish or undo the write before "
              "activating the axis.");
}

QString Outcomes::unfinished(const SettledWrite& settledWrite)
{
    QStringList sentences{
        tr("The write of %1 was interrupted (last step: %2). %3")
            .arg(localTimeText(settledWrite.entry.time),
                stepText(QString::fromStdString(settledWrite.entry.step)), settled(settledWrite))};
    for (const Text& doubt : settledWrite.recovery.doubts)
        sentences += sentenceText(doubt);
    return sentences.join(u' ');
}

} // namespace

Outcome writeOutcome(const Result<WriteReport>& report)
{
    return report ? Outcomes::written(*report) : Outcomes::notWritten(report.error());
}

Outcome activationOutcome(Switch wanted, const Result<Activation>& activation)
{
    return activation ? Outcomes::switched(wanted, *activation)
                      : Outcomes::notSwitched(activation.error());
}

QString proofText(const Activation& activation)
{
    return activation.proof && *activation.proof ? Outcomes::shown(activation, **activation.proof)
                                                 : QString();
}

Outcome restorationOutcome(const Result<Restoration>& restoration)
{
    return restoration ? Outcomes::restored(*restoration)
                       : Outcomes::notWritten(restoration.error());
}

Outcome recoveryOutcome(bool finishes, const Result<WriteReport>& report)
{
    return Outcomes::recovered(finishes, report);
}

Outcome settledOutcome(const SettledWrite& settled)
{
    using Unfinished = AxisCompensator::UnfinishedOutcome;
    const bool isDone = settled.outcome == Unfinished::New;
    return {Outcomes::unfinished(settled), !isDone,
        QStringLiteral("backup: ") + QString::fromStdString(settled.entry.backup.string())};
}

Outcome movingProofFailure(const Error& error)
{
    return Outcomes::contradicted(error);
}

Outcome errorOutcome(const Error& error)
{
    return {errorText(error), true, errorDetail(error)};
}

} // namespace axiscomp::ui
