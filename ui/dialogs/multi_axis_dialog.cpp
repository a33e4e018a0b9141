// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/multi_axis_dialog.h"

#include "ui/data/column_mapping.h"
#include "ui/dialogs/column_mapping_table.h"
#include "ui/dialogs/multi_axis_plan_view.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>

namespace axiscomp::ui {

MultiAxisDialog::MultiAxisDialog(WizardController& controller, QWidget* parent)
    : SeveralWritesDialog(controller, Action::WriteSeveral, parent)
    , m_columns(new ColumnMappingTable(controller.dataFile().data, axes()))
    , m_sourcesLabel(new PlainLabel)
    , m_sources(new QComboBox)
    , m_persistency(wrappedLabel("multiAxisPersistency"))
{
    setObjectName(QStringLiteral("multiAxisDialog"));
    build();
    fillSources();
    connect(m_columns, &ColumnMappingTable::choiceChanged, this, &MultiAxisDialog::plan);
    connect(m_sources, &QComboBox::activated, this, &MultiAxisDialog::plan);
    begin();
}

void MultiAxisDialog::build()
{
    m_sources->setObjectName(QStringLiteral("multiAxisSources"));
    m_sources->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_sourcesLabel->setBuddy(m_sources);
    auto* sources = new QHBoxLayout;
    sources->addWidget(m_sourcesLabel);
    sources->addWidget(m_sources, 1);
    choices().addWidget(m_columns);
    choices().addLayout(sources);
    choices().addWidget(m_persistency);
}

void MultiAxisDialog::retranslateChoices()
{
    setWindowTitle(tr("Write Several Axes"));
    introduction().setText(
        tr("Writes columns of %1 to axes of %2, one after the other. All writes are checked before "
           "the first one begins; each one makes a backup and is verified.")
            .arg(QFileInfo(controller().dataFile().path).fileName(), driveName()));
    m_columns->retranslate();
    m_sourcesLabel->setText(tr("&Sources"));
    m_sources->setToolTip(tr("The registers that supply the positions for the tables"));
    m_sources->setAccessibleDescription(m_sources->toolTip());
    for (int entry = 0; entry < m_sources->count(); ++entry)
        m_sources->setItemText(
            entry, sourcesText(m_sources->itemData(entry).value<SourcesForSeveral>()));
    m_persistency->setText(controller().setup().edited().persistency == Persistency::Persistent
            ? tr("Persistent, as on the page: all tables are stored in flash.")
            : tr("Volatile, as on the page: a reboot of the drive restores the stored state."));
}

QString MultiAxisDialog::sourcesText(SourcesForSeveral sources) const
{
    if (sources == SourcesForSeveral::Kept)
        return tr("Each axis keeps its sources");
    if (sources == SourcesForSeveral::OwnPosition)
        return tr("Each axis its own position");
    return tr("The same for all, as on the page: %1")
        .arg(listText(sourceLines(controller().sourcesForSeveral(), axes())));
}

void MultiAxisDialog::fillSources()
{
    const auto add = [this](SourcesForSeveral sources) {
        m_sources->addItem(QString(), QVariant::fromValue(sources));
    };
    add(SourcesForSeveral::Kept);
    if (controller().dataFile().data->grid.dimensions() == 1)
        add(SourcesForSeveral::OwnPosition);
    if (controller().sourcesForSeveral().empty())
        return;
    add(SourcesForSeveral::OfPage);
    m_sources->setCurrentIndex(m_sources->count() - 1);
}

SourcesForSeveral MultiAxisDialog::sources() const
{
    return m_sources->currentData().value<SourcesForSeveral>();
}

std::vector<ColumnForAxis> MultiAxisDialog::chosen() const
{
    std::vector<ColumnForAxis> columns;
    const std::vector<AxisChoice> choices = m_columns->choices();
    for (std::size_t n = 0; n < choices.size(); ++n) {
        if (choices[n])
            columns.push_back({static_cast<int>(n), *choices[n]});
    }
    return columns;
}

QString MultiAxisDialog::obstacle() const
{
    if (QString found = assignmentObstacle(m_columns->choices(), axes()); !found.isEmpty())
        return found;
    for (const ColumnForAxis& column : chosen())
        if (sources() == SourcesForSeveral::OwnPosition
            && !controller().ownPosition(column.axis).isSet())
            return tr("No register is known for the position of %1: select other sources.")
                .arg(axisNameAmong(axes(), column.axis));
    return {};
}

bool MultiAxisDialog::ask()
{
    return controller().planMultiAxis(chosen(), sources());
}

void MultiAxisDialog::setChoosable(bool isChoosable)
{
    m_columns->setChoosable(isChoosable);
    m_sources->setEnabled(isChoosable);
}

} // namespace axiscomp::ui
