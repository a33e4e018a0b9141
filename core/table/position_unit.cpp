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

/// What sizes are counted in, so that all are whole numbers: of two with one base the factor is the
/// nearest double, such as 1000 from mm to um.
enum class Base { TenthOfNanometer, TenthOfArcsecond, Microradian };

struct Unit {
    std::string_view spelling; ///< in small letters
    Base base;
    double size;
};
constexpr double degree = 36e3; ///< in tenths of an arcsecond
constexpr double radian = 1e6;

bool isLength(const Unit& unit)
{
    return unit.base == Base::TenthOfNanometer;
}

constexpr std::array knownUnits{
    Unit{"nm", Base::TenthOfNanometer, 10.0},
    Unit{"um", Base::TenthOfNanometer, 1e4},
    Unit{"\u00b5m", Base::TenthOfNanometer, 1e4}, // micro sign
    Unit{"\u03bcm", Base::TenthOfNanometer, 1e4}, // Greek letter mu
    Unit{"mm", Base::TenthOfNanometer, 1e7},
    Unit{"millimeter", Base::TenthOfNanometer, 1e7},
    Unit{"cm", Base::TenthOfNanometer, 1e8},
    Unit{"m", Base::TenthOfNanometer, 1e10},
    Unit{"meter", Base::TenthOfNanometer, 1e10},
    Unit{"mil", Base::TenthOfNanometer, 254e3},
    Unit{"inch", Base::TenthOfNanometer, 254e6},
    Unit{"in", Base::TenthOfNanometer, 254e6},
    Unit{"urad", Base::Microradian, 1.0},
    Unit{"\u00b5rad", Base::Microradian, 1.0},
    Unit{"\u03bcrad", Base::Microradian, 1.0},
    Unit{"mrad", Base::Microradian, 1e3},
    Unit{"rad", Base::Microradian, radian},
    Unit{"radian", Base::Microradian, radian},
    Unit{"deg", Base::TenthOfArcsecond, degree},
    Unit{"degree", Base::TenthOfArcsecond, degree},
    Unit{"\u00b0", Base::TenthOfArcsecond, degree}, // degree sign
    Unit{"mdeg", Base::TenthOfArcsecond, 36.0},
    Unit{"turn", Base::TenthOfArcsecond, 360.0 * degree},
    Unit{"turns", Base::TenthOfArcsecond, 360.0 * degree},
    Unit{"rev", Base::TenthOfArcsecond, 360.0 * degree},
    Unit{"arcmin", Base::TenthOfArcsecond, 600.0},
    Unit{"arcsec", Base::TenthOfArcsecond, 10.0},
    Unit{"micrometer", Base::TenthOfNanometer, 1e4},
    Unit{"micrometers", Base::TenthOfNanometer, 1e4},
    Unit{"micrometre", Base::TenthOfNanometer, 1e4},
    Unit{"micrometres", Base::TenthOfNanometer, 1e4},
    Unit{"micron", Base::TenthOfNanometer, 1e4},
    Unit{"microns", Base::TenthOfNanometer, 1e4},
    Unit{"\u339b", Base::TenthOfNanometer, 1e4}, // one character
    Unit{"\u5fae\u7c73", Base::TenthOfNanometer, 1e4},
    Unit{"millimeters", Base::TenthOfNanometer, 1e7},
    Unit{"millimetre", Base::TenthOfNanometer, 1e7},
    Unit{"millimetres", Base::TenthOfNanometer, 1e7},
    Unit{"\u339c", Base::TenthOfNanometer, 1e7}, // one character
    Unit{"\u6beb\u7c73", Base::TenthOfNanometer, 1e7},
    Unit{"meters", Base::TenthOfNanometer, 1e10},
    Unit{"metre", Base::TenthOfNanometer, 1e10},
    Unit{"metres", Base::TenthOfNanometer, 1e10},
    Unit{"thou", Base::TenthOfNanometer, 254e3},
    Unit{"mils", Base::TenthOfNanometer, 254e3},
    Unit{"uin", Base::TenthOfNanometer, 254.0},
    Unit{"\u00b5in", Base::TenthOfNanometer, 254.0},
    Unit{"\u03bcin", Base::TenthOfNanometer, 254.0},
    Unit{"microinch", Base::TenthOfNanometer, 254.0},
    Unit{"microinches", Base::TenthOfNanometer, 254.0},
    Unit{"inches", Base::TenthOfNanometer, 254e6},
    Unit{"zoll", Base::TenthOfNanometer, 254e6},
    Unit{"radians", Base::Microradian, radian},
    Unit{"degrees", Base::TenthOfArcsecond, degree},
    Unit{"'", Base::TenthOfArcsecond, 600.0},
    Unit{"\u2032", Base::TenthOfArcsecond, 600.0}, // prime
    Unit{"arcminute", Base::TenthOfArcsecond, 600.0},
    Unit{"arcminutes", Base::TenthOfArcsecond, 600.0},
    Unit{"\"", Base::TenthOfArcsecond, 10.0},
    Unit{"\u2033", Base::TenthOfArcsecond, 10.0}, // double prime
    Unit{"''", Base::TenthOfArcsecond, 10.0},
    Unit{"arcsecond", Base::TenthOfArcsecond, 10.0},
    Unit{"arcseconds", Base::TenthOfArcsecond, 10.0},
};

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

std::optional<double> unitFactor(std::string_view from, std::string_view to)
{
    const Unit* const a = unitNamed(from);
    const Unit* const b = unitNamed(to);
    if (!a || !b || isLength(*a) != isLength(*b))
        return std::nullopt;
    if (a->base == b->base)
        return a->size / b->size;
    return a->base == Base::Microradian
        ? a->size / radian * (180.0 / std::numbers::pi) / (b->size / degree)
        : a->size / degree * (std::numbers::pi / 180.0) / (b->size / radian);
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
        return first->base == second->base && first->size == second->size;
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
