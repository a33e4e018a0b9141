// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/axis_place.h"
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
    StatedUnits units; ///< in place of those of the file
    std::string target; ///< what the values correct (target_axis.h); empty: as the file says
    /// Nothing that the user says: the target for a file that does not say it, and where the drive
    /// looks up the table that is written, or made of the file of another controller.
    AxisPlace place;
    std::optional<SignConvention> sign; ///< of the file; nothing: as its format says
    std::optional<DirectionChoice> direction;
    MissingPoints missing = MissingPoints::Refuse;
    double snap = 0.0; ///< see CsvOptions
    ResamplingChoice resampling;
    bool dropsWrap = false; ///< a modulo axis becomes a linear one

    friend bool operator==(const ImportChoices&, const ImportChoices&) = default;
    /// The targets for a conversion of this table, as ConversionRequest has them.
    [[nodiscard]] std::vector<std::string> targetsFor(const NeutralTable& table) const;
    /// Something is to be done with the numbers that not even files of the drive go without.
    [[nodiscard]] bool isConversion() const;
};

/// The resampling as core wants it. Errors: InvalidArgument.
[[nodiscard]] Result<decltype(ConversionRequest::resampling)> resamplingRequest(
    const ResamplingChoice& choice, std::size_t dimensions);

} // namespace axiscomp
