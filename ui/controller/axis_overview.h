// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/drive_summary.h"
#include "ui/controller/axis_state.h"
#include "ui/controller/operation_runner.h"
#include "ui/controller/proof_follower.h"
#include "ui/controller/table_selection.h"

#include <QDateTime>
#include <QObject>
#include <QTimer>

#include <map>
#include <optional>
#include <stop_token>
#include <vector>

namespace axiscomp::ui {

/// What is known of one axis, or of a drive that has not said yet which axes it has.
struct OverviewRow {
    QString endpoint; ///< of its drive, without a password
    QString driveName; ///< empty: it has not answered yet
    std::int32_t serialNumber = 0;
    std::optional<int> axis; ///< its index; none: this row is the drive
    QString axisName; ///< as in the Axis field, without the drive
    bool hasCompensation = true;
    DriveState::Connection connection = DriveState::Connection::Connecting;
    std::optional<WallTime> lostSince;
    QString driveProblem; ///< why the drive does not answer, a translated sentence
    std::optional<AxisStatus> status; ///< as last read, also of a drive that is lost now
    QDateTime read; ///< when status was
    std::optional<Error> problem; ///< why it could not be read although the drive answers
    std::optional<WallTime> lastWrite; ///< by this computer
    /// With the table that the axis has, as far as this computer knows.
    std::optional<MeasuredFigures> measured;
    std::optional<FlashUse> flashUse; ///< of the drive
    QString file; ///< from which this window wrote the table; empty: not known
    QString column; ///< the name of the table; empty: not known
    /// What this window has seen of the table that the drive has now.
    struct Proof {
        double share = 0.0; ///< 0 to 1
        bool contradicts = false;
        QDateTime time; ///< of the last reading
    };
    std::optional<Proof> proof;

    [[nodiscard]] bool isConnected() const
    {
        return connection == DriveState::Connection::Connected;
    }
};

/// All axes of all drives that the window is connected to, read again and again while somebody
/// looks. The drives answer on their sessions' threads, and none has more than one question at a
/// time. While something runs on the current drive, that drive is left alone.
class AxisOverview : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive the overview. interval 0: only on readNow().
    AxisOverview(DriveList& drives, const AxisState& axis, const ProofFollower& proof,
        const TableSelection& tables, const OperationRunner& runner,
        std::chrono::milliseconds interval);
    ~AxisOverview() override;

    [[nodiscard]] const std::vector<OverviewRow>& rows() const { return m_rows; }
    /// Reads at once, and then again and again, until nobody looks any more.
    void follow(bool isFollowed);
    void readNow();
    /// This window has written a column of a file to an axis. now: as read back; file: without
    /// folder.
    void noteWritten(
        const QString& endpoint, const AxisStatus& now, const QString& file, const QString& column);

Q_SIGNALS:
    void rowsReset(); ///< other rows, or in another order
    void rowChanged(int row);

private:
    void list();
    void read(DriveConnection& drive);
    void take(DriveConnection& drive, const Result<DriveSummary>& summary);
    void takeCurrent();
    void makeWay();
    void noteSelected();
    void put(OverviewRow& row, const AxisStatus& status) const;
    [[nodiscard]] OverviewRow* currentRow();
    void announce(const OverviewRow& row);

    DriveList& m_drives;
    const AxisState& m_axis;
    const ProofFollower& m_proof;
    const TableSelection& m_tables;
    const OperationRunner& m_runner;
    std::vector<OverviewRow> m_rows;
    QTimer m_timer;
    bool m_isFollowed = false;
    std::map<const DriveConnection*, std::stop_source> m_underWay;
    /// The table of a file that was chosen last, as it would be written, and its file.
    std::shared_ptr<const CompensationTable> m_selected;
    QString m_selectedFile;
};

} // namespace axiscomp::ui
