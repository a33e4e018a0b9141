// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/problem_list.h"

#include "ui/contrast.h"
#include "ui/symbols.h"
#include "ui/value_text.h"
#include "ui/wizard_controller.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>

#include <algorithm>

namespace axiscomp::ui {

namespace {

enum Column { Line, ColumnOfFile, Sentence, ColumnCount };

QString placeText(std::size_t number)
{
    return number == 0 ? QStringLiteral("–") : countText(number);
}

} // namespace

ProblemList::ProblemList(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel)
    , m_list(new QTreeWidget)
{
    setObjectName(QStringLiteral("problemList"));
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
    layout->addWidget(m_title);
    layout->addWidget(m_list, 1);
    const auto choose = [this](QTreeWidgetItem* item) {
        const auto row = static_cast<std::size_t>(m_list->indexOfTopLevelItem(item));
        if (row < m_problems.size())
            Q_EMIT problemChosen(m_problems[row].line, m_problems[row].column);
    };
    connect(m_list, &QTreeWidget::itemClicked, this, choose);
    connect(m_list, &QTreeWidget::itemActivated, this, choose);
    retranslate();
}

void ProblemList::setProblems(
    const QString& fileName, const std::vector<Diagnostic>& problems, std::size_t suppressed)
{
    if (m_fileName == fileName && m_problems == problems && m_suppressed == suppressed)
        return;
    m_fileName = fileName;
    m_problems = problems;
    m_suppressed = suppressed;
    fill();
}

void ProblemList::retranslate()
{
    m_list->setHeaderLabels({tr("Line"), tr("Column"), tr("Problem")});
    m_list->setAccessibleName(tr("Problems of the file"));
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
        item->setToolTip(Sentence, item->text(Sentence));
    }
    const auto errors = std::ranges::count(m_problems, Severity::Error, &Diagnostic::severity);
    QString title = errors > 0
        ? tr("%1 is not used as it is. The table chosen before stays chosen.").arg(m_fileName)
        : tr("%1 is used; these places are odd.").arg(m_fileName);
    if (m_suppressed > 0)
        title += u' ' + tr("Further problems: %1.").arg(countText(m_suppressed));
    m_title->setText(title);
}

} // namespace axiscomp::ui
