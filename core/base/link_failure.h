// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace axiscomp {

/// The drive cannot be reached (any more), or not as it was asked for: the link is made anew.
[[nodiscard]] constexpr bool isLinkFailure(ErrorCode code)
{
    switch (code) {
    case ErrorCode::InvalidEndpoint:
    case ErrorCode::NotConnected:
    case ErrorCode::ConnectionLost:
    case ErrorCode::Timeout:
    case ErrorCode::Protocol:
    case ErrorCode::Unauthorized:
    case ErrorCode::CertificateRejected:
        return true;
    default:
        return false;
    }
}

} // namespace axiscomp
