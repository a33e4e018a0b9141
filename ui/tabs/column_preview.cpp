// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/column_preview.h"

#include "ui/text/value_text.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFile>
#include <QHeaderView>
#include <QSignalBlocker>

#include <algorithm>
#include <array>

namespace axiscomp::ui {

namespace {

constexpr std::size_t previewRows = 100;
constexpr qint64 previewBytes = 64 * 1024;
constexpr std::array<std::string_view, 10> columnRoles{"target", "direction", "run", "deviation",
    "reference", "encoder", "output", "time", "temperature", "use"};

QString roleText(const char* role)
{
    static constexpr std::array names{QT_TRANSLATE_NOOP("ColumnRole", "target"),
        QT_TRANSLATE_NOOP("ColumnRole", "direction"), QT_TRANSLATE_NOOP("ColumnRole", "run"),
        QT_TRANSLATE_NOOP("ColumnRole", "deviation"), QT_TRANSLATE_NOOP("ColumnRole", "reference"),
        QT_TRANSLATE_NOOP("ColumnRole", "encoder"), QT_TRANSLATE_NOOP("ColumnRole", "output"),
        QT_TRANSLATE_NOOP("ColumnRole", "time"), QT_TRANSLATE_NOOP("ColumnRole", "temperature"),
        QT_TRANSLATE_NOOP("ColumnRole", "use")};
    static_assert(names.size() == columnRoles.size());
    return QCoreApplication::translate("ColumnRole", role);
}

std::optional<MeasurementPreview> previewOf(const QString& path, std::size_t skippedLines)
{
    QFile file(path);
    if (path.isEmpty() || !file.open(QIODevice::ReadOnly))
        return std::nullopt;
    QByteArray text = file.read(previewBytes);
    // The last line may be cut.
    if (!file.atEnd())
        text.truncate(text.lastIndexOf('\n') + 1);
    return previewMeasurement(
        {text.constData(), static_cast<std::size_t>(text.size())}, skippedLines, previewRows);
}

} // namespace

ColumnPreview::ColumnPreview(QWidget* parent)
    : QTableWidget(parent)
    , m_job([this](const Preview& preview) { fill(preview); })
{
    setObjectName(QStringLiteral("columnPreview"));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    retranslate();
}

void ColumnPreview::show(const QString& path, const MeasurementChoices& choices)
{
    const bool isShown = path == m_path && choices.skippedLines == m_skippedLines;
    m_path = path;
    m_skippedLines = choices.skippedLines;
    m_columns = choices.columns;
    if (isShown)
        return choose(m_columns);
    m_preview.reset();
    m_job.start(
        [path, lines = m_skippedLines](const std::stop_token&) { return previewOf(path, lines); });
}

void ColumnPreview::fill(const Preview& preview)
{
    m_preview = preview;
    m_lists.clear();
    clear();
    setRowCount(0);
    setColumnCount(0);
    if (!preview)
        return Q_EMIT previewed();
    setColumnCount(static_cast<int>(preview->columns.size()));
    setRowCount(static_cast<int>(preview->rows.size()) + 1);
    setHorizontalHeaderLabels(header());
    for (int column = 0; column < columnCount(); ++column)
        addList(column);
    for (std::size_t row = 0; row < preview->rows.size(); ++row)
        for (std::size_t column = 0; column < preview->rows[row].size(); ++column)
            setItem(static_cast<int>(row) + 1, static_cast<int>(column),
                new QTableWidgetItem(qString(preview->rows[row][column])));
    retranslate();
    choose(m_columns);
    Q_EMIT previewed();
}

std::vector<ColumnMapping> ColumnPreview::mappingOf(const QStringList& roles)
{
    std::vector<ColumnMapping> columns;
    for (qsizetype n = 0; n < roles.size(); ++n) {
        const std::string role = roles[n].toStdString();
        if (std::ranges::find(columnRoles, role) != columnRoles.end())
            columns.push_back({role, std::to_string(n + 1)});
    }
    return columns;
}

QStringList ColumnPreview::rolesOf(const std::vector<ColumnMapping>& columns, qsizetype count)
{
    QStringList roles;
    for (qsizetype n = 0; n < count; ++n) {
        const auto mapped =
            std::ranges::find(columns, std::to_string(n + 1), &ColumnMapping::column);
        roles += mapped == columns.end() ? QString() : qString(mapped->role);
    }
    return roles;
}

QStringList ColumnPreview::header() const
{
    QStringList names;
    if (m_preview)
        for (const std::string& name : m_preview->columns)
            names += qString(name);
    return names;
}

QString ColumnPreview::mappingText(const std::vector<ColumnMapping>& columns)
{
    QStringList words;
    for (const ColumnMapping& mapped : columns)
        words += tr("%1 in column %2").arg(roleText(mapped.role.c_str()), qString(mapped.column));
    return listText(words);
}

void ColumnPreview::addList(int column)
{
    auto* list = new QComboBox;
    list->setObjectName(QStringLiteral("roleOfColumn%1").arg(column + 1));
    list->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    list->addItem(QString());
    for (const std::string_view role : columnRoles)
        list->addItem(QString(), qString(role));
    connect(list, &QComboBox::activated, this, &ColumnPreview::report);
    setCellWidget(0, column, list);
    m_lists.push_back(list);
}

void ColumnPreview::choose(const std::vector<ColumnMapping>& columns)
{
    for (std::size_t n = 0; n < m_lists.size(); ++n) {
        const auto mapped =
            std::ranges::find(columns, std::to_string(n + 1), &ColumnMapping::column);
        m_lists[n]->setCurrentIndex(
            mapped == columns.end() ? 0 : m_lists[n]->findData(qString(mapped->role)));
    }
}

void ColumnPreview::report()
{
    std::vector<ColumnMapping> columns;
    for (std::size_t n = 0; n < m_lists.size(); ++n) {
        const QString role = m_lists[n]->currentData().toString();
        if (!role.isEmpty())
            columns.push_back({role.toStdString(), std::to_string(n + 1)});
    }
    Q_EMIT mappingChosen(columns);
}

void ColumnPreview::retranslate()
{
    setAccessibleName(tr("Columns of the file"));
    for (std::size_t n = 0; n < m_lists.size(); ++n) {
        QComboBox* list = m_lists[n];
        list->setItemText(0, tr("by its name"));
        for (std::size_t role = 0; role < columnRoles.size(); ++role)
            list->setItemText(static_cast<int>(role) + 1, roleText(columnRoles.at(role).data()));
        list->setAccessibleName(tr("What column %1 is").arg(n + 1));
        list->setToolTip(tr("What this column is. Once one is chosen, only chosen columns are "
                            "read; until then the names of the columns say it."));
        list->setAccessibleDescription(list->toolTip());
    }
    horizontalHeader()->resizeSections(QHeaderView::ResizeToContents);
}

} // namespace axiscomp::ui
