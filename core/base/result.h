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

#define AXISCOMP_JOINED_2(a, b) a##b
#define AXISCOMP_JOINED(a, b) AXISCOMP_JOINED_2(a, b)

/// AXISCOMP_TRY(auto drive, identify(options)); declares the value of a Result, or hands its error
/// on from the function.
#define AXISCOMP_TRY(declaration, ...)                                                             \
    AXISCOMP_TRY_AS(AXISCOMP_JOINED(axiscompResult, __LINE__), declaration, __VA_ARGS__)
#define AXISCOMP_TRY_AS(result, declaration, ...)                                                  \
    auto result = (__VA_ARGS__);                                                                   \
    if (!result)                                                                                   \
        return ::axiscomp::fail(std::move(result).error());                                        \
    declaration = *std::move(result)

/// AXISCOMP_CHECK(write(registers)); hands the error of a Result on from the function.
#define AXISCOMP_CHECK(...)                                                                        \
    do {                                                                                           \
        if (auto axiscompChecked = (__VA_ARGS__); !axiscompChecked)                                \
            return ::axiscomp::fail(std::move(axiscompChecked).error());                           \
    } while (false)
