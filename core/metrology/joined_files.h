// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/measurement.h"

namespace axiscomp {

/// What joined files say of one thing.
template <typename Statement> struct SaidByFiles {
    Statement said; ///< empty: nothing
    std::vector<std::size_t> files; ///< that say it, from 0, in the order of Measurement::joined
};
using TextsOfFiles = std::vector<SaidByFiles<std::string>>;
using NumbersOfFiles = std::vector<SaidByFiles<std::optional<double>>>;

/// Each statement once, in the order of the files; of a measurement of one file its own. Texts are
/// the same whatever their letters.
[[nodiscard]] TextsOfFiles saidByFiles(
    const Measurement& measurement, std::string MeasurementHeader::*text);
[[nodiscard]] NumbersOfFiles saidByFiles(
    const Measurement& measurement, std::optional<double> MeasurementHeader::*number);

/// Whether some contradict others. A file that says nothing of a text contradicts none; a number
/// holds for all only where all say it.
[[nodiscard]] bool areDifferent(const TextsOfFiles& said);
[[nodiscard]] bool areDifferent(const NumbersOfFiles& said);
/// Whether each of two measurements says something, and nothing that the other one says.
[[nodiscard]] bool areAllDifferent(const TextsOfFiles& one, const TextsOfFiles& other);

} // namespace axiscomp
