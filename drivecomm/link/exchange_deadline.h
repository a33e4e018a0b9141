// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"

#include <algorithm>
#include <chrono>
#include <string>

namespace axiscomp::drivecomm {

/// An Exchange with its clock started: several requests share one deadline.
struct ExchangeDeadline {
    explicit ExchangeDeadline(const Exchange& theExchange)
        : exchange(theExchange)
        , deadline(std::chrono::steady_clock::now()
              + std::min<std::chrono::milliseconds>(theExchange.timeout, std::chrono::years(1)))
    {
    }
    [[nodiscard]] bool isStopped() const { return exchange.stop.stop_requested(); }
    [[nodiscard]] bool isLate() const { return std::chrono::steady_clock::now() >= deadline; }

    const Exchange& exchange;
    std::chrono::steady_clock::time_point deadline;
};

/// Timeout with the endpoint and the seconds of the exchange.
[[nodiscard]] tl::unexpected<Error> timeoutError(
    const std::string& endpoint, const Exchange& exchange);

} // namespace axiscomp::drivecomm
