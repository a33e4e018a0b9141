// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/text/diagnostic.h"

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::app {

/// Dictionaries, lists, text, numbers, True, False and None; a number that is not finite is None,
/// as in a document of --json. The interpreter's lock is held.
[[nodiscard]] pybind11::object pythonObject(const Json& json);

/// What is wrong with a file, as an error has it.
[[nodiscard]] Json diagnosticsJson(const std::vector<Diagnostic>& diagnostics);

/// Text of a file or a drive; bytes that are not UTF-8 are replaced.
[[nodiscard]] pybind11::str pythonText(std::string_view text);
[[nodiscard]] pybind11::list pythonTexts(const std::vector<std::string>& texts);

/// what: the text, for the message. Errors: ValueError for what a file would have as a line of its
/// own, which might state something.
void refuseControl(std::string_view text, const std::string& what);

} // namespace axiscomp::app
