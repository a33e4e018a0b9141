// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"

namespace axiscomp {

// One file for each controller family, docs/formats.md. tableFamilies() lists them.

namespace calibration_csv {
[[nodiscard]] const TableFamily& format(); ///< the calibration file (docs/calibration-csv.md)
}
namespace tam_table {
[[nodiscard]] const TableFamily& format(); ///< the drive's table file (docs/tamtbl.md)
}

namespace aerotech_1d {
[[nodiscard]] const TableFamily& format(); ///< calibration file, :START
}
namespace aerotech_2d {
[[nodiscard]] const TableFamily& format(); ///< calibration file, :START2D
}
namespace icube {
[[nodiscard]] const TableFamily& format(); ///< CSV of Yaskawa iCube Control
}
namespace isg_crosscomp {
[[nodiscard]] const TableFamily& format(); ///< kw.crosscomp of a compensation list
}
namespace isg_crosscomp2 {
[[nodiscard]] const TableFamily& format(); ///< kw.crosscomp2, two sources
}
namespace isg_ssfk {
[[nodiscard]] const TableFamily& format(); ///< kw.ssfk, leadscrew errors
}
namespace klipper {
[[nodiscard]] const TableFamily& format(); ///< bed_mesh of printer.cfg
}
namespace linuxcnc {
[[nodiscard]] const TableFamily& format(); ///< compensation file of a joint
}
namespace pmac_1d {
[[nodiscard]] const TableFamily& format(); ///< DEFINE COMP of one source
}
namespace pmac_2d {
[[nodiscard]] const TableFamily& format(); ///< DEFINE COMP of two sources
}
namespace rapidcode {
[[nodiscard]] const TableFamily& format(); ///< CSV of this program
}
namespace rapidcode_header {
[[nodiscard]] const TableFamily& format(); ///< C++ header
}
namespace reprap {
[[nodiscard]] const TableFamily& format(); ///< heightmap.csv
}
namespace siemens_cec {
[[nodiscard]] const TableFamily& format(); ///< $AN_CEC, an axis by another
}
namespace siemens_eec {
[[nodiscard]] const TableFamily& format(); ///< $AA_ENC_COMP, encoder and leadscrew
}
namespace softmc {
[[nodiscard]] const TableFamily& format(); ///< text table
}
namespace softmc_basic {
[[nodiscard]] const TableFamily& format(); ///< MC-BASIC fragment
}

/// The product's own formats: what the drive adds, on an even grid.
[[nodiscard]] bool isTriamec(const TableFamily& family);

} // namespace axiscomp
