// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/outcome/wizard_log.h"

#include "ui/outcome/outcome_text.h"
#include "ui/style/contrast.h"
#include "ui/style/symbols.h"
#include "ui/text/message_text.h"

#include <QDateTime>
#include <QGuiApplication>
#include <QLocale>
#include <QPalette>

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

} // namespace

void WizardLog::add(LogLine::Kind kind, const Wording& text, const QString& detail)
{
    if (m_lines.size() == capacity) {
        beginRemoveRows({}, 0, 0);
        m_lines.erase(m_lines.begin());
        endRemoveRows();
    }
    beginInsertRows({}, rowCount(), rowCount());
    m_lines.push_back({std::chrono::system_clock::now(), kind, text, detail});
    endInsertRows();
}

void WizardLog::add(const Error& error)
{
    add(
        LogLine::Kind::Error, [error] { return errorText(error); }, errorOutcome(error).detail);
}

int WizardLog::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int WizardLog::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant WizardLog::data(const QModelIndex& index, int role) const
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

QVariant WizardLog::headerData(int section, Qt::Orientation orientation, int role) const
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

QString WizardLog::text() const
{
    QString all;
    for (const LogLine& line : m_lines)
        all += lineText(line);
    return all;
}

QString WizardLog::text(const QModelIndexList& rows) const
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

void WizardLog::retranslate()
{
    if (!m_lines.empty())
        Q_EMIT dataChanged(index(0, Text), index(rowCount() - 1, Text));
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

} // namespace axiscomp::ui
