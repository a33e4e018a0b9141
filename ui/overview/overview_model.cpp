// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overview/overview_model.h"

#include "core/metrology/record/kept_figures.h"
#include "ui/controller/axis_overview.h"
#include "ui/controller/machine_controller.h"
#include "ui/overview/drift_text.h"
#include "ui/text/message_text.h"
#include "ui/text/state_text.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <array>
#include <limits>

namespace axiscomp::ui {

namespace {

QDateTime localTime(WallTime time)
{
    using std::chrono::milliseconds;
    return QDateTime::fromMSecsSinceEpoch(
        std::chrono::duration_cast<milliseconds>(time.time_since_epoch()).count());
}

/// The hour is enough on the same day.
QString sinceWhen(WallTime time)
{
    const QDateTime local = localTime(time);
    return local.date() == QDate::currentDate()
        ? sinceText(local)
        : OverviewModel::tr("since %1", "date and time").arg(localTimeText(time));
}

QString tableText(const OverviewRow& row)
{
    if (!row.status)
        return {};
    if (!row.status->table)
        return noTableText();
    const QString slot = QString::fromStdString(row.status->setup.slot);
    QString name = row.column.isEmpty() ? slot : row.column;
    if (!row.file.isEmpty())
        name = OverviewModel::tr("%1: %2", "file and column").arg(row.file, name);
    return tableWithCrc(name, row.status->table->crc);
}

QString persistenceText(const OverviewRow& row)
{
    if (!row.status || !row.status->table)
        return {};
    return row.status->table->persistent ? OverviewModel::tr("persistent", "table")
                                         : OverviewModel::tr("volatile", "table");
}

QString flashText(const OverviewRow& row)
{
    if (!row.flashUse)
        return {};
    const FlashBudget& budget = row.flashUse->budget;
    if (budget.left == std::numeric_limits<int>::max())
        return OverviewModel::tr("not limited", "flash operations");
    return countText(static_cast<std::size_t>(budget.left));
}

QString proofText(const OverviewRow& row)
{
    if (!row.proof)
        return {};
    const QString found = row.proof->contradicts ? OverviewModel::tr("contradicts its table")
                                                 : percentageText(row.proof->share);
    return found + QStringLiteral(" · ") + clockText(row.proof->time);
}

QVariant alignment(int column)
{
    const bool isNumber = column == OverviewModel::FlashLeft;
    return QVariant::fromValue(
        Qt::Alignment(isNumber ? Qt::AlignHCenter : Qt::AlignLeft) | Qt::AlignVCenter);
}

} // namespace

OverviewModel::OverviewModel(const AxisOverview& overview, QObject* parent)
    : QAbstractTableModel(parent)
    , m_overview(overview)
    , m_rows(static_cast<int>(overview.rows().size()))
{
    connect(&overview, &AxisOverview::rowsReset, this, [this] {
        beginResetModel();
        m_rows = static_cast<int>(m_overview.rows().size());
        endResetModel();
    });
    connect(&overview, &AxisOverview::rowChanged, this,
        [this](int row) { Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1)); });
}

void OverviewModel::showMachine(const MachineController& machine)
{
    m_machine = &machine;
    connect(&machine, &MachineController::driftChanged, this, &OverviewModel::announceAll);
    announceAll();
}

int OverviewModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int OverviewModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant OverviewModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const OverviewRow& row = m_overview.rows().at(static_cast<std::size_t>(index.row()));
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::ToolTipRole:
        return toolTip(row, index.column());
    case Qt::TextAlignmentRole:
        return alignment(index.column());
    case SortRole:
        return sortKey(row, index.column());
    case IsLiveRole:
        return row.isConnected();
    case ToneRole:
        if (row.connection == DriveState::Connection::Lost)
            return static_cast<int>(Tone::Error);
        if (row.isConnected() && row.status)
            return static_cast<int>(stateTone(row.status->axis.state));
        break;
    case DriftToneRole:
        if (const auto tone = m_machine
                ? driftTone(m_machine->driftOf(row.endpoint, row.axis).state)
                : std::nullopt)
            return static_cast<int>(*tone);
        break;
    default:
        break;
    }
    return {};
}

