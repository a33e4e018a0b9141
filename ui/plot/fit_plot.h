// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/fit_outcome.h"

#include <QWidget>

#include <memory>
#include <optional>

class QLabel;

namespace axiscomp::ui {

/// A fit along one axis: the table over what was measured, with the standard errors of the means,
/// and below it what the table leaves, at the targets and where each is foretold without itself.
/// Both are moved and zoomed together; arrow keys go from one measured place to the next.
class FitPlot : public QWidget {
    Q_OBJECT

public:
    explicit FitPlot(QWidget* parent = nullptr);
    ~FitPlot() override;

    /// Null: none. outcome: with a report.
    void show(std::shared_ptr<const FitOutcome> outcome);
    /// The picture is of an earlier fit.
    void setOutdated(bool isOutdated);
    void retranslate();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void addGraphs();
    void fill();
    void fillResiduals();
    void colour();
    void nameAxes();
    void resetZoom();
    void choose(std::optional<std::size_t> point);
    void sayPoint();
    [[nodiscard]] bool handleKey(int key);

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
