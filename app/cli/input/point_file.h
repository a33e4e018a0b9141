// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"

#include <functional>
#include <string>
#include <vector>

namespace axiscomp::app {

/// What a table is worth at a position: one number for each dimension.
struct TableEvaluation {
    std::size_t dimensions = 1;
    std::function<Result<double>(const std::vector<double>& position)> at;
};

/// Answers the lines of a file of positions, each as soon as it has come: a value on standard
/// output, and an entry in results with --json. file: "-" is standard input. Errors:
/// FileNotReadable, InvalidCalibration for a line that is no position, and those of the evaluation.
[[nodiscard]] Result<void> answerPointFile(Environment& environment,
    const TableEvaluation& evaluation, const std::string& file, Json& results);

} // namespace axiscomp::app
