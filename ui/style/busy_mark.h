// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBasicTimer>
#include <QWidget>

namespace axiscomp::ui {

/// A small turning arc while something is being asked; takes its place even when it is idle.
class BusyMark : public QWidget {
    Q_OBJECT

public:
    explicit BusyMark(QWidget* parent = nullptr);

    void setBusy(bool busy);
    [[nodiscard]] bool isBusy() const;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void timerEvent(QTimerEvent* event) override;

private:
    QBasicTimer m_timer;
    int m_turn = 0;
};

} // namespace axiscomp::ui
