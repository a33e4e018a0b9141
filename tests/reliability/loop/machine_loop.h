// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/record/comparison.h"
#include "tests/support/link_attachment.h"

#include <QTemporaryDir>

#include <cstdint>
#include <optional>

namespace axiscomp::test {

/// A machine with errors of its own that is measured, compensated and measured again over one link:
/// the screw of docs/metrology.md ("The whole loop"), 500 mm with a lead of 10 mm. Each measurement
/// has a drive of its own, that of the same machine, switched on again: with it come the table that
/// is written to it, and other targets.
class MachineLoop {
public:
    struct Size {
        int targets = 51;
        int cycles = 5; ///< runs in each direction
    };
    /// seed: of the noise of the machine and of the targets.
    MachineLoop(AttachmentKind kind, std::uint64_t seed, Size size)
        : m_kind(std::move(kind))
        , m_seed(seed)
        , m_size(size)
    {
    }
    MachineLoop(AttachmentKind kind, std::uint64_t seed)
        : MachineLoop(std::move(kind), seed, Size{})
    {
    }

    /// What goes wrong on the way; by default nothing.
    struct Fault {
        bool isInstrumentInverted = false; ///< the user says so, and it is not
        bool isSwitchedOff = false; ///< the compensation, in the middle of a measurement
    };
    /// With the table written and active, or without one.
    /// Errors: those of writing, activating, the proof and capturing, MeasurementState when the
    /// capture stops.
    [[nodiscard]] Result<Measurement> measure(const std::optional<CompensationTable>& table = {})
    {
        return measure(table, Fault{});
    }
    [[nodiscard]] Result<Measurement> measure(
        const std::optional<CompensationTable>& table, const Fault& fault);

    [[nodiscard]] static FitSettings linear(); ///< straight lines, a point each 10 mm
    [[nodiscard]] static FitSettings smooth(); ///< the lead known, a point each 0.5 mm
    /// onto: the table that was active. Errors: as fitMeasurement.
    [[nodiscard]] static Result<FitReport> fit(const Measurement& measurement,
        const FitSettings& settings, const std::optional<CompensationTable>& onto = {});

private:
    AttachmentKind m_kind;
    std::uint64_t m_seed;
    Size m_size;
    std::uint64_t m_measurements = 0; ///< so far: each has its own targets
    QTemporaryDir m_folder;
};

} // namespace axiscomp::test
