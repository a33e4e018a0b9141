// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/values_view.h"

#include "core/table/lookup.h"
#include "ui/async/background_job.h"
#include "ui/data/table_view_model.h"
#include "ui/data/values_model.h"
#include "ui/drawing/table_map.h"
#include "ui/plot/slice_row.h"
#include "ui/plot/table_content_combo.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/text/value_text.h"

#include <QAction>
#include <QBoxLayout>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QToolButton>

#include <algorithm>

namespace axiscomp::ui {

namespace {

class Copier {
public:
    Copier(const CopiedTable& copied, const std::vector<CellRange>& ranges)
        : m_copied(copied)
        , m_table(copied.drawn)
        , m_ranges(ranges)
        , m_isMap(m_table.grid.dimensions() == 2)
    {
        for (const CellRange& range : ranges) {
            m_lastRow = std::max(m_lastRow, range.bottom);
            if (m_columns.size() <= static_cast<std::size_t>(range.right))
                m_columns.resize(static_cast<std::size_t>(range.right) + 1);
            std::fill(m_columns.begin() + range.left, m_columns.begin() + range.right + 1, true);
        }
    }

    QByteArray text(const CopyHeaders* headers)
    {
        m_hasHeaders = headers != nullptr;
        // Positions stand on the left anyway then.
        if (m_hasHeaders && !m_isMap && !m_columns.empty())
            m_columns[ValuesModel::Position] = false;
        if (headers)
            addHeaders(*headers);
        for (int row = 0; row <= m_lastRow; ++row)
            addRow(row);
        return m_text;
    }

private:
    void addHeaders(const CopyHeaders& headers)
    {
        const QStringList names = QStringList{headers.second} + headers.more;
        m_text += (m_isMap ? headers.second + QStringLiteral(" \\ ") : QString()).toUtf8();
        m_text += headers.first.toUtf8();
        for (std::size_t column = ValuesModel::Value; !m_isMap && column < m_columns.size();
             ++column) {
            if (m_columns[column])
                m_text += '\t' + names.value(qsizetype(column) - ValuesModel::Value).toUtf8();
        }
        for (std::size_t column = 0; m_isMap && column < m_columns.size(); ++column) {
            if (m_columns[column])
                m_text += '\t' + plainPosition(m_table.grid.axes[0], column);
        }
        m_text += '\n';
    }

    void addRow(int row)
    {
        m_inRow.clear();
        std::ranges::copy_if(m_ranges, std::back_inserter(m_inRow),
            [row](const CellRange& range) { return range.top <= row && row <= range.bottom; });
        if (m_inRow.empty())
            return;
        bool isFirst = !m_hasHeaders;
        if (m_hasHeaders)
            m_text += plainPosition(m_table.grid.axes[m_isMap ? 1 : 0], std::size_t(row));
        for (std::size_t column = 0; column < m_columns.size(); ++column) {
            if (!m_columns[column])
                continue;
            if (!isFirst)
                m_text += '\t';
            isFirst = false;
            const int at = static_cast<int>(column);
            if (std::ranges::any_of(m_inRow,
                    [at](const CellRange& range) { return range.left <= at && at <= range.right; }))
                m_text += cell(static_cast<std::size_t>(row), column);
        }
        m_text += '\n';
    }

    [[nodiscard]] QByteArray cell(std::size_t row, std::size_t column) const
    {
        const ValueScale& scale = m_copied.scale;
        if (m_isMap)
            return scale.plain(m_table.values[row * m_table.grid.axes[0].size + column]);
        if (column == ValuesModel::Position)
            return plainPosition(m_table.grid.axes[0], row);
        const float value = m_table.values[row];
        if (column == ValuesModel::Value)
            return scale.plain(value);
        const auto onDrive =
            static_cast<float>(Lookup(*m_copied.onDrive).at(m_table.grid.axes[0].position(row)));
        return scale.plain(column == ValuesModel::OnDrive ? onDrive : value - onDrive);
    }