QVariant OverviewModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount)
        return {};
    if (role == Qt::DisplayRole) {
        const std::array<QString, ColumnCount> titles{tr("Drive"), tr("Axis"), tr("State"),
            tr("Machine file"), tr("Table"), tr("Persistency"), tr("Flash left"), tr("Measured"),
            tr("Last proof"), tr("Last write")};
        return titles.at(static_cast<std::size_t>(section));
    }
    if (role == Qt::TextAlignmentRole)
        return alignment(section);
    if (role == Qt::ToolTipRole) {
        const std::array<QString, ColumnCount> tips{tr("The drive, and where it is"),
            tr("The axis of this drive"), tr("What the compensation does now"),
            tr("Whether the axis has what the machine file says, and when it was compared"),
            tr("The table that the axis uses: its file and column where this window has written "
               "it, otherwise its place on the drive; and the checksum of its values"),
            tr("Whether the table survives a reboot"),
            tr("How many flash operations the drive can do now"),
            tr("The accuracy of the axis with this table and before, as the records of this "
               "computer have it"),
            tr("Over which part of the table this window has seen that the drive does what the "
               "table says, and when"),
            tr("When this computer last wrote to the axis")};
        return tips.at(static_cast<std::size_t>(section));
    }
    return {};
}

void OverviewModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    announceAll();
}

void OverviewModel::announceAll()
{
    if (m_rows > 0)
        Q_EMIT dataChanged(index(0, 0), index(m_rows - 1, ColumnCount - 1));
}

QString OverviewModel::stateText(const OverviewRow& row)
{
    switch (row.connection) {
    case DriveState::Connection::Connecting:
        return tr("connecting …");
    case DriveState::Connection::Lost:
        return row.lostSince
            ? notConnectedWord() + QStringLiteral(" · ") + sinceWhen(*row.lostSince)
            : notConnectedWord();
    case DriveState::Connection::Connected:
        break;
    }
    if (!row.axis)
        return tr("no axes");
    if (!row.hasCompensation)
        return tr("no compensation");
    if (row.problem)
        return tr("cannot be read");
    return row.status ? stateWord(row.status->axis) : tr("is being read …");
}

QString OverviewModel::text(const OverviewRow& row, int column) const
{
    switch (column) {
    case Drive:
        return row.driveName.isEmpty() ? row.endpoint : row.driveName;
    case Axis:
        return row.axisName;
    case State:
        return stateText(row);
    case Machine:
        return m_machine && m_machine->file()
            ? driftText(m_machine->driftOf(row.endpoint, row.axis))
            : QString();
    case Table:
        return tableText(row);
    case Persistence:
        return persistenceText(row);
    case FlashLeft:
        return flashText(row);
    case Measured:
        return row.measured ? translated(measuredFiguresCell(*row.measured)) : QString();
    case LastProof:
        return proofText(row);
    case LastWrite:
        return row.lastWrite ? localTimeText(*row.lastWrite) : QString();
    default:
        return {};
    }
}

QVariant OverviewModel::sortKey(const OverviewRow& row, int column) const
{
    switch (column) {
    case FlashLeft:
        return row.flashUse ? row.flashUse->budget.left : -1;
    case LastProof:
        return row.proof ? row.proof->share : -1.0;
    case LastWrite:
        return row.lastWrite ? localTime(*row.lastWrite).toMSecsSinceEpoch() : qint64(0);
    default:
        return text(row, column);
    }
}

QString OverviewModel::toolTip(const OverviewRow& row, int column) const
{
    if (column == Drive)
        return row.serialNumber != 0 ? tr("%1, serial number %2", "address of a drive")
                                           .arg(row.endpoint)
                                           .arg(row.serialNumber)
                                     : row.endpoint;
    if (column == State && row.connection == DriveState::Connection::Lost)
        return row.driveProblem;
    if (column == State && row.problem)
        return errorText(*row.problem);
    if (column == Machine)
        return m_machine ? driftToolTip(m_machine->driftOf(row.endpoint, row.axis)) : QString();
    if (column > State && !row.isConnected() && row.status)
        return asReadText(row.read);
    if (column == Measured && row.measured)
        return translated(measuredFiguresText(*row.measured));
    return text(row, column);
}

} // namespace axiscomp::ui
