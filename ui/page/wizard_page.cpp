// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/wizard_page.h"

#include "core/drive/drive_profile.h"
#include "ui/controller/wizard_controller.h"
#include "ui/controller/wizard_settings.h"
#include "ui/page/action_panel.h"
#include "ui/page/drive_bar.h"
#include "ui/page/log_view.h"
#include "ui/page/message_stack.h"
#include "ui/page/page_tabs.h"
#include "ui/page/preview_panel.h"
#include "ui/page/setup_panel.h"
#include "ui/page/status_strip.h"

#include <QBoxLayout>
#include <QEvent>
#include <QFrame>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QStackedWidget>

#include <algorithm>

namespace axiscomp::ui {

namespace {

constexpr int margin = 12;
constexpr int spacing = 10;

QFrame* rule()
{
    auto* line = new QFrame;
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Sunken);
    return line;
}

/// Scrolls in height only: its bar is beside the fields, never over them.
class FieldScroll final : public QScrollArea {
public:
    [[nodiscard]] QSize minimumSizeHint() const override
    {
        const int bar = verticalScrollBar()->sizeHint().width();
        return {widget()->minimumSizeHint().width() + bar, QScrollArea::minimumSizeHint().height()};
    }

protected:
    /// Other texts, such as those of another language, may need more room.
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (watched == widget() && event->type() == QEvent::LayoutRequest)
            updateGeometry();
        return QScrollArea::eventFilter(watched, event);
    }
};

} // namespace

WizardPage::WizardPage(WizardController& controller, const DriveProfile& profile, QStyle& style,
    QMenu& menu, QWidget* measure, QWidget* judge, QWidget* fit, QWidget* prove, QWidget* record,
    QWidget* parent)
    : QWidget(parent)
    , driveBar(new DriveBar(controller, menu))
    , messages(new MessageStack)
    , tabs(new PageTabs)
    , setup(new SetupPanel(controller, profile, style))
    , actions(new ActionPanel(controller))
    , preview(new PreviewPanel(controller, profile))
    , log(new LogView(controller.logModel()))
    , status(new StatusStrip(controller))
    , m_controller(controller)
    , m_pages(new QStackedWidget)
    , m_columns(new QSplitter(Qt::Horizontal))
    , m_rows(new QSplitter(Qt::Vertical))
{
    setObjectName(QStringLiteral("wizardPage"));
    buildWritePage();
    for (QWidget* shown : {measure, judge, fit, static_cast<QWidget*>(m_columns), prove})
        m_pages->addWidget(shown);
    m_pages->setCurrentIndex(PageTabs::Write);
    m_rows->setObjectName(QStringLiteral("rows"));
    m_rows->setChildrenCollapsible(false);
    m_rows->addWidget(m_pages);
    m_rows->addWidget(log);
    m_rows->setStretchFactor(0, 1);
    m_rows->setStretchFactor(1, 0);
    m_rows->setSizes({560, 140});
    log->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, spacing, margin, spacing);
    layout->setSpacing(spacing);
    layout->addWidget(driveBar);
    layout->addWidget(buildMessages());
    auto* tabRow = new QHBoxLayout;
    tabRow->addWidget(tabs, 1);
    tabRow->addWidget(record);
    layout->addLayout(tabRow);
    layout->addWidget(m_rows, 1);
    layout->addWidget(rule());
    layout->addWidget(status);
    connect(status, &StatusStrip::logToggled, this, &WizardPage::showLog);
    connect(log, &LogView::closeRequested, this, [this] { showLog(false); });
    connect(tabs, &PageTabs::currentChanged, m_pages, &QStackedWidget::setCurrentIndex);
    for (const auto changed : {&WizardController::selectedTableChanged,
             &WizardController::dataFileChanged, &WizardController::outcomeChanged})
        connect(&controller, changed, this, &WizardPage::showMarkOfWrite);
    connect(&controller.setup(), &SetupModel::fieldChanged, this, &WizardPage::showMarkOfWrite);
    showMarkOfWrite();
}

void WizardPage::buildWritePage()
{
    m_columns->setObjectName(QStringLiteral("columns"));
    m_columns->setChildrenCollapsible(false);
    m_columns->addWidget(buildLeft());
    auto* right = new QWidget;
    auto* rightLayout = new QVBoxLayout(right);
    rightLayout->setContentsMargins(margin, 0, 0, 0);
    rightLayout->addWidget(preview);
    m_columns->addWidget(right);
    m_columns->setStretchFactor(0, 0);
    m_columns->setStretchFactor(1, 1);
    m_columns->setSizes({456, 800});
}

void WizardPage::showMarkOfWrite()
{
    const auto& problems = m_controller.dataFile().problems;
    const bool hasErrors =
        std::ranges::find(problems, Severity::Error, &Diagnostic::severity) != problems.end();
    const auto table = m_controller.selectedTable();
    const bool isOfOtherDimensions =
        table && table->grid.dimensions() != m_controller.setup().edited().dimensionality;
    tabs->setMark(PageTabs::Write,
        hasErrors || isOfOtherDimensions || m_controller.isOutcomeAnError()
            ? PageTabs::Mark::Warning
            : table ? PageTabs::Mark::Ready
                    : PageTabs::Mark::Empty);
}

/// Of a fixed height: a message that comes or goes moves nothing that somebody is about to press.
/// The newest one is seen, the others are scrolled to.
QWidget* WizardPage::buildMessages()
{
    auto* area = new QScrollArea;
    area->setObjectName(QStringLiteral("messageArea"));
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(messages);
    area->setFixedHeight(messages->heightOfOne());
    connect(messages, &MessageStack::shown, area->verticalScrollBar(),
        [bar = area->verticalScrollBar()] { bar->setValue(0); });
    return area;
}

QWidget* WizardPage::buildLeft()
{
    // The fields scroll where the screen is small or the letters are large; the buttons stay.
    auto* scroll = new FieldScroll;
    scroll->setObjectName(QStringLiteral("setupScroll"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(setup);
    auto* left = new QWidget;
    auto* layout = new QVBoxLayout(left);
    layout->setContentsMargins(0, 0, margin, 0);
    layout->setSpacing(spacing);
    layout->addWidget(scroll, 1);
    layout->addWidget(rule());
    layout->addWidget(actions);
    return left;
}

void WizardPage::retranslate()
{
    driveBar->retranslate();
    tabs->retranslate();
    setup->retranslate();
    actions->retranslate();
    preview->retranslate();
    log->retranslate();
    status->retranslate();
}

void WizardPage::showLog(bool isShown)
{
    log->setVisible(isShown);
    status->setLogShown(isShown);
}

bool WizardPage::isLogShown() const
{
    return log->isVisibleTo(this);
}

void WizardPage::restoreSplitters(const WizardSettings& settings)
{
    for (QSplitter* splitter : {m_columns, m_rows}) {
        const QByteArray state = settings.splitter(splitter->objectName());
        if (!state.isEmpty())
            splitter->restoreState(state);
    }
}

void WizardPage::saveSplitters(WizardSettings& settings) const
{
    for (const QSplitter* splitter : {m_columns, m_rows})
        settings.setSplitter(splitter->objectName(), splitter->saveState());
}

} // namespace axiscomp::ui
