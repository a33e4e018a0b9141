// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/moving_proof.h"
#include "ui/controller/axis_state.h"
#include "ui/outcome/last_outcome.h"

#include <QObject>

#include <optional>

namespace axiscomp::ui {

/// Goes on proving while the compensation of the current axis is active: each live status against
/// the table that the drive holds. What has been seen ends with the table and with the activation.
class ProofFollower : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive the follower.
    ProofFollower(const DriveProfile& profile, const AxisState& axis, LastOutcome& outcome);

    /// None: nothing is active, or its table has not been downloaded yet.
    [[nodiscard]] const std::optional<MovingProof>& proof() const { return m_proof; }
    /// The next status, and the table that the drive holds; null: not known.
    void take(const std::shared_ptr<const CompensationTable>& table);
    void forget() { m_proof.reset(); }

private:
    const DriveProfile& m_profile;
    const AxisState& m_axis;
    LastOutcome& m_outcome;
    std::optional<MovingProof> m_proof;
};

} // namespace axiscomp::ui
