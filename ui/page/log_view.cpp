// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/log_view.h"

#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QShortcut>
#include <QToolButton>
#include <QTreeView>

namespace axiscomp::ui {

namespace {

QToolButton* toolButton(const char* name, Symbol symbol)
{
    auto* button = new QToolButton;
    button->setObjectName(QLatin1StringView(name));
    button->setIcon(symbolIcon(symbol));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

} // namespace

LogView::LogView(WizardLog& log, QWidget* parent)
    : QWidget(parent)
    , m_log(log)
    , m_view(new QTreeView)
    , m_title(new PlainLabel)
    , m_copy(toolButton("copyLog", Symbol::Copy))
    , m_save(toolButton("saveLog", Symbol::Save))
    , m_close(toolButton("closeLog", Symbol::Close))
{
    setObjectName(QStringLiteral("logView"));
    build();
    connect(m_copy, &QToolButton::clicked, this, &LogView::copy);
    connect(m_save, &QToolButton::clicked, this, &LogView::saveRequested);
    connect(m_close, &QToolButton::clicked, this, &LogView::closeRequested);
    auto* copyKey = new QShortcut(QKeySequence::Copy, m_view);
    copyKey->setContext(Qt::WidgetShortcut);
    connect(copyKey, &QShortcut::activated, this, &LogView::copy);
    connect(&m_log, &QAbstractItemModel::rowsInserted, this, [this] {
        const QScrollBar* bar = m_view->verticalScrollBar();
        if (bar->value() == bar->maximum())
            QMetaObject::invokeMethod(m_view, &QTreeView::scrollToBottom, Qt::QueuedConnection);
    });
    retranslate();
}

void LogView::build()
{
    m_view->setObjectName(QStringLiteral("logLines"));
    m_view->setModel(&m_log);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->header()->setSectionResizeMode(WizardLog::Time, QHeaderView::ResizeToContents);
    m_view->header()->resizeSection(WizardLog::Text, 640);
    // Two lines and their heading, where the screen is small.
    m_view->setMinimumHeight(3 * m_view->fontMetrics().lineSpacing());
    m_view->scrollToBottom();
    auto* top = new QHBoxLayout;
    top->setSpacing(4);
    top->addWidget(m_title);
    top->addStretch(1);
    top->addWidget(m_copy);
    top->addWidget(m_save);
    top->addWidget(m_close);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(top);
    layout->addWidget(m_view, 1);
}

QString LogView::text() const
{
    return m_log.text();
}

void LogView::retranslate()
{
    m_title->setText(tr("Log"));
    m_view->setAccessibleName(tr("Log"));
    const std::array<std::pair<QToolButton*, QString>, 3> buttons{{
        {m_copy, tr("Copy the selected lines, or all of them")},
        {m_save, tr("Save the log to a file")},
        {m_close, tr("Hide the log")},
    }};
    for (const auto& [button, text] : buttons) {
        button->setToolTip(text);
        button->setAccessibleName(text);
    }
}

void LogView::copy()
{
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    QGuiApplication::clipboard()->setText(rows.isEmpty() ? m_log.text() : m_log.text(rows));
}

} // namespace axiscomp::ui
