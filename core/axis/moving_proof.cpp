// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/moving_proof.h"

#include "core/axis/shown_grid.h"

#include <cmath>

namespace axiscomp {

MovingProof::MovingProof(
    std::shared_ptr<const CompensationTable> table, std::uint32_t crc, bool readsAtOneInstant)
    : m_table(std::move(table))
    , m_crc(crc)
    , m_rule(*m_table)
    , m_part(m_table->grid)
    , m_readsAtOneInstant(readsAtOneInstant)
{
}

void MovingProof::add(const AxisStatus& status)
{
    const bool isOfTable =
        status.table && status.table->crc == m_crc && isShownAs(status.table->grid, m_table->grid);
    if (status.axis.state != CompensationState::Active || !isOfTable) {
        m_before.reset();
        m_isWithin = false;
        return;
    }
    const auto before = std::exchange(m_before, status.sourceValues);
    m_isWithin = isWithin(m_table->grid, status.sourceValues);
    if (m_failure || (!m_readsAtOneInstant && !before))
        return;
    const Proof::Sample sample =
        m_rule.sampleOf({status.sourceValues, status.output, status.indices, true});
    const ProofRule::Motion motion =
        m_readsAtOneInstant ? ProofRule::Motion{} : m_rule.motionTo(sample, *before);
    if (const auto fits = m_rule.compare(status, sample, motion); !fits) {
        m_failure = fits.error();
        return;
    }
    if (!m_isWithin)
        return;
    m_part.add(sample.sources);
    m_hasContent = m_hasContent || m_rule.shows(sample, motion);
    const double difference = std::abs(sample.output - sample.expected);
    if (difference > m_largestDifference) {
        m_largestDifference = difference;
        m_largestAt = sample.sources;
    }
}

} // namespace axiscomp
