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

enum class Kind { Length, Angle };

struct Unit {
    std::string_view spelling; ///< in small letters
    Kind kind;
    double size; ///< in metres or radians
};
constexpr double degree = std::numbers::pi / 180.0;
constexpr std::array knownUnits{
    Unit{"nm", Kind::Length, 1e-9},
    Unit{"um", Kind::Length, 1e-6},
    Unit{"\u00b5m", Kind::Length, 1e-6}, // micro sign
    Unit{"\u03bcm", Kind::Length, 1e-6}, // Greek letter mu
    Unit{"mm", Kind::Length, 1e-3},
    Unit{"millimeter", Kind::Length, 1e-3},
    Unit{"cm", Kind::Length, 1e-2},
    Unit{"m", Kind::Length, 1.0},
    Unit{"meter", Kind::Length, 1.0},
    Unit{"mil", Kind::Length, 25.4e-6},
    Unit{"inch", Kind::Length, 0.0254},
    Unit{"in", Kind::Length, 0.0254},
    Unit{"urad", Kind::Angle, 1e-6},
    Unit{"\u00b5rad", Kind::Angle, 1e-6},
    Unit{"\u03bcrad", Kind::Angle, 1e-6},
    Unit{"mrad", Kind::Angle, 1e-3},
    Unit{"rad", Kind::Angle, 1.0},
    Unit{"radian", Kind::Angle, 1.0},
    Unit{"deg", Kind::Angle, degree},
    Unit{"degree", Kind::Angle, degree},
    Unit{"\u00b0", Kind::Angle, degree}, // degree sign
    Unit{"mdeg", Kind::Angle, degree / 1e3},
    Unit{"turn", Kind::Angle, 2.0 * std::numbers::pi},
    Unit{"turns", Kind::Angle, 2.0 * std::numbers::pi},
    Unit{"rev", Kind::Angle, 2.0 * std::numbers::pi},
    Unit{"arcmin", Kind::Angle, degree / 60.0},
    Unit{"arcsec", Kind::Angle, degree / 3600.0},
    Unit{"micrometer", Kind::Length, 1e-6},
    Unit{"micrometers", Kind::Length, 1e-6},
    Unit{"micrometre", Kind::Length, 1e-6},
    Unit{"micrometres", Kind::Length, 1e-6},
    Unit{"micron", Kind::Length, 1e-6},
    Unit{"microns", Kind::Length, 1e-6},
    Unit{"\u339b", Kind::Length, 1e-6}, // one character
    Unit{"\u5fae\u7c73", Kind::Length, 1e-6},
    Unit{"millimeters", Kind::Length, 1e-3},
    Unit{"millimetre", Kind::Length, 1e-3},
    Unit{"millimetres", Kind::Length, 1e-3},
    Unit{"\u339c", Kind::Length, 1e-3}, // one character
    Unit{"\u6beb\u7c73", Kind::Length, 1e-3},
    Unit{"meters", Kind::Length, 1.0},
    Unit{"metre", Kind::Length, 1.0},
    Unit{"metres", Kind::Length, 1.0},
    Unit{"thou", Kind::Length, 25.4e-6},
    Unit{"mils", Kind::Length, 25.4e-6},
    Unit{"uin", Kind::Length, 25.4e-9},
    Unit{"\u00b5in", Kind::Length, 25.4e-9},
    Unit{"\u03bcin", Kind::Length, 25.4e-9},
    Unit{"microinch", Kind::Length, 25.4e-9},
    Unit{"microinches", Kind::Length, 25.4e-9},
    Unit{"inches", Kind::Length, 0.0254},
    Unit{"zoll", Kind::Length, 0.0254},
    Unit{"radians", Kind::Angle, 1.0},
    Unit{"degrees", Kind::Angle, degree},
    Unit{"'", Kind::Angle, degree / 60.0},
    Unit{"\u2032", Kind::Angle, degree / 60.0}, // prime
    Unit{"arcminute", Kind::Angle, degree / 60.0},
    Unit{"arcminutes", Kind::Angle, degree / 60.0},
    Unit{"\"", Kind::Angle, degree / 3600.0},
    Unit{"\u2033", Kind::Angle, degree / 3600.0}, // double prime
    Unit{"''", Kind::Angle, degree / 3600.0},
    Unit{"arcsecond", Kind::Angle, degree / 3600.0},
    Unit{"arcseconds", Kind::Angle, degree / 3600.0},
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
    if (!a || !b || a->kind != b->kind)
        return std::nullopt;
    return a->size / b->size;
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
        return first->kind == second->kind && first->size == second->size;
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
