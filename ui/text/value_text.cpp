// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/value_text.h"

#include "core/text/number_text.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace axiscomp::ui {

namespace {

struct Unit {
    const char* name; ///< the drive's
    const char* symbol;
    const char* smallSymbol;
    double smallPerUnit;
};

constexpr std::array units{
    Unit{"Meter", "m", "µm", 1e6},
    Unit{"Millimeter", "mm", "µm", 1e3},
    Unit{"Radian", "rad", "µrad", 1e6},
    Unit{"Degree", "°", "m°", 1e3},
};

const Unit* unitNamed(const std::string& positionUnit)
{
    for (const Unit& unit : units) {
        if (positionUnit == unit.name)
            return &unit;
    }
    return nullptr;
}

QString translated(const char* text)
{
    return QCoreApplication::translate("ValueText", text);
}

/// How many decimals all positions of an axis need; none when that is more than can be read.
std::optional<int> decimalsOf(const GridAxis& axis)
{
    constexpr int most = 6;
    constexpr double rounding = 1e-6;
    double perUnit = 1.0;
    for (int decimals = 0; decimals <= most; ++decimals, perUnit *= 10.0) {
        const auto isWhole = [&](double number) {
            const double scaled = number * perUnit;
            return std::abs(scaled - std::round(scaled)) < rounding * axis.distance * perUnit;
        };
        if (isWhole(axis.start) && isWhole(axis.distance))
            return decimals;
    }
    return std::nullopt;
}

QString withSign(double value, QString text)
{
    return value > 0.0 ? text.prepend(u'+') : text;
}

} // namespace

QString qString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString numberText(double value)
{
    constexpr int digits = 7;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'g', digits);
}

QString signedNumberText(double value)
{
    return withSign(value, numberText(value));
}

QString countText(std::size_t count)
{
    return QLocale().toString(static_cast<qulonglong>(count));
}

QString positionText(const GridAxis& axis, std::size_t index)
{
    return QString::fromLatin1(plainPosition(axis, index)).replace(u'.', QLocale().decimalPoint());
}

QString alignedPositionText(const GridAxis& axis, std::size_t index)
{
    const auto decimals = decimalsOf(axis);
    if (!decimals)
        return positionText(axis, index);
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    // 10 - 100 * 0.1 is a little beside zero.
    const double position = axis.position(index);
    const bool isZero = std::abs(position) < axis.distance * 1e-9;
    return locale.toString(isZero ? 0.0 : position, 'f', *decimals);
}

QString unitSuffix(const std::string& unit)
{
    return unit.empty() ? QString() : u' ' + QString::fromStdString(unit);
}

QString withUnit(const QString& name, const std::string& unit)
{
    return unit.empty() ? name : name + QStringLiteral(" [") + QString::fromStdString(unit) + u']';
}

QByteArray plainValue(float value)
{
    // Without an exponent where that stays readable, so that a column of numbers can be compared.
    const float size = std::abs(value);
    const bool isPlain = value == 0.0F || (size >= 1e-9F && size < 1e9F);
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value == 0.0F ? 0.0F : value,
            isPlain ? std::chars_format::fixed : std::chars_format::scientific);
    return {text.data(), end.ptr - text.data()};
}

QByteArray plainPosition(const GridAxis& axis, std::size_t index)
{
    constexpr double fewest = 7.0;
    constexpr double most = 15.0;
    const double largest = std::max(std::abs(axis.start), std::abs(axis.last()));
    const double digits = std::ceil(std::log10(largest / axis.distance)) + 4.0;
    const double position = axis.position(index);
    // 10 - 100 * 0.1 is a little beside zero.
    const bool isZero = std::abs(position) < axis.distance * 1e-9;
    return QByteArray::number(
        isZero ? 0.0 : position, 'g', static_cast<int>(std::clamp(digits, fewest, most)));
}

QString percentageText(double share)
{
    QString text = qString(percentText(share));
    return text.replace(u'.', QLocale().decimalPoint()) + QStringLiteral(" %");
}

QString listText(const QStringList& items)
{
    return items.join(QCoreApplication::translate("ValueText", ", ", "between items of a list"));
}

QString sentenceEnd()
{
    return QCoreApplication::translate("ValueText", ".", "ends a sentence");
}

QString durationText(int seconds)
{
    return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QChar(u'0'));
}

QString unitSymbol(const std::string& positionUnit)
{
    if (const Unit* unit = unitNamed(positionUnit))
        return QString::fromUtf8(unit->symbol);
    return positionUnit == "None" ? QString() : QString::fromStdString(positionUnit);
}

QString smallValueText(double value, const std::string& positionUnit)
{
    constexpr int decimals = 3;
    const Unit* unit = unitNamed(positionUnit);
    if (!unit || !std::isfinite(value))
        return QStringLiteral("%1 %2")
            .arg(signedNumberText(value), unitSymbol(positionUnit))
            .trimmed();
    const double small = value * unit->smallPerUnit;
    return withSign(small, QLocale().toString(small, 'f', decimals)) + u' '
        + QString::fromUtf8(unit->smallSymbol);
}

QString localTimeText(WallTime time)
{
    const auto sinceEpoch =
        std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch());
    return QLocale().toString(
        QDateTime::fromMSecsSinceEpoch(sinceEpoch.count()), QLocale::ShortFormat);
}

QString dimensionName(const Grid& grid, std::size_t dimension)
{
    const std::string& name = grid.axes[dimension].name;
    if (!name.empty())
        return QString::fromStdString(name);
    return translated(QT_TRANSLATE_NOOP("ValueText", "Dim %1")).arg(dimension + 1);
}

QString gridText(const Grid& grid)
{
    QStringList sizes;
    QString ranges;
    for (std::size_t n = 0; n < grid.axes.size(); ++n) {
        const GridAxis& axis = grid.axes[n];
        const bool hasSize = axis.size > 0; // else the drive does not show it
        sizes += hasSize ? countText(axis.size) : QStringLiteral("-");
        ranges += QStringLiteral(", %1 %2 … %3")
                      .arg(dimensionName(grid, n), numberText(axis.start),
                          hasSize ? numberText(axis.last()) : QStringLiteral("-"));
    }
    return translated(QT_TRANSLATE_NOOP("ValueText", "%1 points")).arg(sizes.join(u" × ")) + ranges;
}

} // namespace axiscomp::ui