    const CopiedTable& m_copied;
    const CompensationTable& m_table;
    const std::vector<CellRange>& m_ranges;
    bool m_isMap;
    bool m_hasHeaders = false;
    int m_lastRow = -1;
    std::vector<bool> m_columns; ///< those of which a cell is chosen
    std::vector<CellRange> m_inRow;
    QByteArray m_text;
};

/// Cells in the colour that their value has in the map.
class ColoredCells : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        const QVariant share = index.data(ValuesModel::ShareRole);
        if (!share.isValid())
            return;
        const bool isDark = option->palette.color(QPalette::Base).lightness() < 128;
        const QColor cell =
            (isDark ? m_dark : m_light).color(share.toDouble(), QCPRange(-1.0, 1.0));
        option->backgroundBrush = cell;
        const bool isBlackBetter = contrastRatio(Qt::black, cell) >= contrastRatio(Qt::white, cell);
        option->palette.setColor(QPalette::Text, isBlackBetter ? Qt::black : Qt::white);
    }

private:
    mutable QCPColorGradient m_light = divergingGradient(false);
    mutable QCPColorGradient m_dark = divergingGradient(true);
};

std::vector<CellRange> rangesOf(const QItemSelection& selection)
{
    std::vector<CellRange> ranges;
    for (const QItemSelectionRange& range : selection)
        ranges.push_back({range.top(), range.left(), range.bottom(), range.right()});
    return ranges;
}

std::size_t cellCount(const std::vector<CellRange>& ranges)
{
    std::size_t count = 0;
    for (const CellRange& range : ranges)
        count += static_cast<std::size_t>(range.bottom - range.top + 1)
            * static_cast<std::size_t>(range.right - range.left + 1);
    return count;
}

} // namespace

QString copiedText(
    const CopiedTable& table, const std::vector<CellRange>& ranges, const CopyHeaders* headers)
{
    return QString::fromUtf8(Copier(table, ranges).text(headers));
}

ValuesView::ValuesView(TableViewModel& shown, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_model(new ValuesModel(shown, this))
    , m_contentBox(new TableContentCombo(shown))
    , m_layoutNote(new PlainLabel)
    , m_copyButton(new QToolButton)
    , m_table(new QTableView)
    , m_slice(new SliceRow(shown))
    , m_readout(new PlainLabel)
    , m_copy(new QAction(this))
    , m_copyWithPositions(new QAction(this))
    , m_selectAll(new QAction(this))
{
    setObjectName(QStringLiteral("valuesView"));
    build();
    connectView();
    retranslate();
    showTable();
}

void ValuesView::build()
{
    m_contentBox->setObjectName(QStringLiteral("valuesContent"));
    m_layoutNote->setObjectName(QStringLiteral("valuesLayout"));
    m_layoutNote->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_copyButton->setObjectName(QStringLiteral("copyValues"));
    m_copyButton->setIcon(symbolIcon(Symbol::Copy));
    m_copyButton->setAutoRaise(true);
    m_copyButton->setFocusPolicy(Qt::StrongFocus);
    m_table->setObjectName(QStringLiteral("values"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new ColoredCells(m_table));
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    // Rows and columns of one size each: none is ever asked how large it wants to be.
    const QFontMetrics metrics = m_table->fontMetrics();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(metrics.height() + 6);
    m_table->verticalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_table->horizontalHeader()->setDefaultSectionSize(
        metrics.horizontalAdvance(QStringLiteral("-0.0000000000")) + 12);
    m_readout->setObjectName(QStringLiteral("valuesReadout"));
    m_readout->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* top = new QHBoxLayout;
    top->addWidget(m_contentBox);
    top->addWidget(m_layoutNote, 1);
    top->addWidget(m_copyButton);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addLayout(top);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_slice);
    layout->addWidget(m_readout);
}

void ValuesView::connectView()
{
    m_copy->setShortcut(QKeySequence::Copy);
    m_copyWithPositions->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C));
    m_selectAll->setShortcut(QKeySequence::SelectAll);
    for (QAction* action : {m_copy, m_copyWithPositions, m_selectAll}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        m_table->addAction(action);
    }
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(m_copy, &QAction::triggered, this, [this] { copy(false); });
    connect(m_copyWithPositions, &QAction::triggered, this, [this] { copy(true); });
    connect(m_selectAll, &QAction::triggered, m_table, &QTableView::selectAll);
    connect(m_copyButton, &QToolButton::clicked, this, [this] {
        if (!m_table->selectionModel()->hasSelection())
            m_table->selectAll();
        copy(true);
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
        [this](const QModelIndex& index) {
            if (index.isValid())
                m_shown.setCurrent(m_model->pointOf(index));
        });
    connect(&m_shown, &TableViewModel::changed, this, &ValuesView::showTable);
    connect(&m_shown, &TableViewModel::currentChanged, this, &ValuesView::showCurrent);
}

