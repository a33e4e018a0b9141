// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/position_unit.h"

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
constexpr std::array units{
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
    const auto* const unit = std::ranges::find(units, inSmallLetters(text), &Unit::spelling);
    return unit == units.end() ? nullptr : unit;
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

} // namespace axiscomp
