// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/log_view.h"

#include "ui/style/contrast.h"
#include "ui/style/symbols.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QDateTime>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPalette>
#include <QScrollBar>
#include <QShortcut>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>

namespace axiscomp::ui {

namespace {

QString kindName(LogLine::Kind kind)
{
    switch (kind) {
    case LogLine::Kind::Warning:
        return QStringLiteral("warning");
    case LogLine::Kind::Error:
        return QStringLiteral("error");
    case LogLine::Kind::Information:
        break;
    }
    return QStringLiteral("info");
}

QDateTime dateTime(WallTime time)
{
    const auto sinceEpoch =
        std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(sinceEpoch.count());
}

QString lineText(const LogLine& line)
{
    QString text = dateTime(line.time).toUTC().toString(Qt::ISODateWithMs) + u' '
        + kindName(line.kind) + QStringLiteral(": ") + line.text();
    if (!line.detail.isEmpty())
        text += QStringLiteral(" [") + line.detail + u']';
    return text + u'\n';
}

QVariant decoration(LogLine::Kind kind)
{
    constexpr int size = 14;
    const QPalette palette = QGuiApplication::palette();
    if (kind == LogLine::Kind::Error)
        return symbolPixmap(Symbol::Error, frameColor(Tone::Error, palette), size, 2.0);
    if (kind == LogLine::Kind::Warning)
        return symbolPixmap(Symbol::Warning, frameColor(Tone::Warning, palette), size, 2.0);
    return symbolPixmap(Symbol::Information, mutedTextColor(palette), size, 2.0);
}

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

LogModel::LogModel(const WizardController& controller, QObject* parent)
    : QAbstractTableModel(parent)
    , m_controller(controller)
    , m_lines(controller.log())
{
    connect(&controller, &WizardController::logged, this, &LogModel::follow);
}

int LogModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int LogModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant LogModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const LogLine& line = m_lines.at(static_cast<std::size_t>(index.row()));
    if (role == Qt::DecorationRole && index.column() == Text)
        return decoration(line.kind);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    switch (index.column()) {
    case Time:
        return QLocale().toString(dateTime(line.time).time(), QStringLiteral("HH:mm:ss.zzz"));
    case Text:
        return line.text();
    default:
        return line.detail;
    }
}

QVariant LogModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Time:
        return tr("Time");
    case Text:
        return tr("What happened");
    default:
        return tr("Details");
    }
}

QString LogModel::text() const
{
    QString all;
    for (const LogLine& line : m_lines)
        all += lineText(line);
    return all;
}

QString LogModel::text(const QModelIndexList& rows) const
{
    QList<int> numbers;
    for (const QModelIndex& index : rows)
        numbers += index.row();
    std::ranges::sort(numbers);
    QString selected;
    for (const int row : numbers)
        selected += lineText(m_lines.at(static_cast<std::size_t>(row)));
    return selected;
}

void LogModel::retranslate()
{
    if (!m_lines.empty())
        Q_EMIT dataChanged(index(0, Text), index(rowCount() - 1, Text));
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

void LogModel::follow()
{
    const std::vector<LogLine>& log = m_controller.log();
    // The controller keeps the newest lines only: what it dropped goes here too.
    const auto firstKept = log.empty()
        ? m_lines.end()
        : std::ranges::find(m_lines, log.front().number, &LogLine::number);
    const auto dropped = static_cast<int>(firstKept - m_lines.begin());
    if (dropped > 0) {
        beginRemoveRows({}, 0, dropped - 1);
        m_lines.erase(m_lines.begin(), firstKept);
        endRemoveRows();
    }
    if (log.size() > m_lines.size()) {
        beginInsertRows({}, rowCount(), static_cast<int>(log.size()) - 1);
        m_lines.insert(
            m_lines.end(), log.begin() + static_cast<std::ptrdiff_t>(m_lines.size()), log.end());
        endInsertRows();
    }
}

LogView::LogView(const WizardController& controller, QWidget* parent)
    : QWidget(parent)
    , m_model(new LogModel(controller, this))
    , m_view(new QTreeView)
    , m_title(new QLabel)
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
    connect(m_model, &QAbstractItemModel::rowsInserted, this, [this] {
        const QScrollBar* bar = m_view->verticalScrollBar();
        if (bar->value() == bar->maximum())
            QMetaObject::invokeMethod(m_view, &QTreeView::scrollToBottom, Qt::QueuedConnection);
    });
    retranslate();
}

void LogView::build()
{
    m_view->setObjectName(QStringLiteral("logLines"));
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->header()->setSectionResizeMode(LogModel::Time, QHeaderView::ResizeToContents);
    m_view->header()->resizeSection(LogModel::Text, 640);
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
    return m_model->text();
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
    m_model->retranslate();
}

void LogView::copy()
{
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    QGuiApplication::clipboard()->setText(rows.isEmpty() ? m_model->text() : m_model->text(rows));
}

} // namespace axiscomp::ui
