// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"

namespace axiscomp {

// One file for each controller family, spec/controllers.md. tableFamilies() lists them.

[[nodiscard]] const TableFamily& calibrationCsvFamily(); ///< the calibration file (spec/csv.md)
[[nodiscard]] const TableFamily& tamTableFamily(); ///< the drive's table file (spec/tamtbl.md)

[[nodiscard]] const TableFamily& aerotech1dFamily(); ///< calibration file, :START
[[nodiscard]] const TableFamily& aerotech2dFamily(); ///< calibration file, :START2D
[[nodiscard]] const TableFamily& icubeFamily(); ///< CSV of Yaskawa iCube Control
[[nodiscard]] const TableFamily& isgCrosscompFamily(); ///< kw.crosscomp of a compensation list
[[nodiscard]] const TableFamily& isgCrosscomp2Family(); ///< kw.crosscomp2, two sources
[[nodiscard]] const TableFamily& isgSsfkFamily(); ///< kw.ssfk, leadscrew errors
[[nodiscard]] const TableFamily& klipperFamily(); ///< bed_mesh of printer.cfg
[[nodiscard]] const TableFamily& linuxcncFamily(); ///< compensation file of a joint
[[nodiscard]] const TableFamily& pmac1dFamily(); ///< DEFINE COMP of one source
[[nodiscard]] const TableFamily& pmac2dFamily(); ///< DEFINE COMP of two sources
[[nodiscard]] const TableFamily& rapidcodeFamily(); ///< CSV of this program
[[nodiscard]] const TableFamily& rapidcodeHeaderFamily(); ///< C++ header
[[nodiscard]] const TableFamily& reprapFamily(); ///< heightmap.csv
[[nodiscard]] const TableFamily& siemensCecFamily(); ///< $AN_CEC, an axis by another
[[nodiscard]] const TableFamily& siemensEecFamily(); ///< $AA_ENC_COMP, encoder and leadscrew
[[nodiscard]] const TableFamily& softmcFamily(); ///< text table
[[nodiscard]] const TableFamily& softmcBasicFamily(); ///< MC-BASIC fragment

/// The product's own formats: what the drive adds, on an even grid.
[[nodiscard]] bool isTriamec(const TableFamily& family);

} // namespace axiscomp
