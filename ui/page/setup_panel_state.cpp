// SPDX-License-Identifier: GPL-3.0-or-later
// What the fields say: the part of SetupPanel that follows the controller.
#include "ui/page/setup_panel.h"

#include "core/drive/drive_profile.h"
#include "ui/controller/wizard_controller.h"
#include "ui/fields/data_file_field.h"
#include "ui/fields/field_binder.h"
#include "ui/fields/field_row.h"
#include "ui/fields/source_combo.h"
#include "ui/session/axis_list.h"
#include "ui/text/value_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include <algorithm>

namespace axiscomp::ui {

namespace {

std::vector<AxisEntry> axesOfDrive(const WizardController& controller)
{
    std::vector<AxisEntry> axes;
    const int current = controller.currentAxis();
    if (current < 0)
        return axes;
    const QString& endpoint = controller.axes().at(static_cast<std::size_t>(current)).endpoint;
    std::ranges::copy_if(controller.axes(), std::back_inserter(axes),
        [&](const AxisEntry& entry) { return entry.endpoint == endpoint; });
    return axes;
}

QString addressText(std::uint32_t address)
{
    return QStringLiteral("0x%1").arg(address, 8, 16, QChar(u'0'));
}

std::size_t errorCount(const DataFile& file)
{
    const auto errors = std::ranges::count(file.problems, Severity::Error, &Diagnostic::severity);
    return static_cast<std::size_t>(errors) + file.suppressedProblems;
}

} // namespace

void SetupPanel::setTexts()
{
    m_axisRow->setTexts({tr("A&xis"), tr("The axis to compensate; lists all axes of all drives"),
        tr("The axis to compensate")});
    m_dimensionalityRow->setTexts({tr("Dimen&sionality"),
        tr("The number of positions that the compensation depends on: 1D one, 2D two, 3D three"),
        tr("The number of positions that the compensation depends on")});
    const std::array labels{tr("Dim&1 Source"), tr("Dim&2 Source"), tr("Dim&3 Source")};
    for (std::size_t n = 0; n < labels.size(); ++n) {
        m_sourceRows[n]->setTexts({labels[n],
            tr("The register that supplies the position for dimension %1: select one, or type a "
               "path, a tam:// URI or a hexadecimal address and press Enter")
                .arg(n + 1),
            tr("The register that supplies the position for dimension %1").arg(n + 1)});
    }
    m_dataRow->setTexts({tr("Compensat&ion data"),
        tr("A file of positions and compensation values; needed only for a new table"),
        tr("A file of compensation values; needed only for a new table")});
    m_tableRow->setTexts(
        {tr("Ta&ble"), tr("The table for the axis: the one on the drive, or one from the file"),
            tr("The table for the axis")});
    m_persistencyRow->setTexts({tr("Persistency"),
        tr("Persistent: stored in the drive's flash and kept over a reboot. Volatile: lost on a "
           "reboot. Applies to the table on the drive as well"),
        tr("Whether the table survives a reboot")});
    m_persistency->setText(tr("Make &persistent"));
    for (int index = 0; index < m_dimensionality->count(); ++index)
        m_dimensionality->setItemText(index, tr("%1D").arg(index + 1));
}

void SetupPanel::showAxes()
{
    const QSignalBlocker blocker(m_axis);
    const auto& axes = m_controller.axes();
    m_axis->clear();
    auto* items = qobject_cast<QStandardItemModel*>(m_axis->model());
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const AxisEntry& entry = axes[i];
        m_axis->addItem(entry.label, static_cast<int>(i));
        const int row = static_cast<int>(i);
        if (!entry.isUsable && items) {
            items->item(row)->setEnabled(false);
            items->item(row)->setToolTip(entry.problem);
        }
    }
    m_axis->setCurrentIndex(m_controller.currentAxis());
    m_axis->setPlaceholderText(tr("no axis"));
    showAxisState();
    showAvailability();
    showTables();
    m_binder->refresh();
}

