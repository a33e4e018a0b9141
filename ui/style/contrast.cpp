// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/contrast.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::ui {

namespace {

// A little above the limits of WCAG, so that rounding to 8 bits does not fall below them.
constexpr double frameRatio = 3.1;
constexpr double textRatio = 4.6;

double linear(double channel)
{
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& color)
{
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF())
        + 0.0722 * linear(color.blueF());
}

double smallestRatio(const QColor& color, std::span<const QColor> backgrounds)
{
    double smallest = 21.0;
    for (const QColor& background : backgrounds)
        smallest = std::min(smallest, contrastRatio(color, background));
    return smallest;
}

QColor withLightness(const QColor& color, double lightness)
{
    return QColor::fromHslF(color.hslHueF(), color.hslSaturationF(), static_cast<float>(lightness))
        .toRgb();
}

QColor hueOf(Tone tone)
{
    switch (tone) {
    case Tone::Changed:
        return {0xf5, 0x7c, 0x00};
    case Tone::Error:
        return {0xd3, 0x2f, 0x2f};
    case Tone::Warning:
        return {0xc7, 0x92, 0x00};
    case Tone::Success:
        return {0x2e, 0x8b, 0x45};
    case Tone::Information:
        break;
    }
    return {0x1e, 0x78, 0xc8};
}

std::array<QColor, 2> backgroundsOf(const QPalette& palette)
{
    return {palette.color(QPalette::Active, QPalette::Window),
        palette.color(QPalette::Active, QPalette::Base)};
}

QColor mixed(const QColor& a, const QColor& b, float partOfB)
{
    const auto mix = [partOfB](float x, float y) { return x + (y - x) * partOfB; };
    return QColor::fromRgbF(
        mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()));
}

} // namespace

double contrastRatio(const QColor& a, const QColor& b)
{
    const double first = luminance(a) + 0.05;
    const double second = luminance(b) + 0.05;
    return std::max(first, second) / std::min(first, second);
}

QColor withContrast(const QColor& color, std::span<const QColor> backgrounds, double ratio)
{
    constexpr int steps = 200;
    QColor best = color;
    double bestRatio = smallestRatio(color, backgrounds);
    for (int step = 0; step <= steps && bestRatio < ratio; ++step) {
        const double distance = static_cast<double>(step) / steps;
        for (const double lightness :
            {color.lightnessF() - distance, color.lightnessF() + distance}) {
            const QColor candidate = withLightness(color, std::clamp(lightness, 0.0, 1.0));
            const double candidateRatio = smallestRatio(candidate, backgrounds);
            if (candidateRatio > bestRatio) {
                best = candidate;
                bestRatio = candidateRatio;
            }
        }
    }
    return best;
}

QColor frameColor(Tone tone, const QPalette& palette)
{
    return withContrast(hueOf(tone), backgroundsOf(palette), frameRatio);
}

QColor textColor(Tone tone, const QPalette& palette)
{
    return withContrast(hueOf(tone), backgroundsOf(palette), textRatio);
}

QColor fillColor(Tone tone, const QPalette& palette)
{
    return mixed(palette.color(QPalette::Active, QPalette::Window), hueOf(tone), 0.16F);
}

QColor mutedTextColor(const QPalette& palette)
{
    const QColor muted = mixed(palette.color(QPalette::Active, QPalette::WindowText),
        palette.color(QPalette::Active, QPalette::Window), 0.32F);
    return withContrast(muted, backgroundsOf(palette), textRatio);
}

} // namespace axiscomp::ui
