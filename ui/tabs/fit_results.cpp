// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/fit_results.h"

#include "core/table/lookup.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/text/fine_scale.h"
#include "ui/text/message_text.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QEvent>
#include <QHeaderView>
#include <QListWidget>
#include <QScrollBar>
#include <QSplitter>
#include <QTableWidget>

#include <algorithm>

namespace axiscomp::ui {

namespace {

enum Column { Figure, Before, Predicted, Left, ColumnCount };

QString capital(QString text)
{
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text;
}

} // namespace

QString largestCorrection(const LoadedTable& table, bool isAngular)
{
    const auto position = positionOf(table.table->grid, table.largestElement);
    QStringList places;
    for (std::size_t n = 0; n < position.size(); ++n)
        places += qString(table.table->grid.axes[n].name) + u' '
            + translated(placeOf(position[n], isAngular));
    const double value = static_cast<double>(table.table->values[table.largestElement]);
    return FitResults::tr("Largest correction: %1 at %2.")
        .arg(fineText(value, isAngular), listText(places));
}

FitResults::FitResults(QWidget* parent)
    : QWidget(parent)
    , m_figures(new QTableWidget)
    , m_remarks(new QListWidget)
    , m_sign(new PlainLabel)
{
    m_sign->setObjectName(QStringLiteral("fitSign"));
    m_sign->setWordWrap(true);
    m_sign->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_figures->setObjectName(QStringLiteral("fitFigures"));
    m_figures->setColumnCount(ColumnCount);
    m_figures->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_figures->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_figures->setAlternatingRowColors(true);
    m_figures->setShowGrid(false);
    m_figures->setTabKeyNavigation(false);
    m_figures->setWordWrap(false);
    m_figures->verticalHeader()->hide();
    m_figures->verticalHeader()->setDefaultSectionSize(m_figures->fontMetrics().height() + 4);
    m_figures->horizontalHeader()->setHighlightSections(false);
    m_figures->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_figures->horizontalHeader()->setStretchLastSection(true);
    m_remarks->setObjectName(QStringLiteral("fitRemarks"));
    m_remarks->setWordWrap(true);
    m_remarks->setAlternatingRowColors(true);
    m_remarks->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_remarks->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_remarks->setResizeMode(QListView::Adjust);
    auto* columns = new QSplitter(Qt::Horizontal);
    columns->setObjectName(QStringLiteral("fitResultColumns"));
    columns->setChildrenCollapsible(false);
    columns->addWidget(m_figures);
    columns->addWidget(m_remarks);
    columns->setStretchFactor(0, 0);
    columns->setStretchFactor(1, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_sign);
    layout->addWidget(columns, 1);
}

void FitResults::show(std::shared_ptr<const FitOutcome> outcome, std::size_t table)
{
    m_outcome = std::move(outcome);
    m_table = table;
    fill();
}

void FitResults::setOutdated(bool isOutdated)
{
    if (isOutdated == m_isOutdated)
        return;
    m_isOutdated = isOutdated;
    for (QWidget* part : std::initializer_list<QWidget*>{m_figures, m_remarks, m_sign})
        part->setEnabled(!isOutdated);
}

std::vector<FitResults::Row> FitResults::rows() const
{
    const FitReport& report = *m_outcome->report;
    const FittedTable& made = report.tables[m_table];
    std::vector<Row> rows;
    const bool hasFigures = report.before && report.predicted;
    for (const Iso230Figure figure :
        hasFigures ? figuresInShort(*report.before) : std::vector<Iso230Figure>()) {
        Row row{capital(translated(figureText(figure))), (*report.before)[figure].value,
            (*report.predicted)[figure].value, std::nullopt, false};
        if (report.heldOut && figure == figureStandingFor(Iso230Figure::M, *report.before))
            row.heldOut = report.heldOut->range;
        rows.push_back(row);
    }
    Row rms{tr("What remains, rms"), std::nullopt, made.residualRms, made.crossValidation, true};
    Row largest{
        tr("What remains, largest"), std::nullopt, made.residualLargest, std::nullopt, true};
    if (report.heldOut) {
        rms.heldOut = report.heldOut->rms;
        largest.heldOut = report.heldOut->largest;
    }
    rows.push_back(rms);
    rows.push_back(largest);
    return rows;
}

void FitResults::fillFigures()
{
    m_figures->setRowCount(0);
    m_figures->horizontalHeader()->setVisible(m_outcome != nullptr);
    if (!m_outcome)
        return;
    const auto all = rows();
    std::vector<std::optional<double>> shown;
    for (const Row& row : all)
        for (const auto& value : {row.before, row.predicted, row.heldOut})
            if (!row.hasOwnUnits)
                shown.push_back(value);
    const FineScale scale(fineUnit(shown, m_outcome->request.measurement->isAngular));
    m_figures->setHorizontalHeaderLabels({tr("Figure [%1]").arg(scale.symbol()), tr("Before"),
        tr("At the targets"), tr("Held out")});
    m_figures->setRowCount(static_cast<int>(all.size()));
    for (int n = 0; n < m_figures->rowCount(); ++n)
        fillRow(n, all[static_cast<std::size_t>(n)], scale);
    // All columns are in sight.
    m_figures->horizontalHeader()->setStretchLastSection(false);
    m_figures->resizeColumnsToContents();
    m_figures->setMinimumWidth(m_figures->horizontalHeader()->length() + 2 * m_figures->frameWidth()
        + m_figures->verticalScrollBar()->sizeHint().width() + 2);
    m_figures->horizontalHeader()->setStretchLastSection(true);
}

void FitResults::fillRow(int n, const Row& row, const FineScale& scale)
{
    const bool isAngular = m_outcome->request.measurement->isAngular;
    m_figures->setItem(n, Figure, new QTableWidgetItem(row.name));
    int column = Before;
    for (const auto& value : {row.before, row.predicted, row.heldOut}) {
        auto* item = new QTableWidgetItem;
        if (value) {
            const QString whole =
                row.hasOwnUnits ? fineText(*value, isAngular) : scale.textWithUnit(*value);
            item->setText(row.hasOwnUnits ? whole : scale.text(*value));
            item->setData(Qt::AccessibleTextRole,
                QStringLiteral("%1, %2: %3")
                    .arg(row.name, m_figures->horizontalHeaderItem(column)->text(), whole));
        }
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_figures->setItem(n, column++, item);
    }
}

void FitResults::addRemark(const QString& sentence, bool isWarning)
{
    auto* item = new QListWidgetItem(sentence, m_remarks);
    const Tone tone = isWarning ? Tone::Warning : Tone::Information;
    constexpr int size = 16;
    item->setIcon(QIcon(symbolPixmap(isWarning ? Symbol::Warning : Symbol::Information,
        frameColor(tone, palette()), size, devicePixelRatioF())));
    item->setToolTip(sentence);
    item->setData(Qt::AccessibleTextRole, isWarning ? tr("Warning: %1").arg(sentence) : sentence);
}

void FitResults::fillRemarks()
{
    m_remarks->clear();
    if (!m_outcome)
        return;
    const bool isAngular = m_outcome->request.measurement->isAngular;
    for (const Verdict& verdict : m_outcome->report->verdicts) {
        const auto shown = comparedTexts(verdict, isAngular);
        QString value = verdict.value ? shown.value : tr("not defined");
        if (verdict.heldOut) {
            const ComparedDigits heldOut =
                heldOutDigits(verdict, isAngular, FineScale::usualDecimals);
            value =
                tr("%1, held out %2")
                    .arg(value,
                        FineScale(heldOut.value).textWithUnit(*verdict.heldOut, heldOut.decimals));
        }
        addRemark(tr("%1: foretold %2, tolerance %3: %4.")
                      .arg(capital(translated(figureText(verdict.tolerance.figure))), value,
                          shown.limit, translated(verdictText(verdict.result))),
            verdict.result != VerdictResult::Passed);
    }
    const auto addRemarks = [this](bool areWarnings) {
        for (const FitRemark& remark : m_outcome->report->remarks)
            if (remark.isWarning == areWarnings)
                addRemark(sentenceText(remark.text), areWarnings);
    };
    addRemarks(true);
    for (const QString& line : basis())
        addRemark(line, false);
    addRemarks(false);
    for (const Text& remark : m_outcome->remarks)
        addRemark(sentenceText(remark), false);
}

/// What the figures rest on.
QStringList FitResults::basis() const
{
    const Measurement& measurement = *m_outcome->request.measurement;
    const FitReport& report = *m_outcome->report;
    const FittedTable& made = report.tables[m_table];
    QStringList lines;
    lines += largestCorrection(m_outcome->tables[m_table], measurement.isAngular);
    lines += tr("Table %1: %2; CRC %3.")
                 .arg(qString(made.table.name), gridText(made.table.grid))
                 .arg(m_outcome->crcs[m_table], 8, 16, QLatin1Char('0'));
    lines += sentenceText(report.state.text);
    lines += report.lookupAt == LookupAt::Encoder
        ? tr("Looked up at the encoder's position, before the compensation.")
        : tr("Looked up at the set position, after the compensation.");
    if (made.smoothness)
        lines += tr("Smoothness %1.").arg(numberText(*made.smoothness));
    if (made.filledNodes > 0)
        lines += tr("Points of the grid that were filled: %1 of %2.")
                     .arg(countText(made.filledNodes), countText(made.table.values.size()));
    if (report.heldOut)
        lines += tr("Held out: each target foretold without it, which is the one to believe "
                    "between the targets.");
    return lines;
}

void FitResults::fill()
{
    fillFigures();
    fillRemarks();
    m_sign->setText(m_outcome ? sentenceText(m_outcome->report->sign) : QString());
}

void FitResults::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        fillRemarks();
}

void FitResults::retranslate()
{
    m_figures->setAccessibleName(tr("Figures before and foretold"));
    m_remarks->setAccessibleName(tr("Before the table is used"));
    fill();
}

} // namespace axiscomp::ui
