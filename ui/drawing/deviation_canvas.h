// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fine_quantity.h"
#include "core/metrology/run_selection.h"
#include "ui/record/deviation_series.h"

#include <QObject>
#include <QPalette>
#include <QPointF>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

class QCustomPlot;

namespace axiscomp::ui {

/// A value of one of the measurements of a plot, or all values of a target or of a run.
struct DeviationPlace {
    std::size_t series = 0;
    Exclusion values;

    friend bool operator==(const DeviationPlace&, const DeviationPlace&) = default;
};

/// Draws the plot of ISO 230-2 for one measurement or two, and knows what is where in it.
class DeviationCanvas : public QObject {
    Q_OBJECT

public:
    explicit DeviationCanvas(QWidget* parent);
    ~DeviationCanvas() override;

    [[nodiscard]] QCustomPlot& plot();
    void show(const std::vector<DeviationSeries>& series);
    void setSelected(const std::optional<DeviationPlace>& place);
    void setPalette(const QPalette& palette);
    void retranslate();
    /// Of the deviations in the picture.
    [[nodiscard]] const FineUnit& unit() const;

    /// The value next to a pixel, or the target whose mean is there; none: nothing is near.
    [[nodiscard]] std::optional<DeviationPlace> placeAt(const QPointF& pixel) const;
    /// The position under a pixel; none: outside of the axes.
    [[nodiscard]] std::optional<double> positionAt(const QPointF& pixel) const;

    void showWhole();
    /// factor below 1: nearer.
    void zoom(double factor);

private:
    void draw();
    void drawAgainIfDense();
    void addSeries(std::size_t number);
    void addRuns(std::size_t number);
    void addLegend();
    void fitRanges();
    void paintOverlay();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
