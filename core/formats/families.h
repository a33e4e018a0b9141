// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_family.h"

namespace axiscomp {

// One file for each controller family, spec/controllers.md. tableFamilies() lists them.

[[nodiscard]] const TableFamily& softmcFamily(); ///< text table

} // namespace axiscomp
