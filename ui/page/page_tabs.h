// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTabBar>

#include <array>

namespace axiscomp::ui {

/// The way from a measurement to the drive, a tab for each part of it. Any tab at any time; each
/// says by a symbol and a word how things are there.
class PageTabs : public QTabBar {
    Q_OBJECT

public:
    enum Tab { Measure, Judge, Fit, Write, Prove, TabCount };
    enum class Mark { Empty, Ready, Warning };

    /// Begins with Write.
    explicit PageTabs(QWidget* parent = nullptr);

    void setMark(Tab tab, Mark mark);
    [[nodiscard]] Mark mark(Tab tab) const { return m_marks.at(tab); }
    /// To the next tab (1) or the previous one (-1), round the ends.
    void step(int step);
    void retranslate();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showMarks();

    std::array<Mark, TabCount> m_marks{};
};

} // namespace axiscomp::ui
