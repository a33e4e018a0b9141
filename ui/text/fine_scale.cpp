// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/fine_scale.h"

#include <QLocale>

#include <cmath>

namespace axiscomp::ui {

QString FineScale::symbol() const
{
    return m_isAngular ? QStringLiteral("″") : QStringLiteral("µm");
}

QString FineScale::text(std::optional<double> value) const
{
    if (!value)
        return QStringLiteral("–");
    constexpr int decimals = 2;
    constexpr double half = 0.005;
    const double shown = *value * factor();
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(std::abs(shown) < half ? 0.0 : shown, 'f', decimals);
}

QString FineScale::textWithUnit(std::optional<double> value) const
{
    return value ? text(value) + u' ' + symbol() : text(value);
}

QString FineScale::signedText(std::optional<double> value) const
{
    constexpr double half = 0.005;
    return value && *value * factor() >= half ? u'+' + text(value) : text(value);
}

} // namespace axiscomp::ui
