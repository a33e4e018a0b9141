// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/page_tabs.h"

#include "ui/style/contrast.h"
#include "ui/style/symbols.h"

#include <QEvent>
#include <QIcon>

namespace axiscomp::ui {

namespace {

constexpr int markSize = 16;

QString nameOfTab(PageTabs::Tab tab)
{
    switch (tab) {
    case PageTabs::Measure:
        return PageTabs::tr("Measure");
    case PageTabs::Judge:
        return PageTabs::tr("Judge");
    case PageTabs::Prove:
        return PageTabs::tr("Prove");
    case PageTabs::Fit:
        return PageTabs::tr("Fit");
    case PageTabs::Write:
    case PageTabs::TabCount:
        break;
    }
    return PageTabs::tr("Write");
}

QString purposeOfTab(PageTabs::Tab tab)
{
    switch (tab) {
    case PageTabs::Measure:
        return PageTabs::tr("The files of a measurement, and how they are read");
    case PageTabs::Judge:
        return PageTabs::tr("What the measurement says of the axis, against tolerances");
    case PageTabs::Prove:
        return PageTabs::tr("Measure again with the table active, and see what it has brought");
    case PageTabs::Fit:
        return PageTabs::tr("The table that is made of a measurement, and what it promises");
    case PageTabs::Write:
    case PageTabs::TabCount:
        break;
    }
    return PageTabs::tr("Bring a table to the drive, and activate it");
}

QString wordOf(PageTabs::Mark mark)
{
    switch (mark) {
    case PageTabs::Mark::Ready:
        return PageTabs::tr("ready");
    case PageTabs::Mark::Warning:
        return PageTabs::tr("warning");
    case PageTabs::Mark::Empty:
        break;
    }
    return PageTabs::tr("empty");
}

} // namespace

PageTabs::PageTabs(QWidget* parent) : QTabBar(parent)
{
    setObjectName(QStringLiteral("pageTabs"));
    setExpanding(false);
    setUsesScrollButtons(true);
    setIconSize(QSize(markSize, markSize));
    for (int tab = 0; tab < TabCount; ++tab)
        addTab(QString());
    setCurrentIndex(Write);
    retranslate();
}

void PageTabs::setMark(Tab tab, Mark mark)
{
    if (m_marks.at(tab) == mark)
        return;
    m_marks.at(tab) = mark;
    showMarks();
}

void PageTabs::step(int step)
{
    setCurrentIndex((currentIndex() + step + TabCount) % TabCount);
}

void PageTabs::retranslate()
{
    setAccessibleName(tr("Parts of the work"));
    showMarks();
}

void PageTabs::showMarks()
{
    for (int index = 0; index < TabCount; ++index) {
        const auto tab = static_cast<Tab>(index);
        const Mark mark = m_marks.at(tab);
        setTabText(index, QStringLiteral("%1 · %2").arg(nameOfTab(tab), wordOf(mark)));
        setTabToolTip(index,
            tr("%1 (Ctrl+Page Up and Ctrl+Page Down change the tab)").arg(purposeOfTab(tab)));
        const Symbol symbol = mark == Mark::Ready ? Symbol::Success
            : mark == Mark::Warning               ? Symbol::Warning
                                                  : Symbol::Add;
        const QColor color = mark == Mark::Ready ? frameColor(Tone::Success, palette())
            : mark == Mark::Warning              ? frameColor(Tone::Warning, palette())
                                                 : mutedTextColor(palette());
        setTabIcon(index, symbolPixmap(symbol, color, markSize, devicePixelRatioF()));
    }
}

void PageTabs::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange)
        showMarks();
    QTabBar::changeEvent(event);
}

} // namespace axiscomp::ui
