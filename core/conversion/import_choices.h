// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/conversion.h"

#include <optional>
#include <vector>

namespace axiscomp {

/// Onto which even grid a table is brought.
struct ResamplingChoice {
    enum class Kind {
        None,
        Points, ///< numbers: of points
        Distance, ///< numbers: distances
        Within, ///< numbers: the one deviation to keep, in the unit of the values
    };
    Kind kind = Kind::None;
    std::vector<double> numbers; ///< one for each source axis, or one for all
    ResamplingMethod method = ResamplingMethod::Linear;
    bool holdsEnds = false; ///< the grid may go beyond the data

    friend bool operator==(const ResamplingChoice&, const ResamplingChoice&) = default;
};

/// What the user says about a file of tables: how it is to be understood, or written.
struct ImportChoices {
    const TableFormat* format = nullptr; ///< null: by the file's content and name
    FormatSettings settings;
    std::optional<SignConvention> sign; ///< of the file; nothing: as its format says
    std::optional<DirectionChoice> direction;
    ResamplingChoice resampling;
    bool dropsWrap = false; ///< a modulo axis becomes a plain one

    friend bool operator==(const ImportChoices&, const ImportChoices&) = default;
    /// Something is to be done with the numbers that not even files of the drive go without.
    [[nodiscard]] bool isConversion() const;
};

/// The resampling as core wants it. Errors: InvalidArgument.
[[nodiscard]] Result<decltype(ConversionRequest::resampling)> resamplingRequest(
    const ResamplingChoice& choice, std::size_t dimensions);

} // namespace axiscomp
