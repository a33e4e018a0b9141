// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/problem_list.h"

#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include <algorithm>

namespace axiscomp::ui {

namespace {

enum Column { Line, ColumnOfFile, Statement, ColumnCount };

QString placeText(std::size_t number)
{
    return number == 0 ? QStringLiteral("–") : countText(number);
}

} // namespace

ProblemList::ProblemList(QWidget* parent)
    : QWidget(parent)
    , m_title(new PlainLabel)
    , m_useDimensions(new QPushButton)
    , m_list(new QTreeWidget)
{
    setObjectName(QStringLiteral("problemList"));
    build();
    connect(m_list, &QTreeWidget::itemClicked, this, &ProblemList::open);
    connect(m_list, &QTreeWidget::itemActivated, this, &ProblemList::open);
    connect(m_useDimensions, &QPushButton::clicked, this, [this] {
        if (m_fullGrid)
            Q_EMIT dimensionsChosen(m_path, m_fullGrid->dimensions);
    });
    retranslate();
}

void ProblemList::build()
{
    m_title->setObjectName(QStringLiteral("problemTitle"));
    m_title->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("problems"));
    m_list->setColumnCount(ColumnCount);
    m_list->setRootIsDecorated(false);
    m_list->setAlternatingRowColors(true);
    m_list->setWordWrap(true);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 0);
    m_useDimensions->setObjectName(QStringLiteral("useDimensions"));
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_useDimensions);
    layout->addLayout(head);
    layout->addWidget(m_list, 1);
}

bool ProblemList::setProblems(const DataFile& file)
{
    if (m_path == file.problemsPath && m_problems == file.problems
        && m_suppressed == file.suppressedProblems && m_fullGrid == file.fullGrid)
        return false;
    m_path = file.problemsPath;
    m_problems = file.problems;
    m_suppressed = file.suppressedProblems;
    m_fullGrid = file.fullGrid;
    fill();
    return true;
}

void ProblemList::retranslate()
{
    m_list->setHeaderLabels({tr("Line"), tr("Column"), tr("Problem")});
    m_list->setAccessibleName(tr("Problems of the file"));
    m_list->setAccessibleDescription(
        tr("Click a problem, or press Enter, to see the file's line."));
    m_list->setToolTip(m_list->accessibleDescription());
    fill();
}

void ProblemList::fill()
{
    m_list->clear();
    constexpr int size = 14;
    for (const Diagnostic& problem : m_problems) {
        const bool isError = problem.severity == Severity::Error;
        const Tone tone = isError ? Tone::Error : Tone::Warning;
        auto* item = new QTreeWidgetItem(
            m_list, {placeText(problem.line), placeText(problem.column), problemText(problem)});
        item->setIcon(Line,
            symbolPixmap(isError ? Symbol::Error : Symbol::Warning, frameColor(tone, palette()),
                size, devicePixelRatioF()));
        item->setData(Line, Qt::AccessibleTextRole,
            (isError ? tr("error, line %1") : tr("warning, line %1")).arg(placeText(problem.line)));
        item->setToolTip(Statement, item->text(Statement));
    }
    const QString name = QFileInfo(m_path).fileName();
    const bool hasErrors =
        std::ranges::count(m_problems, Severity::Error, &Diagnostic::severity) > 0;
    QString title = hasErrors ? tr("%1 cannot be used; the previous selection is kept.").arg(name)
                              : tr("%1 is used, with these warnings.").arg(name);
    if (m_suppressed > 0)
        title += u' ' + tr("Further problems: %1.").arg(countText(m_suppressed));
    m_title->setText(title);
    m_useDimensions->setVisible(m_fullGrid.has_value());
    if (!m_fullGrid)
        return;
    m_useDimensions->setText(tr("&Use %1D").arg(m_fullGrid->dimensions));
    m_useDimensions->setToolTip(
        tr("Sets the dimensionality to %1D and reads the file again.").arg(m_fullGrid->dimensions));
    m_useDimensions->setAccessibleDescription(m_useDimensions->toolTip());
}

void ProblemList::open()
{
    const auto row = static_cast<std::size_t>(m_list->indexOfTopLevelItem(m_list->currentItem()));
    if (row >= m_problems.size())
        return;
    const Diagnostic& problem = m_problems[row];
    Q_EMIT opened(m_path,
        {problem.line, problem.column, problem.severity == Severity::Error, problemText(problem)});
}

void ProblemList::step(int step)
{
    const int count = m_list->topLevelItemCount();
    if (count == 0)
        return;
    const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
    m_list->setCurrentItem(m_list->topLevelItem((row + step + count) % count));
    open();
}

} // namespace axiscomp::ui
