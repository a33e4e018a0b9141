// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/proof_rule.h"
#include "core/axis/proved_part.h"

#include <memory>
#include <optional>

namespace axiscomp {

/// The end-to-end proof goes on while the axis moves: every status of an active compensation is
/// compared with the table, and what has been seen of the table is kept.
class MovingProof {
public:
    /// table: what the drive holds, with the CRC that it shows for it. readsAtOneInstant: as the
    /// profile says; otherwise a reading may have moved as far as the one before it is away.
    MovingProof(
        std::shared_ptr<const CompensationTable> table, std::uint32_t crc, bool readsAtOneInstant);

    /// Left out: a status that is not Active, and one of another table than this.
    void add(const AxisStatus& status);

    [[nodiscard]] const std::shared_ptr<const CompensationTable>& table() const { return m_table; }
    [[nodiscard]] const ProvedPart& part() const { return m_part; }
    /// Whether anything was seen that a wrong table would have shown: an output within the table
    /// that can be told from 0.
    [[nodiscard]] bool hasContent() const { return m_hasContent; }
    [[nodiscard]] bool isWithinTable() const { return m_isWithin; } ///< at the last reading
    [[nodiscard]] double largestDifference() const { return m_largestDifference; }
    /// Of the sources, where the difference was largest.
    [[nodiscard]] const std::array<double, 3>& largestAt() const { return m_largestAt; }
    /// The first reading that the table does not explain (ProofFailed); it ends the proof.
    [[nodiscard]] const std::optional<Error>& failure() const { return m_failure; }

private:
    std::shared_ptr<const CompensationTable> m_table;
    std::uint32_t m_crc;
    ProofRule m_rule;
    ProvedPart m_part;
    bool m_readsAtOneInstant;
    bool m_hasContent = false;
    bool m_isWithin = false;
    double m_largestDifference = 0.0;
    std::array<double, 3> m_largestAt{};
    std::optional<std::array<double, 3>> m_before; ///< the sources of the last reading
    std::optional<Error> m_failure;
};

} // namespace axiscomp
