// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/position_unit.h"

#include "core/text/edit_distance.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace axiscomp {

namespace {

struct NamedUnit {
    std::string_view positionUnit;
    std::string_view symbol;
};
constexpr std::array positionUnits{NamedUnit{"None", ""}, NamedUnit{"Meter", "m"},
    NamedUnit{"Millimeter", "mm"}, NamedUnit{"Radian", "rad"}, NamedUnit{"Degree", "deg"}};

enum class Base { TenthOfNanometer, TenthOfArcsecond, Microradian };

/// Whole numbers, so that of two with one base the factor is the nearest double, such as 1000 from
/// mm to um.
struct Size {
    Base base;
    double number;
    friend bool operator==(const Size&, const Size&) = default;
};
constexpr Size nanometer{Base::TenthOfNanometer, 10.0};
constexpr Size micrometer{Base::TenthOfNanometer, 1e4};
constexpr Size millimeter{Base::TenthOfNanometer, 1e7};
constexpr Size centimeter{Base::TenthOfNanometer, 1e8};
constexpr Size meter{Base::TenthOfNanometer, 1e10};
constexpr Size microinch{Base::TenthOfNanometer, 254.0};
constexpr Size mil{Base::TenthOfNanometer, 254e3};
constexpr Size inch{Base::TenthOfNanometer, 254e6};
constexpr Size arcsecond{Base::TenthOfArcsecond, 10.0};
constexpr Size millidegree{Base::TenthOfArcsecond, 36.0};
constexpr Size arcminute{Base::TenthOfArcsecond, 600.0};
constexpr Size degree{Base::TenthOfArcsecond, 36e3};
constexpr Size turn{Base::TenthOfArcsecond, 12960e3};
constexpr Size microradian{Base::Microradian, 1.0};
constexpr Size milliradian{Base::Microradian, 1e3};
constexpr Size radian{Base::Microradian, 1e6};

struct Unit {
    std::string_view spelling; ///< in small letters
    Size size;
};
constexpr std::array knownUnits{
    Unit{"nm", nanometer},
    Unit{"um", micrometer},
    Unit{"\u00b5m", micrometer}, // micro sign
    Unit{"\u03bcm", micrometer}, // Greek letter mu
    Unit{"mm", millimeter},
    Unit{"millimeter", millimeter},
    Unit{"cm", centimeter},
    Unit{"m", meter},
    Unit{"meter", meter},
    Unit{"mil", mil},
    Unit{"inch", inch},
    Unit{"in", inch},
    Unit{"urad", microradian},
    Unit{"\u00b5rad", microradian},
    Unit{"\u03bcrad", microradian},
    Unit{"mrad", milliradian},
    Unit{"rad", radian},
    Unit{"radian", radian},
    Unit{"deg", degree},
    Unit{"degree", degree},
    Unit{"\u00b0", degree}, // degree sign
    Unit{"mdeg", millidegree},
    Unit{"turn", turn},
    Unit{"turns", turn},
    Unit{"rev", turn},
    Unit{"arcmin", arcminute},
    Unit{"arcsec", arcsecond},
    Unit{"micrometer", micrometer},
    Unit{"micrometers", micrometer},
    Unit{"micrometre", micrometer},
    Unit{"micrometres", micrometer},
    Unit{"micron", micrometer},
    Unit{"microns", micrometer},
    Unit{"\u339b", micrometer}, // one character
    Unit{"\u5fae\u7c73", micrometer},
    Unit{"millimeters", millimeter},
    Unit{"millimetre", millimeter},
    Unit{"millimetres", millimeter},
    Unit{"\u339c", millimeter}, // one character
    Unit{"\u6beb\u7c73", millimeter},
    Unit{"meters", meter},
    Unit{"metre", meter},
    Unit{"metres", meter},
    Unit{"thou", mil},
    Unit{"mils", mil},
    Unit{"uin", microinch},
    Unit{"\u00b5in", microinch},
    Unit{"\u03bcin", microinch},
    Unit{"microinch", microinch},
    Unit{"microinches", microinch},
    Unit{"inches", inch},
    Unit{"zoll", inch},
    Unit{"radians", radian},
    Unit{"degrees", degree},
    Unit{"'", arcminute},
    Unit{"\u2032", arcminute}, // prime
    Unit{"arcminute", arcminute},
    Unit{"arcminutes", arcminute},
    Unit{"\"", arcsecond},
    Unit{"\u2033", arcsecond}, // double prime
    Unit{"''", arcsecond},
    Unit{"arcsecond", arcsecond},
    Unit{"arcseconds", arcsecond},
};

bool isLength(const Size& size)
{
    return size.base == Base::TenthOfNanometer;
}

std::string inSmallLetters(std::string_view text)
{
    std::string small(text);
    for (char& letter : small) {
        if (letter >= 'A' && letter <= 'Z')
            letter = static_cast<char>(letter - 'A' + 'a');
    }
    return small;
}

const Unit* unitNamed(std::string_view text)
{
    const auto* const unit = std::ranges::find(knownUnits, inSmallLetters(text), &Unit::spelling);
    return unit == knownUnits.end() ? nullptr : unit;
}

/// "1/100 mm", "0.1 um", "mm x 1000": a unit with a factor.
bool isScaledUnit(std::string_view text)
{
    constexpr std::string_view numbers = " 0123456789.,+-^*/eExX";
    constexpr std::string_view operators = "*/xX";
    if (text.find_first_of("0123456789") == std::string_view::npos)
        return false;
    const std::string_view unit =
        text.substr(std::min(text.find_first_not_of(numbers), text.size()));
    if (isPositionUnit(unit))
        return unit.size() < text.size();
    const std::size_t end = text.find_last_not_of(numbers) + 1;
    const std::size_t factor = text.find_first_not_of(' ', end);
    return factor != std::string_view::npos
        && operators.find(text[factor]) != std::string_view::npos
        && isPositionUnit(text.substr(0, end));
}

} // namespace

