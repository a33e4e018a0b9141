// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/import_configuration_dialog.h"

#include "ui/dialogs/station_choice.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QLabel>

namespace axiscomp::ui {

ImportConfigurationDialog::ImportConfigurationDialog(
    WizardController& controller, QString path, QWidget* parent)
    : SeveralWritesDialog(controller, Action::ImportConfiguration, parent)
    , m_path(std::move(path))
    , m_station(new StationChoice(m_path, StationChoice::Direction::ToDrive, axes().front()))
{
    setObjectName(QStringLiteral("importConfigurationDialog"));
    choices().addWidget(m_station);
    connect(m_station, &StationChoice::changed, this, &ImportConfigurationDialog::plan);
    begin();
}

QString ImportConfigurationDialog::obstacle() const
{
    return m_station->obstacle();
}

bool ImportConfigurationDialog::isObstacleAnError() const
{
    return m_station->hasFailed();
}

bool ImportConfigurationDialog::isWaiting() const
{
    return m_station->isReading();
}

bool ImportConfigurationDialog::ask()
{
    return controller().planImport(
        m_station->configuration(), m_station->station(), m_station->acceptsOther());
}

void ImportConfigurationDialog::setChoosable(bool isChoosable)
{
    m_station->setChoosable(isChoosable);
}

void ImportConfigurationDialog::retranslateChoices()
{
    setWindowTitle(tr("Import TAM Configuration"));
    introduction().setText(
        tr("Writes the table and source parameters in %1 to the axes of %2, one after the other. "
           "The tables themselves must be on the drive. Each write makes a backup and is verified; "
           "no compensation is switched on.")
            .arg(QFileInfo(m_path).fileName(), driveName()));
    m_station->retranslate();
}

} // namespace axiscomp::ui
