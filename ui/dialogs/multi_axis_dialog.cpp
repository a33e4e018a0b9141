// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/multi_axis_dialog.h"

#include "ui/controller/column_mapping.h"
#include "ui/dialogs/column_mapping_table.h"
#include "ui/dialogs/multi_axis_plan_view.h"
#include "ui/style/plain_label.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>

namespace axiscomp::ui {

namespace {

enum SourcesEntry { KeepSources, PageSources };

} // namespace

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
    m_sources->setItemText(KeepSources, tr("Each axis keeps its sources"));
    m_sources->setToolTip(tr("The registers that supply the positions for the tables"));
    m_sources->setAccessibleDescription(m_sources->toolTip());
    if (m_sources->count() > PageSources)
        m_sources->setItemText(PageSources,
            tr("The same for all, as on the page: %1")
                .arg(sourceLines(controller().sourcesForSeveral(), axes())
                         .join(QStringLiteral(", "))));
    m_persistency->setText(controller().setup().edited().persistency == Persistency::Persistent
            ? tr("Persistent, as on the page: all tables are stored in flash.")
            : tr("Volatile, as on the page: a reboot of the drive restores the stored state."));
}

void MultiAxisDialog::fillSources()
{
    m_sources->addItem(QString());
    if (controller().sourcesForSeveral().empty())
        return;
    m_sources->addItem(QString());
    m_sources->setCurrentIndex(PageSources);
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
    return assignmentObstacle(m_columns->choices(), axes());
}

bool MultiAxisDialog::ask()
{
    return controller().planMultiAxis(chosen(), m_sources->currentIndex() == KeepSources);
}

void MultiAxisDialog::setChoosable(bool isChoosable)
{
    m_columns->setChoosable(isChoosable);
    m_sources->setEnabled(isChoosable);
}

} // namespace axiscomp::ui
