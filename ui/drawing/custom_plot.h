// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// qcustomplot.h says signals and foreach, which are no keywords here (QT_NO_KEYWORDS).
#define signals Q_SIGNALS
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef foreach
#undef signals
