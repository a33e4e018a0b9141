// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_session.h"
#include "core/metrology/fine_quantity.h"

#include <QWidget>

#include <memory>
#include <vector>

class QCPGraph;
class QCustomPlot;

namespace axiscomp::ui {

class ValueTicker;

/// The deviations that were taken so far over the position; up and down by the shape of their
/// marks. What it shows is in the list of steps too.
class CapturedPlot : public QWidget {
    Q_OBJECT

public:
    explicit CapturedPlot(QWidget* parent = nullptr);

    /// unit: of the deviations. Positions reach over the whole plan from the beginning.
    void show(
        const MeasuringPlan& plan, const std::vector<CapturedValue>& values, const FineUnit& unit);
    void clear();
    void retranslate();

protected:
    void changeEvent(QEvent* event) override;

private:
    void colour();
    void fit(const MeasuringPlan& plan, const std::vector<CapturedValue>& values);
    void nameAxes();

    QCustomPlot* m_plot;
    QCPGraph* m_up;
    QCPGraph* m_down;
    QSharedPointer<ValueTicker> m_ticker;
    bool m_isAngular = false;
    FineUnit m_unit;
};

} // namespace axiscomp::ui
