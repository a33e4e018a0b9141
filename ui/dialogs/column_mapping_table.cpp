// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/column_mapping_table.h"

#include "ui/async/background_job.h"
#include "ui/session/axis_list.h"
#include "ui/text/value_text.h"

#include <QComboBox>
#include <QHeaderView>

#include <algorithm>

namespace axiscomp::ui {

namespace {

enum MappingColumn { NameColumn, RangeColumn, MappedAxisColumn, MappingColumnCount };
constexpr int highest = 230; // pixels: more columns than fit are scrolled

struct ValueRange {
    float smallest = 0.0F;
    float largest = 0.0F;
};

std::vector<ValueRange> rangesOf(const CalibrationData& file)
{
    std::vector<ValueRange> ranges;
    for (const CompensationTable& table : file.tables) {
        const auto [smallest, largest] = std::ranges::minmax_element(table.values);
        ranges.push_back(table.values.empty() ? ValueRange{} : ValueRange{*smallest, *largest});
    }
    return ranges;
}

} // namespace

ColumnMappingTable::ColumnMappingTable(
    std::shared_ptr<const CalibrationData> file, std::vector<AxisEntry> axes, QWidget* parent)
    : QTableWidget(parent)
    , m_file(std::move(file))
    , m_axes(std::move(axes))
{
    setObjectName(QStringLiteral("columnAxes"));
    build();
    const std::vector<AxisChoice> proposal = proposedAxes(m_file->tables, infosOf(m_axes));
    for (std::size_t row = 0; row < proposal.size(); ++row)
        addRow(static_cast<int>(row), proposal[row]);
    askForRanges();
    retranslate();
}

void ColumnMappingTable::build()
{
    setColumnCount(MappingColumnCount);
    setRowCount(static_cast<int>(m_file->tables.size()));
    verticalHeader()->hide();
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    setFocusPolicy(Qt::NoFocus); // its combo boxes have it
    setTabKeyNavigation(false);
    setShowGrid(false);
    setAlternatingRowColors(true);
    setSizeAdjustPolicy(QAbstractItemView::AdjustToContents);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    setMaximumHeight(highest);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

void ColumnMappingTable::addRow(int row, const AxisChoice& proposal)
{
    setItem(row, NameColumn, new QTableWidgetItem);
    setItem(row, RangeColumn, new QTableWidgetItem(QStringLiteral("…")));
    auto* combo = new QComboBox;
    combo->setObjectName(QStringLiteral("axisOfColumn%1").arg(row + 1));
    combo->addItem(QString());
    for (const AxisEntry& entry : m_axes)
        combo->addItem(axisNameOnDrive(entry), entry.axis.index);
    combo->setCurrentIndex(proposal ? combo->findData(*proposal) : 0);
    connect(combo, &QComboBox::currentIndexChanged, this, &ColumnMappingTable::choiceChanged);
    setCellWidget(row, MappedAxisColumn, combo);
    m_combos.push_back(combo);
}

void ColumnMappingTable::askForRanges()
{
    const auto ranges =
        inBackground<std::vector<ValueRange>>([file = m_file] { return rangesOf(*file); });
    whenDone(ranges, this, [this](const std::vector<ValueRange>& found) {
        for (std::size_t n = 0; n < found.size(); ++n) {
            item(static_cast<int>(n), RangeColumn)
                ->setText(QStringLiteral("%1 … %2%3")
                              .arg(signedNumberText(static_cast<double>(found[n].smallest)),
                                  signedNumberText(static_cast<double>(found[n].largest)),
                                  unitSuffix(m_file->tables[n].unit)));
        }
    });
}

QString ColumnMappingTable::columnName(int row) const
{
    const std::string& name = m_file->tables[static_cast<std::size_t>(row)].name;
    return name.empty() ? tr("column %1").arg(row + 1) : QString::fromStdString(name);
}

std::vector<AxisChoice> ColumnMappingTable::choices() const
{
    std::vector<AxisChoice> chosen;
    for (const QComboBox* combo : m_combos) {
        const QVariant axis = combo->currentData();
        chosen.push_back(axis.isValid() ? AxisChoice(axis.toInt()) : AxisChoice());
    }
    return chosen;
}

void ColumnMappingTable::setChoosable(bool isChoosable)
{
    for (QComboBox* combo : m_combos)
        combo->setEnabled(isChoosable);
}

void ColumnMappingTable::retranslate()
{
    setHorizontalHeaderLabels({tr("Column of the file"), tr("Values"), tr("Axis")});
    setAccessibleName(tr("Which column is for which axis"));
    for (int row = 0; row < rowCount(); ++row) {
        const QString name = columnName(row);
        item(row, NameColumn)->setText(name);
        QComboBox* combo = m_combos[static_cast<std::size_t>(row)];
        combo->setItemText(0, tr("none", "axis"));
        combo->setAccessibleName(tr("Axis for %1").arg(name));
        combo->setToolTip(tr("The axis for column %1").arg(name));
        combo->setAccessibleDescription(combo->toolTip());
    }
}

} // namespace axiscomp::ui
