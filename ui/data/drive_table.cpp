// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/drive_table.h"

#include "ui/async/background_job.h"

#include <utility>

namespace axiscomp::ui {

DriveTable::DriveTable(QObject* parent) : QObject(parent) { }

std::optional<DriveTable::Key> DriveTable::keyOf(
    const DriveConnection& connection, const AxisStatus& status)
{
    if (!status.table)
        return std::nullopt;
    // The CRC is of the values only: the same values over another grid are another table.
    std::string grid;
    for (const GridAxis& axis : status.table->grid.axes) {
        grid += toText(RegisterValue{axis.start}) + ' ' + toText(RegisterValue{axis.distance}) + ' '
            + std::to_string(axis.size) + '\n';
    }
    return Key{connection.state().endpoint, status.drive.serialNumber, status.axis.index,
        status.setup.slot, status.table->crc, grid, status.setup.sources};
}

void DriveTable::follow(DriveConnection& connection, const AxisStatus& status, bool mayRetry)
{
    const std::optional<Key> key = keyOf(connection, status);
    if (!key) {
        clear();
        return;
    }
    const bool isNew = m_wanted != key;
    const bool retries = m_hasFailed && mayRetry;
    if (!isNew && (m_isDownloaded || m_isUnderWay || (m_hasFailed && !retries)))
        return;
    if (isNew) {
        m_stop.request_stop();
        m_wanted = key;
        // What was written shows until it has come back from the drive.
        const bool fits = m_expected.table && sameSpans(m_expected.table->grid, status.table->grid);
        set(fits ? m_expected : LoadedTable{});
    }
    m_isUnderWay = true;
    m_isDownloaded = false;
    m_hasFailed = false;
    m_stop = std::stop_source();
    const auto download = [axis = status.axis.index, expected = m_expected](
                              AxisCompensator& compensator, const OperationOptions& options) {
        OperationOptions quiet = options;
        quiet.progress = {};
        return downloadTable(compensator, axis, expected, quiet);
    };
    whenDone(connection.session().run<LoadedTable>(download, m_stop.get_token()), this,
        [this, key = *key, number = ++m_number](const Result<LoadedTable>& table) {
            if (number == m_number)
                take(key, table);
        });
}

void DriveTable::take(const Key& key, const Result<LoadedTable>& table)
{
    m_isUnderWay = false;
    if (m_wanted != key)
        return;
    if (!table) {
        m_hasFailed = true;
        Q_EMIT failed(table.error());
        return;
    }
    m_isDownloaded = true;
    m_expected = {};
    set(*table);
}

void DriveTable::expect(const LoadedTable& written)
{
    m_expected = written;
}

void DriveTable::clear()
{
    m_stop.request_stop();
    ++m_number;
    m_isUnderWay = false;
    m_isDownloaded = false;
    m_hasFailed = false;
    m_expected = {};
    m_wanted.reset();
    set({});
}

void DriveTable::interrupt()
{
    if (!m_isUnderWay)
        return;
    m_stop.request_stop();
    ++m_number;
    m_isUnderWay = false;
}

void DriveTable::set(const LoadedTable& table)
{
    if (table.table == m_table.table)
        return;
    m_table = table;
    Q_EMIT changed();
}

} // namespace axiscomp::ui
