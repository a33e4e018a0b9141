// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/controller/wizard_options.h"
#include "ui/outcome/last_outcome.h"
#include "ui/outcome/wizard_log.h"
#include "ui/session/drive_connection.h"

#include <QObject>
#include <QStringList>

#include <optional>
#include <vector>

namespace axiscomp::ui {

/// The drives that the window is connected to, their axes, and which of these is the current one.
/// The current axis stays the same while its drive is lost; the first usable one becomes current by
/// itself.
class DriveList : public QObject {
    Q_OBJECT

public:
    /// log and outcome must outlive the list.
    DriveList(const WizardOptions& options, WizardLog& log, LastOutcome& outcome);
    /// Ends all sessions at the same time: together they take no longer than one.
    ~DriveList() override;

    /// Connections to these and no others, in this order.
    void setEndpoints(const QStringList& wanted);
    [[nodiscard]] QStringList endpoints() const; ///< as given, passwords included
    /// Looks at every drive again.
    void refresh();
    /// Looks at one that is lost again, at once.
    void tryAgain(const QString& endpoint);
    [[nodiscard]] const std::vector<DriveState>& drives() const { return m_drives; }
    [[nodiscard]] const std::vector<AxisEntry>& axes() const { return m_axes; }
    /// In the order of drives().
    [[nodiscard]] const std::vector<DriveConnection*>& connections() const { return m_connections; }
    /// endpoint: without a password. Null: there is none.
    [[nodiscard]] DriveConnection* connectionTo(const QString& endpoint) const;

    /// Another entry of axes() becomes the current one.
    void select(int index);
    [[nodiscard]] int currentIndex() const { return m_currentIndex; } ///< -1: none
    [[nodiscard]] bool hasCurrent() const { return m_current.has_value(); }
    /// The current axis's, which there must be.
    [[nodiscard]] const AxisEntry& currentEntry() const;
    /// The current axis's index on its drive; there must be one.
    [[nodiscard]] int currentAxis() const { return m_current->axis; }
    /// Of the current axis; null when there is none.
    [[nodiscard]] DriveConnection* connection() const;
    /// Axes of the current axis's drive that can be written.
    [[nodiscard]] std::vector<AxisEntry> usableAxes() const;
    /// What the current axis's drive offers as sources.
    [[nodiscard]] const std::vector<DimSource>& sourceShortlist() const;

    /// Makes the texts of drives and axes anew and announces them.
    void retranslate();

Q_SIGNALS:
    void drivesChanged();
    void axesChanged();
    void currentAxisChanged();
    /// What is known about the axis that was current is of no use any more.
    void axisLeft();
    /// The drive of the current axis is there. isAnother: nothing is known about this axis yet.
    void axisReady(bool isAnother);
    /// Of an operation on a drive.
    void progressed(axiscomp::ui::DriveConnection* of, const QString& step, double fraction);
    /// The connection goes away.
    void removed(axiscomp::ui::DriveConnection* connection);

private:
    struct AxisKey {
        QString endpoint;
        int axis = 0;
        friend bool operator==(const AxisKey&, const AxisKey&) = default;
    };
    [[nodiscard]] static AxisKey keyOf(const AxisEntry& entry);
    DriveConnection* add(const QString& endpoint);
    void remove(DriveConnection* connection);
    void listDrives();
    void listAxes();
    void nameAxes();
    void choose(const AxisKey& key);
    void leave();
    [[nodiscard]] int indexOf(const AxisKey& key) const;
    void take(DriveConnection* found, bool wasAnother);

    const WizardOptions m_options;
    WizardLog& m_log;
    LastOutcome& m_outcome;
    std::vector<DriveConnection*> m_connections; ///< children of this
    std::vector<DriveState> m_drives;
    std::vector<AxisEntry> m_axes;
    std::optional<AxisKey> m_current;
    int m_currentIndex = -1;
};

/// NotConnected: there is no connection to it, or none any more.
[[nodiscard]] Error connectionEndedTo(const QString& endpoint);

} // namespace axiscomp::ui
