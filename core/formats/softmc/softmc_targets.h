// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/neutral/neutral_table.h"

#include <vector>

namespace axiscomp::softmc {

/// Adds which target axes the program has to define for the table, and in which order, unless they
/// are its sources in their order: the k-th correction is added to the k-th target axis.
void remarkTargets(const NeutralTable& table, std::vector<Text>& remarks);

} // namespace axiscomp::softmc
