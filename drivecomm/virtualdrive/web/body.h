// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/web/message.h"

#include <httplib.h>

#include <cstdint>

namespace axiscomp::drivecomm {

/// Everything of a request but its body.
[[nodiscard]] WebRequest requestWithoutBody(const httplib::Request& request);

enum class BodyEnd {
    Complete, ///< or thrown away because it was larger than the limit: isTooLarge
    Malformed, ///< or the client went away
    Endless, ///< given up
};
/// Reads the body into request, keeping at most limit bytes.
[[nodiscard]] BodyEnd readBody(const httplib::Request& from,
    const httplib::ContentReader& contentReader, std::uint64_t limit, WebRequest& request);

} // namespace axiscomp::drivecomm
