// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/drawing/custom_plot.h"

namespace axiscomp::ui {

/// Round numbers of the unit that values are shown in, on an axis in the table's own unit.
class ValueTicker : public QCPAxisTicker {
public:
    /// factor: shown value per value.
    void setFactor(double factor) { m_factor = factor; }
    void generate(const QCPRange& range, const QLocale& locale, QChar formatChar, int precision,
        QVector<double>& ticks, QVector<double>* subTicks, QVector<QString>* tickLabels) override;

private:
    double m_factor = 1.0;
};

} // namespace axiscomp::ui
