// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/proof_follower.h"

namespace axiscomp::ui {

ProofFollower::ProofFollower(
    const DriveProfile& profile, const AxisState& axis, LastOutcome& outcome)
    : m_profile(profile)
    , m_axis(axis)
    , m_outcome(outcome)
{
}

void ProofFollower::take(const std::shared_ptr<const CompensationTable>& table)
{
    const auto& status = m_axis.status();
    if (!status || status->axis.state != CompensationState::Active || !table || !status->table) {
        m_proof.reset();
        return;
    }
    if (!m_proof || m_proof->table() != table)
        m_proof.emplace(table, status->table->crc, m_profile.readsAtOneInstant);
    const bool hadFailed = m_proof->failure().has_value();
    m_proof->add(*status);
    if (!hadFailed && m_proof->failure())
        m_outcome.show([failure = *m_proof->failure()] { return movingProofFailure(failure); });
}

} // namespace axiscomp::ui
