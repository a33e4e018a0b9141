// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/tam_table.h"
#include "ui/controller/wizard_controller_p.h"
#include "ui/text/message_text.h"
#include "ui/text/sign_sentence.h"

#include <algorithm>
#include <utility>

namespace axiscomp::ui {

namespace {

/// Where the table is in the file that was read again: by its name, else by its place.
int placeOf(const CalibrationData& before, int index, const CalibrationData& now)
{
    const auto& name = before.tables[static_cast<std::size_t>(index)].name;
    const auto found = std::ranges::find(now.tables, name, &CompensationTable::name);
    if (found != now.tables.end())
        return static_cast<int>(found - now.tables.begin());
    return std::min(index, static_cast<int>(now.tables.size()) - 1);
}

} // namespace

void WizardController::Private::fileReplaced(
    const std::shared_ptr<const CalibrationData>& before, bool isSameFile)
{
    const auto& now = file.file().data;
    const std::optional<int> chosen = setup.edited().table.fileTable;
    const bool isOpened = std::exchange(isOpening, false);
    if (!now)
        setup.setTable({});
    else if (!isSameFile || !before || (isOpened && !chosen))
        setup.setTable({0});
    else if (chosen && *chosen < static_cast<int>(before->tables.size()))
        setup.setTable({placeOf(*before, *chosen, *now)});
    if (now)
        log(LogLine::Kind::Information,
            [path = file.file().path, points = now->grid.pointCount(),
                tables = now->tables.size()] {
                return tr("%1 has been read: %2 points, tables: %3.")
                    .arg(path)
                    .arg(points)
                    .arg(tables);
            });
    for (const Text& line : file.file().report)
        log(LogLine::Kind::Information, [line] { return sentenceText(line); });
    noteSelectedTable();
}

void WizardController::Private::fileFailed(const LoadedFile& failed)
{
    isOpening = false;
    const auto problems =
        std::ranges::count(failed.problems, Severity::Error, &Diagnostic::severity);
    log(LogLine::Kind::Error,
        [path = failed.path,
            count = static_cast<qulonglong>(problems) + failed.suppressedProblems] {
            return tr("%1 cannot be used: %2 problems.").arg(path).arg(count);
        });
}

LoadedTable WizardController::Private::selectedTable() const
{
    const std::optional<int> chosen = setup.edited().table.fileTable;
    return chosen ? file.table(*chosen) : driveTable.table();
}

std::size_t WizardController::Private::selectedTableBytes() const
{
    const auto table = selectedTable().table;
    return table ? tamTableSize(table->grid, profile.layout) : 0;
}

void WizardController::Private::noteSelectedTable()
{
    auto now = selectedTable().table;
    if (now == shownTable)
        return;
    shownTable = std::move(now);
    Q_EMIT q.selectedTableChanged();
}

void WizardController::Private::fieldChanged(Field field)
{
    if (task != Task::Write)
        plan.reset();
    if (field == Field::Dimensionality && !isLeaving)
        file.setDimensions(setup.edited().dimensionality);
    if (field == Field::Table)
        noteSelectedTable();
    update();
}

QString WizardController::signSentence() const
{
    const AxisInfo axis = d->status ? d->status->axis : AxisInfo{};
    return signSentenceFor(d->selectedTable(), axis, d->setup.edited().sources);
}

} // namespace axiscomp::ui
