// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/console.h"

#include <QObject>

#include <chrono>

class QWidget;

namespace axiscomp::app {

/// Says on standard error how long after its own making a window was painted first, when the
/// environment asks for it (AXISCOMP_TIMING).
class FirstPaint : public QObject {
    Q_OBJECT

public:
    FirstPaint();

    /// Both must live until the first paint.
    void watch(QWidget& window, Console& console);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::chrono::steady_clock::time_point m_start;
    Console* m_console = nullptr;
};

} // namespace axiscomp::app
