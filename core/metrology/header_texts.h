// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/measurement.h"

#include <array>

namespace axiscomp {

/// What a header says as it is written, by the keys that files, records and notes have for it.
struct HeaderText {
    const char* key;
    std::string MeasurementHeader::*member;
};
inline constexpr std::array headerTexts{HeaderText{"machine", &MeasurementHeader::machine},
    HeaderText{"axis", &MeasurementHeader::axis},
    HeaderText{"instrument", &MeasurementHeader::instrument},
    HeaderText{"serial", &MeasurementHeader::serial},
    HeaderText{"operator", &MeasurementHeader::operatorName},
    HeaderText{"date", &MeasurementHeader::date}, HeaderText{"feed", &MeasurementHeader::feed},
    HeaderText{"dwell", &MeasurementHeader::dwell}, HeaderText{"drive", &MeasurementHeader::drive}};

} // namespace axiscomp
