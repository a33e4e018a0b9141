// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/problem_list.h"

#include "ui/background.h"
#include "ui/contrast.h"
#include "ui/error_text.h"
#include "ui/future_handler.h"
#include "ui/symbols.h"
#include "ui/value_text.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QTextBlock>
#include <QTreeWidget>

#include <algorithm>

namespace axiscomp::ui {

namespace {

enum Column { Line, ColumnOfFile, Sentence, ColumnCount };
constexpr std::size_t neighbours = 2;

QString placeText(std::size_t number)
{
    return number == 0 ? QStringLiteral("–") : countText(number);
}

} // namespace

ProblemList::ProblemList(QWidget* parent)
    : QWidget(parent)
    , m_title(new QLabel)
    , m_list(new QTreeWidget)
    , m_excerpt(new QPlainTextEdit)
{
    setObjectName(QStringLiteral("problemList"));
    build();
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ProblemList::choose);
    connect(m_list, &QTreeWidget::itemActivated, this, &ProblemList::choose);
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
    m_excerpt->setObjectName(QStringLiteral("fileExcerpt"));
    m_excerpt->setReadOnly(true);
    m_excerpt->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_excerpt->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_excerpt->setTabChangesFocus(true);
    const int lines = static_cast<int>(2 * neighbours + 2);
    m_excerpt->setFixedHeight(
        lines * m_excerpt->fontMetrics().lineSpacing() + 2 * m_excerpt->frameWidth());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 0);
    layout->addWidget(m_title);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_excerpt);
}

void ProblemList::setProblems(
    const QString& path, const std::vector<Diagnostic>& problems, std::size_t suppressed)
{
    if (m_path == path && m_problems == problems && m_suppressed == suppressed)
        return;
    m_path = path;
    m_problems = problems;
    m_suppressed = suppressed;
    fill();
}

void ProblemList::retranslate()
{
    m_list->setHeaderLabels({tr("Line"), tr("Column"), tr("Problem")});
    m_list->setAccessibleName(tr("Problems of the file"));
    m_excerpt->setAccessibleName(tr("The file's lines at the chosen problem"));
    m_excerpt->setPlaceholderText(tr("Choose a problem to see the file's line."));
    fill();
}

void ProblemList::fill()
{
    m_list->clear();
    m_excerpt->clear();
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
    const QString name = QFileInfo(m_path).fileName();
    const bool hasErrors =
        std::ranges::count(m_problems, Severity::Error, &Diagnostic::severity) > 0;
    QString title = hasErrors
        ? tr("%1 is not used as it is; what was chosen before stays chosen.").arg(name)
        : tr("%1 is used; these places are odd.").arg(name);
    if (m_suppressed > 0)
        title += u' ' + tr("Further problems: %1.").arg(countText(m_suppressed));
    m_title->setText(title);
}

void ProblemList::choose()
{
    const auto row = static_cast<std::size_t>(m_list->indexOfTopLevelItem(m_list->currentItem()));
    if (row >= m_problems.size())
        return;
    const Diagnostic& problem = m_problems[row];
    ++m_request;
    const auto excerpt = inBackground<FileExcerpt>(
        [path = m_path, line = problem.line] { return excerptOf(path, line, neighbours); });
    whenDone(
        excerpt, this, [this, request = m_request, line = problem.line](const FileExcerpt& found) {
            if (request == m_request)
                showExcerpt(found, line);
        });
    Q_EMIT problemChosen(problem.line, problem.column);
}

void ProblemList::showExcerpt(const FileExcerpt& excerpt, std::size_t line)
{
    QStringList numbered;
    const auto width = static_cast<int>(
        QString::number(excerpt.firstLine + static_cast<std::size_t>(excerpt.lines.size())).size());
    for (qsizetype i = 0; i < excerpt.lines.size(); ++i)
        numbered += QStringLiteral("%1  %2")
                        .arg(excerpt.firstLine + static_cast<std::size_t>(i), width)
                        .arg(excerpt.lines[i]);
    m_excerpt->setPlainText(numbered.join(u'\n'));
    QTextEdit::ExtraSelection selection;
    selection.cursor = QTextCursor(
        m_excerpt->document()->findBlockByNumber(static_cast<int>(line - excerpt.firstLine)));
    selection.format.setBackground(fillColor(Tone::Error, palette()));
    selection.format.setProperty(QTextFormat::FullWidthSelection, true);
    m_excerpt->setExtraSelections({selection});
}

} // namespace axiscomp::ui
