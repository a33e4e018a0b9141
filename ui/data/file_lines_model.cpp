// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/file_lines_model.h"

#include "ui/style/contrast.h"
#include "ui/style/symbols.h"
#include "ui/text/value_text.h"

#include <QFont>
#include <QGuiApplication>

#include <algorithm>

namespace axiscomp::ui {

void FileLinesModel::setExcerpt(FileExcerpt excerpt, ProblemPlace place)
{
    beginResetModel();
    m_excerpt = std::move(excerpt);
    m_place = std::move(place);
    // The place may be a cell that its line lacks.
    constexpr std::size_t mostColumns = 256;
    std::size_t columns = std::min(m_place.column, mostColumns);
    for (const QStringList& line : m_excerpt.lines)
        columns = std::max(columns, static_cast<std::size_t>(line.size()));
    m_columns = static_cast<int>(columns);
    endResetModel();
}

QModelIndex FileLinesModel::placeIndex() const
{
    const std::size_t line = std::max<std::size_t>(m_place.line, 1);
    if (line < m_excerpt.firstLine || line - m_excerpt.firstLine >= m_excerpt.lines.size())
        return {};
    const int column = m_place.column > 0 ? static_cast<int>(m_place.column) - 1 : 0;
    return index(static_cast<int>(line - m_excerpt.firstLine), std::min(column, m_columns - 1));
}

int FileLinesModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_excerpt.lines.size());
}

int FileLinesModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_columns;
}

bool FileLinesModel::isProblem(const QModelIndex& index) const
{
    if (m_place.line == 0 || index.row() != placeIndex().row())
        return false;
    return m_place.column == 0 || index.column() + 1 == static_cast<int>(m_place.column);
}

QString FileLinesModel::fieldAt(const QModelIndex& index) const
{
    return m_excerpt.lines[static_cast<std::size_t>(index.row())].value(index.column());
}

QString FileLinesModel::cellText(const QModelIndex& index) const
{
    const QString field = fieldAt(index);
    const QString place = tr("line %1, column %2: %3")
                              .arg(countText(m_excerpt.firstLine + std::size_t(index.row())))
                              .arg(index.column() + 1)
                              .arg(field.isEmpty() ? tr("empty") : field);
    return isProblem(index) ? place + QStringLiteral("; ") + m_place.sentence : place;
}

QVariant FileLinesModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::DisplayRole)
        return fieldAt(index);
    if (role == Qt::AccessibleTextRole || role == Qt::ToolTipRole)
        return cellText(index);
    if (!isProblem(index))
        return {};
    const Tone tone = m_place.isError ? Tone::Error : Tone::Warning;
    const QPalette palette = QGuiApplication::palette();
    switch (role) {
    case Qt::BackgroundRole:
        return fillColor(tone, palette);
    case Qt::ForegroundRole:
        return palette.color(QPalette::WindowText);
    case Qt::FontRole: {
        QFont font;
        font.setBold(true);
        return font;
    }
    case Qt::DecorationRole: {
        constexpr int size = 14;
        if (index.column() != placeIndex().column())
            return {};
        return symbolPixmap(m_place.isError ? Symbol::Error : Symbol::Warning,
            frameColor(tone, palette), size, qGuiApp->devicePixelRatio());
    }
    default:
        return {};
    }
}

QVariant FileLinesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    if (orientation == Qt::Vertical)
        return countText(m_excerpt.firstLine + static_cast<std::size_t>(section));
    const QString name = m_excerpt.header.value(section);
    return name.isEmpty() ? QString::number(section + 1)
                          : QStringLiteral("%1: %2").arg(section + 1).arg(name);
}

} // namespace axiscomp::ui
