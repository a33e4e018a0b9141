// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/value_ticker.h"

namespace axiscomp::ui {

void ValueTicker::generate(const QCPRange& range, const QLocale& locale, QChar formatChar,
    int precision, QVector<double>& ticks, QVector<double>* subTicks, QVector<QString>* tickLabels)
{
    QCPAxisTicker::generate(QCPRange(range.lower * m_factor, range.upper * m_factor), locale,
        formatChar, precision, ticks, subTicks, tickLabels);
    for (double& tick : ticks)
        tick /= m_factor;
    if (subTicks)
        for (double& tick : *subTicks)
            tick /= m_factor;
}

} // namespace axiscomp::ui