void SetupPanel::showAxisState()
{
    const auto& status = m_controller.status();
    if (!status) {
        m_axisRow->setInformation({});
        return;
    }
    const QString homing = status->axis.isHomed ? tr("homed") : tr("not homed");
    const QString unit = unitSymbol(status->axis.unit);
    const QString serial = tr("serial number %1").arg(status->drive.serialNumber);
    m_axisRow->setInformation(unit.isEmpty()
            ? tr("%1, %2", "homed, serial number").arg(homing, serial)
            : tr("%1, positions in %2, %3").arg(homing, unit, serial));
}

void SetupPanel::showSources()
{
    const std::vector<AxisEntry> axes = axesOfDrive(m_controller);
    const auto& status = m_controller.status();
    std::vector<SourceChoice> choices;
    for (const DimSource& source : m_controller.sourceShortlist()) {
        if (status)
            choices.push_back({QString::fromStdString(sourceUri(status->drive.name, source.path)),
                registerName(source.path, axes)});
    }
    for (int dimension = 1; dimension <= 3; ++dimension) {
        m_sources[static_cast<std::size_t>(dimension - 1)]->setChoices(choices);
        showSource(dimension);
    }
    showDimensions();
}

void SetupPanel::showSource(int dimension)
{
    const auto index = static_cast<std::size_t>(dimension - 1);
    const bool isBeingChecked = m_controller.isSourceBeingChecked(dimension);
    const QString problem = m_controller.sourceProblem(dimension);
    m_sourceRows[index]->setBusy(isBeingChecked);
    m_sourceRows[index]->setProblem(problem);
    if (!isBeingChecked && !problem.isEmpty())
        m_sources[index]->refuse();
    else if (!isBeingChecked)
        m_binder->refresh(sourceField(dimension));
    showSourceAdvice();
    showSourceValues();
}

/// What the open file proposes for the sources, and what it speaks against.
void SetupPanel::showSourceAdvice()
{
    for (int dimension = 1; dimension <= 3; ++dimension) {
        FieldRow* row = m_sourceRows[static_cast<std::size_t>(dimension - 1)];
        const DimSource proposed = m_controller.proposedSource(dimension);
        row->setProposal(proposed.isSet() ? sourceName(proposed) : QString());
        row->setWarning(m_controller.sourceDoubt(dimension));
    }
}

void SetupPanel::showSourceValues()
{
    const SetupModel& setup = m_controller.setup();
    const bool isLive = m_controller.isConnected();
    for (std::size_t n = 0; n < m_sources.size(); ++n) {
        const DimSource& source = setup.edited().sources[n];
        const auto value = m_controller.sourceValue(static_cast<int>(n) + 1);
        m_sourceRows[n]->setInformation(
            source.isSet() ? QString() : tr("select or type a register"));
        m_sourceRows[n]->setCurrent(
            value && source.isSet() ? tr("now %1", "value").arg(numberText(*value)) : QString(),
            isLive);
        m_sourceRows[n]->setWholeValue(source.isSet() ? sourceUriText(source) : QString());
    }
}

void SetupPanel::showDimensions()
{
    const int dimensions = m_controller.setup().edited().dimensionality;
    for (int n = 0; n < 3; ++n)
        m_sourceRows[static_cast<std::size_t>(n)]->setVisible(n < dimensions);
    const std::array texts{
        tr("one source, one column of positions"),
        tr("two sources, two columns of positions"),
        tr("three sources, three columns of positions"),
    };
    m_dimensionalityRow->setInformation(
        texts.at(static_cast<std::size_t>(std::clamp(dimensions, 1, 3) - 1)));
}

void SetupPanel::showTables()
{
    const QSignalBlocker blocker(m_table);
    m_table->clear();
    const SetupModel& setup = m_controller.setup();
    const auto& status = m_controller.status();
    const bool hasTable = status && status->table;
    m_table->addItem(hasTable ? tr("On the drive: %1").arg(driveTableText(setup.baseline()))
                              : tr("none on the drive"),
        tableOnDrive);
    const DataFile& file = m_controller.dataFile();
    if (file.data) {
        for (std::size_t i = 0; i < file.data->tables.size(); ++i)
            m_table->addItem((file.isMade ? tr("Fitted: %1") : tr("Parsed: %1"))
                                 .arg(QString::fromStdString(file.data->tables[i].name)),
                static_cast<int>(i));
    }
    m_binder->refresh(Field::Table);
    showTableState();
    showPersistency();
}

