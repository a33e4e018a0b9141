// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/record_figures.h"

namespace axiscomp::app {

/// Nothing of this program would read them: they are for `status`.
void keepFiguresOrWarn(Environment& /*environment*/, const CalibrationRecord& /*record*/) { }

} // namespace axiscomp::app
