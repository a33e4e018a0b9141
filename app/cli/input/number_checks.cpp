// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input/number_checks.h"

#include <cmath>
#include <string>

namespace axiscomp::app {

namespace {

template <typename IsAllowed> CLI::Validator numberThat(IsAllowed isAllowed, const char* expected)
{
    const auto check = [isAllowed, expected](const std::string& text) {
        double number = 0.0;
        if (!CLI::detail::lexical_cast(text, number) || !std::isfinite(number))
            return text + " is no number";
        return isAllowed(number) ? std::string() : std::string(expected) + ", but is " + text;
    };
    return CLI::Validator(check, std::string());
}

} // namespace

CLI::Validator anyNumber()
{
    return numberThat([](double) { return true; }, "");
}

CLI::Validator numberAboveZero()
{
    return numberThat([](double number) { return number > 0.0; }, "must be above 0");
}

CLI::Validator numberFromZero()
{
    return numberThat([](double number) { return number >= 0.0; }, "must not be negative");
}

} // namespace axiscomp::app
