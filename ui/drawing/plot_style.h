// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/deviation_curves.h"

#include <QColor>
#include <QPalette>
#include <QString>

class QCPAxis;
class QCPLegend;
class QCustomPlot;

namespace axiscomp::ui {

void stylePlotAxis(QCPAxis& axis, const QColor& text, const QColor& grid);

/// What the plots of a measurement are drawn with: the inks of the report, as far from the
/// background as they need to be.
struct MeasurementInks {
    explicit MeasurementInks(const QPalette& palette);

    QColor base;
    QColor text;
    QColor grid;
    QColor run;
    QColor up;
    QColor down;
    QColor doubtful; ///< proposed for exclusion, or excluded
    QColor selected;
};

/// Of a legend below the axes, which would otherwise be as narrow as it is.
void letLegendBeWide(QCPLegend& legend);
/// Background, axes, and legend where there is one.
void stylePlot(QCustomPlot& plot, const MeasurementInks& inks);

/// Of an axis with deviations: "Deviation [µm]", and below it what is 0 among them, which on one
/// line a low plot would cut.
[[nodiscard]] QString deviationLabel(
    const FineUnit& unit, const std::optional<PlacedDeviation>& datum, bool isAngular);

} // namespace axiscomp::ui
