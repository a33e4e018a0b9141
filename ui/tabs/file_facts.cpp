// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/file_facts.h"

#include "ui/dialogs/file_filters.h"
#include "ui/record/measurement_files_model.h"
#include "ui/record/record_state.h"
#include "ui/text/message_text.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QHeaderView>

namespace axiscomp::ui {

namespace {

constexpr std::size_t mostNotes = 200;

QString degreesCelsius(std::optional<double> value)
{
    return value ? numberText(*value) + QStringLiteral(" °C") : QString();
}

QString compensationFact(const MeasuredState& state)
{
    switch (state.kind) {
    case MeasuredState::Kind::Off:
        return FileFacts::tr("off: the drive added nothing");
    case MeasuredState::Kind::On:
        return state.tableCrc
            ? FileFacts::tr("on, with table %1").arg(*state.tableCrc, 8, 16, QLatin1Char('0'))
            : FileFacts::tr("on");
    case MeasuredState::Kind::NotSaid:
        break;
    }
    return FileFacts::tr("the file does not say it");
}

QString correctedFact(MeasurementHeader::Corrected corrected)
{
    switch (corrected) {
    case MeasurementHeader::Corrected::None:
        return FileFacts::tr("no");
    case MeasurementHeader::Corrected::To20Celsius:
        return FileFacts::tr("yes");
    case MeasurementHeader::Corrected::NotSaid:
        break;
    }
    return FileFacts::tr("the file does not say it");
}

QString targetsFact(const Measurement& measurement)
{
    return FileFacts::tr("%1 from %2 to %3 %4")
        .arg(countText(measurement.targets.size()), numberText(measurement.targets.front()),
            numberText(measurement.targets.back()), qString(positionUnit(measurement)));
}

} // namespace

FileFacts::FileFacts(QWidget* parent) : QTableWidget(parent)
{
    setObjectName(QStringLiteral("fileFacts"));
    setColumnCount(2);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setTabKeyNavigation(false);
    setWordWrap(true);
    verticalHeader()->hide();
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
    retranslate();
}

void FileFacts::retranslate()
{
    setHorizontalHeaderLabels({tr("What"), tr("Statement of the file")});
    setAccessibleName(tr("What the file says"));
}

void FileFacts::add(const QString& name, const QString& statement)
{
    if (statement.isEmpty())
        return;
    const int row = rowCount();
    insertRow(row);
    setItem(row, 0, new QTableWidgetItem(name));
    setItem(row, 1, new QTableWidgetItem(statement));
    item(row, 1)->setToolTip(statement);
}

void FileFacts::show(const ReadMeasurement* reading)
{
    setRowCount(0);
    if (!reading || !reading->format)
        return;
    add(tr("Read as"), measurementFormatText(*reading->format));
    const Measurement* measurement = reading->measurement();
    if (!measurement)
        return;
    const MeasurementHeader& header = measurement->header;
    add(tr("Holds"), translated(measurementKindText(measurement->kind)));
    add(tr("Runs"), contentText(*reading));
    if (measurement->hasTargets())
        add(tr("Targets"), targetsFact(*measurement));
    add(tr("Compensation"), compensationFact(header.compensation));
    add(tr("Machine"), qString(header.machine));
    add(tr("Axis"), qString(header.axis));
    add(tr("Instrument"), qString(header.instrument));
    add(tr("Serial number"), qString(header.serial));
    add(tr("Operator"), qString(header.operatorName));
    add(tr("Date"), qString(header.date));
    add(tr("Feed"), qString(header.feed));
    add(tr("Dwell"), qString(header.dwell));
    add(tr("Drive"), qString(header.drive));
    add(tr("Air"), degreesCelsius(header.airTemperature));
    add(tr("Material"), degreesCelsius(header.materialTemperature));
    if (header.expansion)
        add(tr("Expansion"), numberText(*header.expansion) + QStringLiteral(" 1/K"));
    add(tr("Corrected to 20 °C"), correctedFact(header.corrected));
    for (const Text& asked : againstFileTexts(measurement->againstFile))
        add(tr("Note"), sentenceText(asked));
    for (std::size_t n = 0; n < std::min(mostNotes, measurement->notes.size()); ++n)
        add(tr("Note"), qString(measurement->notes[n]));
}

} // namespace axiscomp::ui
