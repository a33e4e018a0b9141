// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/fine_scale.h"

#include <QLocale>

#include <cmath>

namespace axiscomp::ui {

QString FineScale::symbol() const
{
    return QString::fromUtf8(m_unit.symbol);
}

QString FineScale::text(double value) const
{
    constexpr int decimals = 2;
    constexpr double half = 0.005;
    const double shown = value * m_unit.factor;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(std::abs(shown) < half ? 0.0 : shown, 'f', decimals);
}

QString FineScale::textWithUnit(double value) const
{
    return text(value) + u' ' + symbol();
}

QString fineText(double value, bool isAngular)
{
    const std::optional<double> shown[] = {value};
    return FineScale(fineUnit(shown, isAngular)).textWithUnit(value);
}

} // namespace axiscomp::ui
