// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drive_table.h"

#include "ui/future_handler.h"

#include <algorithm>
#include <utility>

namespace axiscomp::ui {

namespace {

bool sameSpans(const Grid& a, const Grid& b)
{
    return std::ranges::equal(a.axes, b.axes, [](const GridAxis& x, const GridAxis& y) {
        return x.start == y.start && x.distance == y.distance && x.size == y.size;
    });
}

bool sameNumbers(const CompensationTable& a, const CompensationTable& b)
{
    return sameSpans(a.grid, b.grid) && a.values == b.values;
}

} // namespace

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
        status.setup.slot, status.table->crc, grid};
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
        set(m_expected && sameSpans(m_expected->grid, status.table->grid) ? m_expected : nullptr);
    }
    m_isUnderWay = true;
    m_isDownloaded = false;
    m_hasFailed = false;
    m_stop = std::stop_source();
    const auto download = [axis = status.axis.index](
                              AxisCompensator& compensator, const OperationOptions& options) {
        OperationOptions quiet = options;
        quiet.progress = {};
        return downloadTable(compensator, axis, quiet);
    };
    using Table = std::shared_ptr<const CompensationTable>;
    whenDone(connection.session().run<Table>(download, m_stop.get_token()), this,
        [this, key = *key, number = ++m_number](const Result<Table>& table) {
            if (number == m_number)
                take(key, table);
        });
}

void DriveTable::take(const Key& key, const Result<std::shared_ptr<const CompensationTable>>& table)
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
    const auto expected = std::exchange(m_expected, nullptr);
    set(expected && sameNumbers(*expected, **table) ? expected : *table);
}

void DriveTable::expect(std::shared_ptr<const CompensationTable> written)
{
    m_expected = std::move(written);
}

void DriveTable::clear()
{
    m_stop.request_stop();
    ++m_number;
    m_isUnderWay = false;
    m_isDownloaded = false;
    m_hasFailed = false;
    m_expected.reset();
    m_wanted.reset();
    set(nullptr);
}

void DriveTable::interrupt()
{
    if (!m_isUnderWay)
        return;
    m_stop.request_stop();
    ++m_number;
    m_isUnderWay = false;
}

void DriveTable::set(std::shared_ptr<const CompensationTable> table)
{
    if (table == m_table)
        return;
    m_table = std::move(table);
    Q_EMIT changed();
}

} // namespace axiscomp::ui
