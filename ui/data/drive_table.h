// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/compensation_setup.h"
#include "core/table/compensation_table.h"
#include "ui/session/drive_connection.h"

#include <QObject>

#include <array>
#include <optional>
#include <stop_token>

namespace axiscomp::ui {

/// The table that an axis uses on its drive, downloaded in the background once for each table, and
/// kept as long as the axis's status shows the same one at the same sources: these say what the
/// table is of.
class DriveTable : public QObject {
    Q_OBJECT

public:
    explicit DriveTable(QObject* parent = nullptr);

    /// Null: none, or not downloaded yet.
    [[nodiscard]] const LoadedTable& table() const { return m_table; }

    /// Sees to it that table() is the one of the status. A download that failed is tried again only
    /// when mayRetry.
    void follow(DriveConnection& connection, const AxisStatus& status, bool mayRetry);
    /// The next table to appear is this one, if its numbers are the same: the file's table has the
    /// names and units that the drive does not keep.
    void expect(const LoadedTable& written);
    void clear();
    /// Lets an operation go first; follow() begins again.
    void interrupt();

Q_SIGNALS:
    void changed();
    void failed(const axiscomp::Error& error);

private:
    struct Key {
        QString endpoint;
        std::int32_t serialNumber = 0;
        int axis = 0;
        std::string slot;
        std::uint32_t crc = 0;
        std::string grid;
        std::array<DimSource, 3> sources; ///< by which the table is described
        friend bool operator==(const Key&, const Key&) = default;
    };
    [[nodiscard]] static std::optional<Key> keyOf(
        const DriveConnection& connection, const AxisStatus& status);
    void take(const Key& key, const Result<LoadedTable>& table);
    void set(const LoadedTable& table);

    std::optional<Key> m_wanted; ///< what table() is, or will be
    LoadedTable m_table;
    LoadedTable m_expected;
    bool m_isUnderWay = false;
    bool m_isDownloaded = false; ///< table() came from the drive
    bool m_hasFailed = false;
    int m_number = 0;
    std::stop_source m_stop;
};

} // namespace axiscomp::ui
