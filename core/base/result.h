// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <tl/expected.hpp>

namespace axiscomp {

/// A value or an Error. Functions that return one are [[nodiscard]]; no exception crosses a module.
template <typename T> using Result = tl::expected<T, Error>;

/// For `return fail(ErrorCode::..., {{"key", "value"}}, detail);`
[[nodiscard]] inline tl::unexpected<Error> fail(
    ErrorCode code, ErrorContext context = {}, std::string detail = {})
{
    return tl::unexpected<Error>(Error{code, std::move(context), std::move(detail)});
}

/// Hands an error on: `return fail(other.error());`
[[nodiscard]] inline tl::unexpected<Error> fail(Error error)
{
    return tl::unexpected<Error>(std::move(error));
}

} // namespace axiscomp
