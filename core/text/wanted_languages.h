// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace axiscomp {

/// The languages that the environment asks for ("de", "en"), the one that is wanted most first, as
/// gettext reads it: LC_ALL, else LC_MESSAGES, else LANG; LANGUAGE before it. English alone where
/// that is C, or asks for an encoding other than UTF-8.
[[nodiscard]] std::vector<std::string> wantedLanguages();

} // namespace axiscomp
