// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/drawing/custom_plot.h"

namespace axiscomp::ui {

/// A plot whose numbers are in the language of the window, also after that has changed. QCustomPlot
/// keeps the one in which it was made.
class LocalPlot : public QCustomPlot {
public:
    explicit LocalPlot(QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void takeLanguage();
};

} // namespace axiscomp::ui
