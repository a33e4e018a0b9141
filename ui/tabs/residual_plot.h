// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/comparison_model.h"

#include <QWidget>

#include <array>

class QCPGraph;
class QCustomPlot;

namespace axiscomp::ui {

class ValueTicker;

/// The mean error before and what is left of it, at the same scale, each with the band of its
/// standard error. Lines, dashes and markers tell them apart, not colours alone.
class ResidualPlot : public QWidget {
    Q_OBJECT

public:
    explicit ResidualPlot(QWidget* parent = nullptr);

    /// Without a comparison: nothing.
    void show(const ComparisonState& state);
    void retranslate();

protected:
    void changeEvent(QEvent* event) override;

private:
    /// One measurement.
    struct Curve {
        QCPGraph* mean = nullptr;
        QCPGraph* low = nullptr; ///< of the band
        QCPGraph* high = nullptr;
    };
    void build();
    void fill(const Curve& curve, const std::vector<RemainingError>& errors,
        const std::optional<PlacedDeviation>& datum) const;
    void colour();
    void nameAxes();
    void describe();

    QCustomPlot* m_plot;
    QSharedPointer<ValueTicker> m_ticker;
    Curve m_before;
    Curve m_after;
    ComparisonState m_state; ///< that is shown
};

} // namespace axiscomp::ui
