// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/metrology/measurement.h"

#include <span>

namespace axiscomp {

// Changes of a measurement that a person asks for. Nothing is ever left out or turned round by
// itself.

/// What is left out: a value, a run, or a target. Numbers count from 1; targets in ascending order.
struct Exclusion {
    std::optional<Approach> direction; ///< of a value or a run
    std::optional<std::size_t> target;
    std::optional<int> run;

    friend bool operator==(const Exclusion&, const Exclusion&) = default;
};

/// "down:1:1" (direction, target, run), "run:up:3", "target:7"; several with commas between them.
/// Errors: InvalidArgument.
[[nodiscard]] Result<std::vector<Exclusion>> exclusionsFromText(std::string_view text);
[[nodiscard]] std::string exclusionText(const Exclusion& exclusion);

[[nodiscard]] bool isOneValue(const Exclusion& exclusion); ///< neither a run nor a target
/// Whether it names this value.
[[nodiscard]] bool covers(const Exclusion& exclusion, const RunValue& value);

/// Marks the values as not used. Errors: InvalidArgument for what the measurement does not have.
[[nodiscard]] Result<void> exclude(Measurement& measurement, std::span<const Exclusion> exclusions);

/// Every value is used, also those that a file leaves out.
[[nodiscard]] Measurement withAllValues(Measurement measurement);

/// Up becomes down and down becomes up.
void swapDirections(Measurement& measurement);

/// One measurement with the runs of all: those of the later files are numbered after those of the
/// earlier ones. Headers are the first one's; what others say differently becomes a note, and
/// stands in Measurement::joined. The axis
/// is the first that is said; temperature and expansion of the scale are those that all say. At
/// least one. Errors: InvalidArgument for other kinds than runs, for lengths with angles, for
/// different axes, drives, states of the drive and corrections to 20 deg C, and for the same
/// measurement twice; targets that only some files have are kept and become incomplete runs.
[[nodiscard]] Result<Measurement> joined(std::span<const Measurement> measurements);

/// All that was asked for: joined, then directions exchanged, then values left out. Errors: those
/// of joined() and exclude().
[[nodiscard]] Result<Measurement> selected(std::span<const Measurement> measurements,
    bool swapsDirections, std::span<const Exclusion> exclusions);

} // namespace axiscomp
