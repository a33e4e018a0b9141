// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace axiscomp::app {

/// axis-compensation-wizard. Does not throw.
[[nodiscard]] int runWizard(int argc, char** argv);

} // namespace axiscomp::app
