// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/formats/measurement_format.h"

namespace axiscomp {

// One file for each format, docs/metrology.md. measurementFormats() lists them.

namespace runs_csv {
[[nodiscard]] const MeasurementFormat& format(); ///< a line for each value; the program's own
}
namespace wide_csv {
[[nodiscard]] const MeasurementFormat& format(); ///< a line for each target
}
namespace track_csv {
[[nodiscard]] const MeasurementFormat& format(); ///< encoder and reference without targets
}
namespace points_csv {
[[nodiscard]] const MeasurementFormat& format(); ///< values at positions of 2 or 3 axes
}
namespace renishaw {
[[nodiscard]] const MeasurementFormat& format(); ///< .rtl and .rta
}
namespace api_pos {
[[nodiscard]] const MeasurementFormat& format(); ///< .pos
}
namespace ecmc_data {
[[nodiscard]] const MeasurementFormat& format(); ///< TGT_DATA, REF_DATA_FWD, REF_DATA_BWD
}
namespace ecmc_report {
[[nodiscard]] const MeasurementFormat& format(); ///< the Markdown report of such a test
}

} // namespace axiscomp
