// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/number_checks.h"

#include "app/common/number_text.h"

#include <cmath>
#include <string>
#include <utility>

namespace axiscomp::app {

namespace {

template <typename IsAllowed> CLI::Validator numberThat(IsAllowed isAllowed, std::string expected)
{
    const auto check = [isAllowed, expected = std::move(expected)](const std::string& text) {
        double number = 0.0;
        if (!CLI::detail::lexical_cast(text, number) || !std::isfinite(number))
            return text + " is no number";
        return isAllowed(number) ? std::string() : expected + ", but is " + text;
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

CLI::Validator numberBetween(double smallest, double largest)
{
    return numberThat(
        [smallest, largest](double number) { return number >= smallest && number <= largest; },
        "must be " + shortText(smallest) + " to " + shortText(largest));
}

} // namespace axiscomp::app
