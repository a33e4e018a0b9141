// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/measurement_files_model.h"

#include "core/text/crc_text.h"
#include "ui/record/record_model.h"
#include "ui/style/contrast.h"
#include "ui/style/symbols.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QFileInfo>

#include <algorithm>

namespace axiscomp::ui {

namespace {

QString stateOfCompensation(const MeasuredState& state)
{
    switch (state.kind) {
    case MeasuredState::Kind::Off:
        return MeasurementFilesModel::tr("off", "compensation");
    case MeasuredState::Kind::On:
        return state.tableCrc ? qString(crcText(*state.tableCrc))
                              : MeasurementFilesModel::tr("on", "compensation");
    case MeasuredState::Kind::NotSaid:
        break;
    }
    return MeasurementFilesModel::tr("not said");
}

std::size_t warningsOf(const ReadMeasurement& reading)
{
    return reading.reading ? reading.reading->diagnostics.size() : 0;
}

Tone toneOf(const ReadMeasurement& reading)
{
    if (reading.refusal)
        return Tone::Error;
    return warningsOf(reading) > 0 ? Tone::Warning : Tone::Success;
}

QString stateOfFile(const ReadMeasurement& reading)
{
    if (reading.refusal)
        return MeasurementFilesModel::tr("cannot be used");
    const std::size_t warnings = warningsOf(reading);
    return warnings > 0 ? MeasurementFilesModel::tr("warnings: %1").arg(countText(warnings))
                        : MeasurementFilesModel::tr("ready");
}

} // namespace

QString contentText(const ReadMeasurement& reading)
{
    const Measurement* measurement = reading.measurement();
    if (!measurement)
        return {};
    switch (measurement->kind) {
    case MeasurementKind::Track:
        return MeasurementFilesModel::tr("samples: %1").arg(countText(measurement->track.size()));
    case MeasurementKind::Points:
        return MeasurementFilesModel::tr("points: %1").arg(countText(measurement->points.size()));
    case MeasurementKind::Averages:
        return MeasurementFilesModel::tr("means");
    case MeasurementKind::Runs:
        break;
    }
    return MeasurementFilesModel::tr("%1 up, %2 down").arg(reading.upRuns).arg(reading.downRuns);
}

MeasurementFilesModel::MeasurementFilesModel(const RecordModel& record, QObject* parent)
    : QAbstractTableModel(parent)
    , m_record(record)
{
    connect(&record, &RecordModel::changed, this, &MeasurementFilesModel::follow);
    connect(&record, &RecordModel::stateChanged, this, &MeasurementFilesModel::follow);
    follow();
}

void MeasurementFilesModel::follow()
{
    QStringList paths;
    for (const MeasurementFile& file : m_record.record().files)
        paths += file.path;
    if (paths == m_paths) {
        if (!paths.isEmpty())
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        return;
    }
    beginResetModel();
    m_paths = paths;
    endResetModel();
}

void MeasurementFilesModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    follow();
}

const ReadMeasurement* MeasurementFilesModel::readingOf(int row) const
{
    const MeasurementFile& file = m_record.record().files.at(static_cast<std::size_t>(row));
    const auto& readings = m_record.state().files;
    const auto found = std::ranges::find(readings, file, &ReadMeasurement::file);
    return found == readings.end() ? nullptr : &*found;
}

QString MeasurementFilesModel::text(int row, int column) const
{
    if (column == File)
        return QFileInfo(m_paths.at(row)).fileName();
    const ReadMeasurement* reading = readingOf(row);
    if (!reading)
        return column == State ? tr("being read …") : QString();
    if (column == State)
        return stateOfFile(*reading);
    if (!reading->measurement())
        return {};
    return column == Content ? contentText(*reading)
                             : stateOfCompensation(reading->measurement()->header.compensation);
}

int MeasurementFilesModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_paths.size());
}

int MeasurementFilesModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant MeasurementFilesModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::DisplayRole)
        return text(index.row(), index.column());
    const ReadMeasurement* reading = readingOf(index.row());
    if (role == Qt::ToolTipRole) {
        if (index.column() == File)
            return m_record.record().files.at(static_cast<std::size_t>(index.row())).recorded
                ? tr("%1, as the record holds it").arg(m_paths.at(index.row()))
                : m_paths.at(index.row());
        return reading && reading->refusal ? errorText(*reading->refusal)
                                           : text(index.row(), index.column());
    }
    if (role == Qt::DecorationRole && index.column() == State && reading)
        return cellIcon(toneOf(*reading));
    return {};
}

QVariant MeasurementFilesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case File:
        return tr("File");
    case Content:
        return tr("Content");
    case Compensation:
        return tr("Compensation");
    case State:
        return tr("State");
    default:
        return {};
    }
}

} // namespace axiscomp::ui
