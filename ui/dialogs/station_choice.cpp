// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/station_choice.h"

#include "core/configuration/compensation_parameters.h"
#include "ui/async/background_job.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>

namespace axiscomp::ui {

StationChoice::StationChoice(
    const QString& path, Direction direction, AxisEntry drive, QWidget* parent)
    : QWidget(parent)
    , m_direction(direction)
    , m_drive(std::move(drive))
    , m_label(new PlainLabel)
    , m_stations(new QComboBox)
    , m_warning(new ToneLabel)
    , m_accept(new QCheckBox)
{
    setObjectName(QStringLiteral("stationChoice"));
    build();
    connect(m_stations, &QComboBox::activated, this, &StationChoice::choose);
    connect(m_accept, &QCheckBox::toggled, this, &StationChoice::changed);
    const QFileInfo file(path);
    whenDone(inBackground<Loaded>([name = file.fileName().toStdString(),
                                      place = file.filesystemAbsoluteFilePath()]() -> Loaded {
        AXISCOMP_TRY(auto configuration, loadTamConfiguration(place, name));
        return std::make_shared<const TamConfiguration>(std::move(configuration));
    }),
        this, [this](const Loaded& configuration) { take(configuration); });
    retranslate();
}

void StationChoice::build()
{
    m_stations->setObjectName(QStringLiteral("stationField"));
    m_label->setBuddy(m_stations);
    m_warning->setObjectName(QStringLiteral("stationWarning"));
    m_warning->setWordWrap(true);
    m_warning->setTone(Tone::Warning);
    m_accept->setObjectName(QStringLiteral("acceptOtherStation"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_label);
    row->addWidget(m_stations, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(row);
    layout->addWidget(m_warning);
    layout->addWidget(m_accept);
}

void StationChoice::take(const Loaded& configuration)
{
    m_configuration = configuration;
    if (configuration) {
        const auto& stations = (*configuration)->stations;
        for (const TamStation& station : stations)
            m_stations->addItem(qString(stationName(station)));
        const auto proposed =
            stationFor(stations, (*configuration)->fileName, m_drive.serialNumber, {}, false);
        m_stations->setCurrentIndex(proposed ? static_cast<int>(*proposed) : -1);
    }
    showState();
    Q_EMIT changed();
}

/// What was confirmed of another station is not confirmed of this one.
void StationChoice::choose()
{
    const QSignalBlocker once(m_accept);
    m_accept->setChecked(false);
    showState();
    Q_EMIT changed();
}

std::size_t StationChoice::station() const
{
    return static_cast<std::size_t>(m_stations->currentIndex());
}

bool StationChoice::isOther() const
{
    return m_stations->currentIndex() >= 0
        && !checkStationOfDrive(configuration()->stations.at(station()), m_drive.serialNumber);
}

bool StationChoice::acceptsOther() const
{
    return isOther() && m_accept->isChecked();
}

QString StationChoice::obstacle() const
{
    if (!m_configuration)
        return tr("The file is being read.");
    if (!*m_configuration)
        return errorText(m_configuration->error());
    if (m_stations->count() == 0)
        return tr("The file has no station.");
    if (m_stations->currentIndex() < 0)
        return tr("Select the station that is this drive.");
    if (isOther() && !m_accept->isChecked())
        return tr("Confirm first that the station is meant.");
    return {};
}

QString StationChoice::warning() const
{
    if (!isOther())
        return {};
    const TamStation& station = configuration()->stations.at(this->station());
    return tr("%1 has the serial number %2, the drive %3 has %4.")
        .arg(qString(station.name.empty() ? "?" : station.name),
            QString::number(*station.serialNumber), m_drive.driveName,
            QString::number(m_drive.serialNumber));
}

void StationChoice::setChoosable(bool isChoosable)
{
    m_isChoosable = isChoosable;
    showState();
}

void StationChoice::showState()
{
    const bool isOffering = m_isChoosable && m_stations->count() > 0;
    m_stations->setEnabled(isOffering);
    m_accept->setEnabled(isOffering);
    m_warning->setText(warning());
    m_warning->setVisible(isOther());
    m_accept->setVisible(isOther());
}

void StationChoice::retranslate()
{
    m_label->setText(tr("Stat&ion"));
    m_stations->setPlaceholderText(tr("not selected"));
    m_stations->setToolTip(tr("The drive in the configuration whose parameters are meant"));
    m_stations->setAccessibleDescription(m_stations->toolTip());
    m_accept->setText(m_direction == Direction::ToDrive
            ? tr("These &parameters are for this drive although the serial numbers differ")
            : tr("The &parameters of this drive are for this station although the serial numbers "
                 "differ"));
    m_accept->setToolTip(tr("The wrong drive would get the compensation of another machine"));
    m_accept->setAccessibleDescription(m_accept->toolTip());
    showState();
}

} // namespace axiscomp::ui
