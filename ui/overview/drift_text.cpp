// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overview/drift_text.h"

#include "core/machine/machine_texts.h"
#include "core/text/utf8.h"
#include "ui/session/axis_list.h"
#include "ui/text/message_text.h"
#include "ui/text/state_text.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace axiscomp::ui {

namespace {

class DriftText {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::DriftText)

public:
    [[nodiscard]] static QString state(const AxisDrift& drift)
    {
        using State = AxisDrift::State;
        switch (drift.state) {
        case State::NotInFile:
            return tr("not in the file", "axis");
        case State::NotConnected:
            return tr("not among the connections", "drive");
        case State::Waiting:
            return tr("is being compared …");
        case State::Unreachable:
            return tr("not reachable", "drive");
        case State::Problem:
            return tr("cannot be compared");
        case State::Differs:
            return translated(differenceText(*drift.plan));
        case State::AsFile:
            return tr("as the file says");
        }
        return {};
    }
    [[nodiscard]] static QString at(const QString& state, const QDateTime& looked)
    {
        return tr("%1 (compared at %2)", "state and time").arg(state, momentText(looked));
    }
    [[nodiscard]] static QString table(const QString& name, const Grid& grid, std::uint32_t crc)
    {
        return tableWithCrc(tr("%1: %2", "table and grid").arg(name, gridText(grid)), crc);
    }
    [[nodiscard]] static QString persistency(Persistency persistency)
    {
        return persistency == Persistency::Persistent ? tr("persistent", "table")
                                                      : tr("volatile", "table");
    }
    [[nodiscard]] static QString source(const DimSource& source, std::span<const AxisEntry> axes)
    {
        if (!source.isSet())
            return tr("not set", "source");
        return source.path.empty() ? QStringLiteral("0x%1").arg(source.address, 8, 16, QChar(u'0'))
                                   : registerName(source.path, axes);
    }
    [[nodiscard]] static QString activation(bool isOn)
    {
        return isOn ? tr("on", "compensation") : tr("off", "compensation");
    }
    [[nodiscard]] static DriftLine unfinished()
    {
        return {tr("Earlier write"), tr("did not end"), tr("is ended by the next write")};
    }
    [[nodiscard]] static DriftLine switched(const AxisPlan& plan)
    {
        return {tr("Compensation"), activation(plan.before.isOn()),
            activation(*plan.switches == Switch::Activate)};
    }
    [[nodiscard]] static QString dimensions(int count) { return tr("%1D").arg(count); }
    [[nodiscard]] static QString ofDrive(const MachineDriveState& drive)
    {
        return tr("%1 (serial number %2)", "address of a drive")
            .arg(drive.endpoint)
            .arg(drive.wanted.serialNumber);
    }
    [[nodiscard]] static QString ofAxis(const QString& drive, const std::string& axis)
    {
        return tr("%1, axis %2", "drive and axis").arg(drive, qString(shownText(axis)));
    }
    [[nodiscard]] static QString ofFile(const QString& file, const Diagnostic& problem)
    {
        return problem.line == 0 ? tr("%1: %2", "file and problem").arg(file, problemText(problem))
                                 : tr("%1, line %2: %3", "file, line and problem")
                                       .arg(file)
                                       .arg(problem.line)
                                       .arg(problemText(problem));
    }
    [[nodiscard]] static QString notNow(const Error& error)
    {
        return tr("This cannot be written now: %1").arg(errorText(error));
    }
};

DriftLine tableLine(const AxisPlan& plan, const MachineAxis& wanted)
{
    DriftLine line{{}, noTableText(), noTableText()};
    const CompensationSetup& before = plan.plan.before;
    if (plan.before.table)
        line.before = DriftText::table(
            QString::fromStdString(before.slot), plan.before.table->grid, plan.before.table->crc);
    if (plan.plan.table)
        line.after = DriftText::table(
            qString(shownText(wanted.file)), plan.plan.table->grid, plan.plan.after.tableCrc);
    return line;
}