void ValuesView::retranslate()
{
    m_contentBox->retranslate();
    m_slice->retranslate();
    m_model->retranslate();
    m_table->setAccessibleName(tr("Values of the table"));
    m_copy->setText(tr("Copy"));
    m_copyWithPositions->setText(tr("Copy With Positions"));
    m_selectAll->setText(tr("Select All"));
    m_copyButton->setToolTip(
        tr("Copy the selected values, or all of them, with their positions for a spreadsheet. "
           "Ctrl+C copies the selected values alone."));
    m_copyButton->setAccessibleName(tr("Copy values"));
    m_copyButton->setAccessibleDescription(m_copyButton->toolTip());
    showTable();
}

void ValuesView::showTable()
{
    const auto& table = m_shown.drawn();
    m_copyButton->setEnabled(table != nullptr);
    QString note;
    if (table && table->grid.dimensions() == 2)
        note = tr("%1 across, %2 down, %3")
                   .arg(withUnit(m_shown.nameOf(0), table->grid.axes[0].unit),
                       withUnit(m_shown.nameOf(1), table->grid.axes[1].unit),
                       m_model->columnName(ValuesModel::Value));
    // The two columns of a curve have names, which may need more room than numbers.
    auto* header = m_table->horizontalHeader();
    for (int column = 0; column < ValuesModel::ColumnCount; ++column) {
        if (column < m_model->columnCount())
            header->resizeSection(column,
                std::max(header->defaultSectionSize(),
                    note.isEmpty() ? header->sectionSizeHint(column) * 5 / 4 : 0));
    }
    m_layoutNote->setText(note);
    m_layoutNote->setToolTip(note);
    m_table->setAccessibleDescription(note.isEmpty() ? m_shown.description() : note);
    showCurrent();
}

void ValuesView::showCurrent()
{
    const std::optional<GridPoint>& current = m_shown.current();
    const QModelIndex index = m_table->currentIndex();
    if (current && (!index.isValid() || m_model->pointOf(index) != *current))
        m_table->setCurrentIndex(m_model->indexOf(*current));
    else if (!current && index.isValid())
        m_table->selectionModel()->clear();
    showReadout();
}

void ValuesView::showReadout()
{
    const QString text = m_shown.current() ? m_shown.pointText(*m_shown.current()) : QString();
    m_readout->setText(text);
    m_readout->setToolTip(text);
}

void ValuesView::copy(bool withPositions)
{
    auto ranges = rangesOf(m_table->selectionModel()->selection());
    const auto& table = m_shown.drawn();
    if (ranges.empty() || !table)
        return;
    const bool isMap = table->grid.dimensions() == 2;
    const CopyHeaders headers{withUnit(m_shown.nameOf(0), table->grid.axes[0].unit),
        isMap ? withUnit(m_shown.nameOf(1), table->grid.axes[1].unit)
              : m_model->columnName(ValuesModel::Value),
        {m_model->columnName(ValuesModel::OnDrive), m_model->columnName(ValuesModel::Change)}};
    const std::size_t count = cellCount(ranges);
    const auto text =
        inBackground<QString>([table, ranges = std::move(ranges), headers, withPositions,
                                  scale = m_shown.valueScale(), onDrive = m_shown.second()] {
            return copiedText(
                {*table, scale, onDrive.get()}, ranges, withPositions ? &headers : nullptr);
        });
    whenDone(text, this, [this, count](const QString& copied) {
        QGuiApplication::clipboard()->setText(copied);
        m_readout->setText(tr("Copied cells: %1").arg(countText(count)));
    });
}

} // namespace axiscomp::ui
