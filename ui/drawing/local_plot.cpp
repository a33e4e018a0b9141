// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/local_plot.h"

#include <QEvent>
#include <QLocale>

namespace axiscomp::ui {

LocalPlot::LocalPlot(QWidget* parent) : QCustomPlot(parent)
{
    takeLanguage();
}

void LocalPlot::takeLanguage()
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    setLocale(locale);
}

void LocalPlot::changeEvent(QEvent* event)
{
    QCustomPlot::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        takeLanguage();
        replot(QCustomPlot::rpQueuedReplot);
    }
}

} // namespace axiscomp::ui
