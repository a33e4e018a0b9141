// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wizard/first_paint.h"

#include <QEvent>
#include <QWidget>

namespace axiscomp::app {

FirstPaint::FirstPaint() : m_start(std::chrono::steady_clock::now()) { }

void FirstPaint::watch(QWidget& window, Console& console)
{
    if (!qEnvironmentVariableIsSet("AXISCOMP_TIMING"))
        return;
    m_console = &console;
    window.installEventFilter(this);
}

bool FirstPaint::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::Paint)
        return QObject::eventFilter(watched, event);
    watched->removeEventFilter(this);
    // The rest of the window is painted in the same event; this comes right after it.
    QMetaObject::invokeMethod(
        this,
        [this] {
            const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(
                std::chrono::steady_clock::now() - m_start);
            m_console->note("first paint after " + std::to_string(time.count()) + " ms");
        },
        Qt::QueuedConnection);
    return false;
}

} // namespace axiscomp::app
