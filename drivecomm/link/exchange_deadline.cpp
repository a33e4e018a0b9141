// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link/exchange_deadline.h"

#include <array>
#include <charconv>

namespace axiscomp::drivecomm {

tl::unexpected<Error> timeoutError(const std::string& endpoint, const Exchange& exchange)
{
    std::array<char, 32> text{};
    const double seconds = static_cast<double>(exchange.timeout.count()) / 1000.0;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), seconds).ptr;
    return fail(
        ErrorCode::Timeout, {{"endpoint", endpoint}, {"seconds", Quantity{{text.data(), end}}}});
}

} // namespace axiscomp::drivecomm
