// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/outcome/multi_axis_outcome.h"

#include "ui/data/column_mapping.h"
#include "ui/session/axis_list.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <charconv>

namespace axiscomp::ui {

namespace {

class MultiAxisOutcomes {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::MultiAxisOutcome)

public:
    /// Without those that had everything already. What has no table is neither stored nor volatile.
    [[nodiscard]] static Outcome allWritten(const QStringList& axes, const MultiAxisReport& report)
    {
        QStringList written;
        QStringList stored;
        QStringList notStored;
        for (std::size_t n = 0; n < report.writes.size(); ++n) {
            if (!report.writes[n])
                continue;
            const QString& axis = axes[static_cast<qsizetype>(n)];
            const CompensationSetup& now = report.writes[n]->now.setup;
            written += axis;
            if (!now.slot.empty())
                (now.persistency == Persistency::Persistent ? stored : notStored) += axis;
        }
        if (written.isEmpty())
            return {tr("The axes already had all of this."), false, {}};
        QStringList sentences{tr("Written and verified: %1.").arg(listed(written))};
        if (stored == written)
            sentences += tr("This is stored in flash.");
        else if (!stored.isEmpty())
            sentences += tr("Stored in flash: %1.").arg(listed(stored));
        if (notStored == written)
            sentences += tr("This is volatile: a reboot of the drive restores the stored state.");
        else if (!notStored.isEmpty())
            sentences += tr("Volatile: %1; a reboot of the drive restores the stored state.")
                             .arg(listed(notStored));
        return {sentences.join(u' '), false, {}};
    }
    [[nodiscard]] static Outcome withoutFiles(const Outcome& written, const Error& error)
    {
        return {tr("%1 The tables that no axis uses are not all restored: %2")
                    .arg(written.text, errorText(error)),
            true, errorOutcome(error).detail};
    }
    [[nodiscard]] static Outcome nothingWritten(
        const QStringList& axes, const Error& error, const QString& sentence)
    {
        const QString what =
            error.code == ErrorCode::Cancelled ? tr("The writes were stopped.") : sentence;
        return {what + u' ' + states({}, axes), true, errorOutcome(error).detail};
    }
    [[nodiscard]] static Outcome stoppedAt(
        const QStringList& axes, qsizetype failed, const Error& error)
    {
        const bool isOld =
            error.code != ErrorCode::OutcomeUnknown && error.code != ErrorCode::RollbackFailed;
        const QString what = error.code == ErrorCode::Cancelled
            ? tr("The writes were stopped at %1.").arg(axes.at(failed))
            : ofAxis(axes.at(failed), errorText(error));
        return {what + u' ' + states(axes.first(failed), axes.sliced(isOld ? failed : failed + 1)),
            true, errorOutcome(error).detail};
    }
    [[nodiscard]] static QString ofAxis(const QString& axis, const QString& sentence)
    {
        return tr("%1: %2", "axis and sentence").arg(axis, sentence);
    }
    [[nodiscard]] static QString listed(const QStringList& axes) { return listText(axes); }

private:
    [[nodiscard]] static QString states(const QStringList& withNew, const QStringList& withOld)
    {
        QString text = withNew.isEmpty() ? tr("No axis was changed.")
                                         : tr("New state: %1.").arg(listed(withNew));
        if (!withOld.isEmpty())
            text += u' ' + tr("Old state, complete: %1.").arg(listed(withOld));
        return text;
    }
};

} // namespace

Outcome multiAxisOutcome(std::span<const AxisEntry> axes, const Result<MultiAxisReport>& report)
{
    QStringList names;
    for (const AxisEntry& entry : axes)
        names += axisNameOnDrive(entry);
    if (!report)
        return MultiAxisOutcomes::nothingWritten(
            names, report.error(), multiAxisErrorText(report.error(), axes));
    for (std::size_t n = 0; n < report->writes.size(); ++n) {
        const auto& write = report->writes[n];
        if (!holdsNewState(write))
            return MultiAxisOutcomes::stoppedAt(names, static_cast<qsizetype>(n), write.error());
    }
    const Outcome written = MultiAxisOutcomes::allWritten(names, *report);
    return report->filesProblem ? MultiAxisOutcomes::withoutFiles(written, *report->filesProblem)
                                : written;
}

QString multiAxisErrorText(const Error& error, std::span<const AxisEntry> axes)
{
    const auto axis = error.context.integer("ofAxis");
    return axis
        ? MultiAxisOutcomes::ofAxis(axisNameAmong(axes, static_cast<int>(*axis)), errorText(error))
        : errorText(error);
}

} // namespace axiscomp::ui
