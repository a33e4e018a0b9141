// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"

namespace axiscomp {

// One file for each controller format, docs/formats.md. tableFormats() lists them.

namespace calibration_csv {
[[nodiscard]] const TableFormat& format(); ///< the calibration file (docs/calibration-csv.md)
}
namespace tam_table {
[[nodiscard]] const TableFormat& format(); ///< the drive's table file (docs/tamtbl.md)
}

namespace acs_1d {
[[nodiscard]] const TableFormat& format(); ///< program, ERRORMAP1D or MAP
}
namespace acs_2d {
[[nodiscard]] const TableFormat& format(); ///< program, MAP2
}
namespace aerotech_1d {
[[nodiscard]] const TableFormat& format(); ///< calibration file, :START
}
namespace aerotech_2d {
[[nodiscard]] const TableFormat& format(); ///< calibration file, :START2D
}
namespace fanuc {
[[nodiscard]] const TableFormat& format(); ///< stored pitch error data
}
namespace heidenhain_com {
[[nodiscard]] const TableFormat& format(); ///< .COM with the position in each line
}
namespace heidenhain_com_530 {
[[nodiscard]] const TableFormat& format(); ///< .COM with DATUM and DISTANCE
}
namespace icube {
[[nodiscard]] const TableFormat& format(); ///< CSV of Yaskawa iCube Control
}
namespace isg_crosscomp {
[[nodiscard]] const TableFormat& format(); ///< kw.crosscomp of a compensation list
}
namespace isg_crosscomp2 {
[[nodiscard]] const TableFormat& format(); ///< kw.crosscomp2, two sources
}
namespace isg_ssfk {
[[nodiscard]] const TableFormat& format(); ///< kw.ssfk, leadscrew errors
}
namespace klipper {
[[nodiscard]] const TableFormat& format(); ///< bed_mesh of printer.cfg
}
namespace klipper_twist {
[[nodiscard]] const TableFormat& format(); ///< axis_twist_compensation of printer.cfg
}
namespace kmotion_geo {
[[nodiscard]] const TableFormat& format(); ///< geometric correction of KMotion
}
namespace kmotion_linear {
[[nodiscard]] const TableFormat& format(); ///< positions to command of one axis
}
namespace linuxcnc {
[[nodiscard]] const TableFormat& format(); ///< compensation file of a joint
}
namespace pmac_1d {
[[nodiscard]] const TableFormat& format(); ///< DEFINE COMP of one source
}
namespace pmac_2d {
[[nodiscard]] const TableFormat& format(); ///< DEFINE COMP of two sources
}
namespace power_pmac {
[[nodiscard]] const TableFormat& format(); ///< CompTable of one source
}
namespace rapidcode {
[[nodiscard]] const TableFormat& format(); ///< CSV of this program
}
namespace rapidcode_header {
[[nodiscard]] const TableFormat& format(); ///< C++ header
}
namespace reprap {
[[nodiscard]] const TableFormat& format(); ///< heightmap.csv
}
namespace siemens_cec {
[[nodiscard]] const TableFormat& format(); ///< $AN_CEC, an axis by another
}
namespace siemens_eec {
[[nodiscard]] const TableFormat& format(); ///< $AA_ENC_COMP, encoder and leadscrew
}
namespace softmc {
[[nodiscard]] const TableFormat& format(); ///< text table
}
namespace softmc_basic {
[[nodiscard]] const TableFormat& format(); ///< MC-BASIC fragment
}
namespace twincat_nc {
[[nodiscard]] const TableFormat& format(); ///< structured text of an NC axis
}
namespace weihong {
[[nodiscard]] const TableFormat& format(); ///< axeserr.dat
}

/// The product's own formats: what the drive adds, on an even grid.
[[nodiscard]] bool isTriamec(const TableFormat& format);

} // namespace axiscomp