void SetupPanel::showTableState()
{
    const DataFile& file = m_controller.dataFile();
    const auto& status = m_controller.status();
    const bool hasTable = status && status->table;
    if (m_controller.setup().edited().table.fileTable)
        m_tableRow->setInformation(
            (m_controller.setup().isDirty(Field::Table) ? tr("from %1")
                                                        : tr("from %1; the drive has it already"))
                .arg(QFileInfo(file.path).fileName()));
    else
        m_tableRow->setInformation(
            hasTable ? gridText(status->table->grid) : tr("open a file to get a table"));
}

void SetupPanel::showData()
{
    const DataFile& file = m_controller.dataFile();
    if (file.isReading)
        m_data->showReading(file.progress);
    else
        m_data->showFile(file.path, file.isMade);
    const std::size_t errors = file.isReading ? 0 : errorCount(file);
    // The field names the file that stays in use.
    m_dataRow->setProblem(errors == 0
            ? QString()
            : tr("%1 is not used, problems: %2")
                  .arg(QFileInfo(file.problemsPath).fileName(), countText(errors)));
    QString information = tr("CSV; needed only for a new table");
    if (file.isReading)
        information = tr("reading %1").arg(QFileInfo(file.readingPath).fileName());
    else if (file.data)
        information =
            tr("tables: %1, points: %2")
                .arg(countText(file.data->tables.size()), countText(file.data->grid.pointCount()));
    if (!file.isReading && file.data && !file.report.empty())
        information += tr("; read as %1, converted")
                           .arg(QString::fromUtf8(file.format->facts.name.data(),
                               static_cast<qsizetype>(file.format->facts.name.size())));
    m_dataRow->setInformation(information);
    showTables();
}

void SetupPanel::showPersistency()
{
    const bool isPersistent = m_controller.setup().edited().persistency == Persistency::Persistent;
    QString text = isPersistent ? tr("in flash") : tr("lost on a reboot");
    const int limit = m_profile.flashWear.operations;
    if (isPersistent && limit > 0)
        text += tr("; %1 of %2 flash operations available now", "of the flash")
                    .arg(m_controller.flashOperationsLeft())
                    .arg(limit);
    if (const auto& use = m_controller.flashUse(); isPersistent && use && use->ratedCycles > 0)
        text += tr("; %1 of typically %2 flash cycles used", "of the flash")
                    .arg(countText(std::max<std::uint64_t>(use->mostCycles,
                             use->mostUsedSlot.empty() ? use->operationsRecorded : 0)),
                        countText(use->ratedCycles));
    m_persistencyRow->setInformation(text);
}

void SetupPanel::showAvailability()
{
    const bool hasAxis = m_controller.setup().hasBaseline();
    const bool isWriting = m_controller.isWriting();
    m_axisRow->setEnabled(!m_controller.axes().empty() && !isWriting);
    for (FieldRow* row : {m_dimensionalityRow, m_sourceRows[0], m_sourceRows[1], m_sourceRows[2],
             m_tableRow, m_persistencyRow})
        row->setEnabled(hasAxis && !isWriting);
    const ActionState open = m_controller.action(Action::OpenData);
    m_data->setOpenEnabled(open.isEnabled, open.reason);
    showPersistency();
}

QString SetupPanel::sourceUriText(const DimSource& source) const
{
    const auto& status = m_controller.status();
    if (!source.isSet())
        return {};
    if (source.path.empty() || !status)
        return addressText(source.address);
    return QString::fromStdString(sourceUri(status->drive.name, source.path));
}

QString SetupPanel::sourceName(const DimSource& source) const
{
    if (!source.isSet())
        return tr("not set", "source");
    if (source.path.empty())
        return tr("unknown register %1").arg(addressText(source.address));
    return registerName(source.path, axesOfDrive(m_controller));
}

QString SetupPanel::driveTableText(const CompensationSetup& baseline) const
{
    if (baseline.slot.empty())
        return tr("none", "table");
    const auto& status = m_controller.status();
    const QString slot = QString::fromStdString(baseline.slot);
    return status && status->table
        ? tr("%1, %2 points").arg(slot, countText(status->table->elements))
        : tr("%1, empty", "table slot").arg(slot);
}

} // namespace axiscomp::ui
