// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wall_time.h"
#include "core/compensator/axis_compensator.h"
#include "ui/session/rejected_certificate.h"

#include <QString>

#include <cstdint>
#include <optional>

namespace axiscomp::ui {

/// One entry of the Axis field.
struct AxisEntry {
    QString endpoint; ///< of its drive, without a password
    QString driveName;
    std::int32_t serialNumber = 0;
    AxisInfo axis;
    bool isDemo = false;
    bool isUsable = false; ///< false: no compensation registers, or the drive does not answer
    QString label; ///< unique among the entries, "X · Triamec-616 (demo)"
    QString place; ///< what stands in the label between name and remark: " · Triamec-616"
    QString problem; ///< a translated sentence: why it is not usable; empty when it is
};

/// One drive of the connections.
struct DriveState {
    enum class Connection { Connecting, Connected, Lost };
    QString endpoint; ///< without a password
    QString name; ///< empty until identified
    Connection connection = Connection::Connecting;
    QString problem; ///< translated, when Lost
    std::optional<WallTime> lostSince; ///< when Lost
    std::optional<RejectedCertificate> certificate; ///< when Lost because of it
    bool isDemo = false;
    friend bool operator==(const DriveState&, const DriveState&) = default;
};

} // namespace axiscomp::ui