std::string unitSymbol(std::string_view positionUnit)
{
    const auto* const unit =
        std::ranges::find(positionUnits, positionUnit, &NamedUnit::positionUnit);
    return std::string(unit == positionUnits.end() ? positionUnit : unit->symbol);
}

std::string symbolOrWord(std::string_view positionUnit)
{
    std::string symbol = unitSymbol(positionUnit);
    return symbol.empty() ? std::string(positionUnit) : symbol;
}

std::optional<double> unitFactor(std::string_view from, std::string_view to)
{
    const Unit* const a = unitNamed(from);
    const Unit* const b = unitNamed(to);
    if (!a || !b || isLength(a->size) != isLength(b->size))
        return std::nullopt;
    const double numerator = a->size.number;
    const double denominator = b->size.number;
    if (a->size.base == b->size.base)
        return numerator / denominator;
    return a->size.base == Base::Microradian
        ? numerator / radian.number * (180.0 / std::numbers::pi) / (denominator / degree.number)
        : numerator / degree.number * (std::numbers::pi / 180.0) / (denominator / radian.number);
}

std::optional<double> commonUnitFactor(std::string_view from, std::string_view to)
{
    return from.empty() || to.empty() || isSameUnit(from, to) ? std::optional(1.0)
                                                              : unitFactor(from, to);
}

bool isPositionUnit(std::string_view unit)
{
    return unitNamed(unit) != nullptr;
}

bool looksLikeUnknownUnit(std::string_view text)
{
    constexpr std::array<std::string_view, 27> others{"dm", "km", "pm", "ft", "feet", "foot", "yd",
        "tenths", "grad", "grads", "gon", "mgon", "rpm", "count", "counts", "cts", "inc", "incs",
        "increments", "inkremente", "pulse", "pulses", "steps", "lsb", "ppm", "ms", "hz"};
    constexpr std::size_t fewestLetters = 5; // of shorter ones other words are as near
    if (isScaledUnit(text))
        return true;
    const std::string small = inSmallLetters(text);
    const bool isPhrase = text.find_first_of(" 0123456789") != std::string_view::npos; // "at 20 °C"
    if (isPhrase || isPositionUnit(text) || isTemperatureUnit(text))
        return false;
    const bool hasSign = std::ranges::any_of(
        std::array<std::string_view, 5>{"\u00b5", "\u03bc", "\u00b0", "\u2032", "\u2033"},
        [&](std::string_view sign) { return small.find(sign) != std::string::npos; });
    return hasSign || std::ranges::find(others, small) != others.end()
        || std::ranges::any_of(knownUnits, [&](const Unit& unit) {
               return unit.spelling.size() >= fewestLetters
                   && editDistance(small, unit.spelling, LetterCase::Matters, 2) < 2;
           });
}

bool isTemperatureUnit(std::string_view unit)
{
    constexpr std::array<std::string_view, 10> temperatures{
        "\u00b0c", "degc", "c", "celsius", "k", "kelvin", "\u00b0f", "degf", "f", "fahrenheit"};
    return std::ranges::find(temperatures, inSmallLetters(unit)) != temperatures.end();
}

bool isCelsius(std::string_view unit)
{
    constexpr std::array<std::string_view, 4> names{"\u00b0c", "degc", "c", "celsius"};
    return std::ranges::find(names, inSmallLetters(unit)) != names.end();
}

bool isSameUnit(std::string_view a, std::string_view b)
{
    const Unit* const first = unitNamed(a);
    const Unit* const second = unitNamed(b);
    if (first && second)
        return first->size == second->size;
    return inSmallLetters(a) == inSmallLetters(b);
}

void addUnit(std::vector<std::string>& units, const std::string& unit)
{
    const bool isThere = std::ranges::any_of(
        units, [&](const std::string& other) { return isSameUnit(other, unit); });
    if (!isThere)
        units.push_back(unit);
}

} // namespace axiscomp
