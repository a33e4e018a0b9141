// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/drawing/deviation_canvas.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QKeyEvent;
class QLabel;
class QMouseEvent;

namespace axiscomp::ui {

/// The plot of ISO 230-2 for one measurement, or for two to the same scale (before and after):
/// single runs, means of both directions with bands of 2 s, the mean of both, and where A, E, M and
/// B arise. Values are selected by mouse and arrow keys; under the picture stands what is there.
class DeviationPlot : public QWidget {
    Q_OBJECT

public:
    explicit DeviationPlot(QWidget* parent = nullptr);
    ~DeviationPlot() override;

    /// None, one or two, of lengths or of angles both. What is selected stays where it is there
    /// still, and so does the view while targets and deviations keep their range.
    void setSeries(std::vector<DeviationSeries> series);
    /// Does not report it.
    void select(const std::optional<DeviationPlace>& place);
    [[nodiscard]] const std::optional<DeviationPlace>& selected() const { return m_selected; }
    /// The widget that has the keys.
    [[nodiscard]] QWidget& picture();
    void retranslate();

Q_SIGNALS:
    /// By mouse or key; none: nothing is selected any more.
    void selectionChanged(const std::optional<axiscomp::ui::DeviationPlace>& place);

protected:
    void changeEvent(QEvent* event) override; ///< palette
    bool eventFilter(QObject* watched, QEvent* event) override; ///< keys and mouse of the picture

private:
    void choose(const std::optional<DeviationPlace>& place);
    [[nodiscard]] bool handleKey(const QKeyEvent& key);
    void handleMouse(const QMouseEvent& mouse);
    void showReadout();
    [[nodiscard]] QString placeText(const DeviationPlace& place) const;
    [[nodiscard]] QString targetText(const DeviationSeries& series, double position) const;

    std::vector<DeviationSeries> m_series;
    std::optional<DeviationPlace> m_selected;
    std::optional<double> m_hovered; ///< position under the mouse
    QPointF m_pressed; ///< where the mouse button went down
    DeviationCanvas* m_canvas;
    QLabel* m_readout;
};

} // namespace axiscomp::ui