/// Core says which fields differ; how they are shown is the window's.
DriftLine lineOf(const PlannedChange& change, const AxisPlan& plan, const MachineAxis& wanted,
    std::span<const AxisEntry> axes)
{
    const CompensationSetup& before = plan.plan.before;
    const CompensationSetup& after = plan.plan.after;
    DriftLine line{{}, qString(change.before), qString(change.after)};
    if (change.field == "Table")
        line = tableLine(plan, wanted);
    else if (change.field == "Dimensionality")
        line = {{}, DriftText::dimensions(before.dimensionality),
            DriftText::dimensions(after.dimensionality)};
    else if (change.field == "Persistency")
        line = {{}, plan.before.table ? DriftText::persistency(before.persistency) : noTableText(),
            DriftText::persistency(after.persistency)};
    else
        for (std::size_t n = 0; n < after.sources.size(); ++n)
            if (change.field == "Dim" + std::to_string(n + 1) + "Source")
                line = {{}, DriftText::source(before.sources[n], axes),
                    DriftText::source(after.sources[n], axes)};
    line.field = translated(fieldText(change.field));
    return line;
}

} // namespace

QString momentText(const QDateTime& time)
{
    return time.date() == QDate::currentDate()
        ? clockText(time)
        : localTimeText(WallTime(std::chrono::milliseconds(time.toMSecsSinceEpoch())));
}

QString driftText(const AxisDrift& drift)
{
    const QString state = DriftText::state(drift);
    const bool isLook = drift.state != AxisDrift::State::NotInFile
        && drift.state != AxisDrift::State::Waiting
        && drift.state != AxisDrift::State::NotConnected;
    return isLook && drift.looked.isValid()
        ? state + QStringLiteral(" · ") + momentText(drift.looked)
        : state;
}

QString driftToolTip(const AxisDrift& drift)
{
    const Error* problem = drift.plan && drift.plan->problem ? &*drift.plan->problem
        : drift.look && drift.look->problem                  ? &*drift.look->problem
                                                             : nullptr;
    const QString state = DriftText::state(drift);
    const QString at = drift.looked.isValid() ? DriftText::at(state, drift.looked) : state;
    return problem ? at + u'\n' + errorText(*problem) : at;
}

std::optional<Tone> driftTone(AxisDrift::State state)
{
    using State = AxisDrift::State;
    switch (state) {
    case State::Differs:
        return Tone::Warning;
    case State::Problem:
    case State::Unreachable:
    case State::NotConnected:
        return Tone::Error;
    case State::AsFile:
        return Tone::Success;
    case State::NotInFile:
    case State::Waiting:
        break;
    }
    return std::nullopt;
}

std::vector<DriftLine> driftLines(
    const AxisPlan& plan, const MachineAxis& wanted, std::span<const AxisEntry> axes)
{
    std::vector<DriftLine> lines;
    if (plan.problem)
        return lines;
    for (const PlannedChange& change : plan.plan.changes)
        lines.push_back(lineOf(change, plan, wanted, axes));
    if (plan.isUnfinished)
        lines.push_back(DriftText::unfinished());
    if (plan.switches)
        lines.push_back(DriftText::switched(plan));
    return lines;
}

QStringList driftWarnings(const AxisPlan& plan, const MachineTable* table)
{
    QStringList warnings;
    if (plan.problem)
        warnings += errorText(*plan.problem);
    if (plan.obstacle)
        warnings += DriftText::notNow(*plan.obstacle);
    const QString file =
        table ? QFileInfo(QString::fromStdString(table->file.string())).fileName() : QString();
    for (const auto* problems : {table ? &table->problems : nullptr, &plan.fileProblems})
        for (const Diagnostic& problem : problems ? *problems : std::vector<Diagnostic>())
            warnings += DriftText::ofFile(file, problem);
    if (plan.isWarned())
        for (const auto* texts : {&plan.plan.largeCorrections, &plan.plan.warnings})
            for (const Text& text : *texts)
                warnings += sentenceText(text);
    return warnings;
}

QStringList driftRemarks(const AxisPlan& plan)
{
    QStringList remarks;
    if (!plan.problem && !plan.plan.changes.empty())
        for (const Text& remark : plan.plan.unitRemarks)
            remarks += sentenceText(remark);
    return remarks;
}

QString machinePlaceText(const MachineDriveState& drive, std::optional<std::size_t> axis)
{
    const QString place = DriftText::ofDrive(drive);
    return axis ? DriftText::ofAxis(place, drive.wanted.axes.at(*axis).axis) : place;
}

} // namespace axiscomp::ui
