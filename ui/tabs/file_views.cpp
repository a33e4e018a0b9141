// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/file_views.h"

#include "ui/controller/wizard_settings.h"
#include "ui/page/file_lines_view.h"
#include "ui/page/problem_list.h"
#include "ui/record/record_state.h"
#include "ui/tabs/column_preview.h"
#include "ui/tabs/column_proposal.h"
#include "ui/tabs/file_facts.h"
#include "ui/tabs/widget_names.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QStackedWidget>
#include <QTabBar>

namespace axiscomp::ui {

FileViews::FileViews(const QString& prefix, QWidget* parent)
    : QTabWidget(parent)
    , m_facts(new FileFacts)
    , m_proposal(new ColumnProposal)
    , m_columns(new ColumnPreview)
    , m_columnsPage(buildColumns())
    , m_problemStack(new QStackedWidget)
    , m_problems(new ProblemList(nullptr, ProblemList::About::Measurement))
    , m_lines(new FileLinesView)
{
    m_problemStack->addWidget(m_problems);
    m_problemStack->addWidget(m_lines);
    addTab(m_facts, QString());
    addTab(m_columnsPage, QString());
    addTab(m_problemStack, QString());
    prefixNames(prefix, *this);
    connect(m_columns, &ColumnPreview::mappingChosen, this, &FileViews::choose);
    connect(m_columns, &ColumnPreview::previewed, this, &FileViews::propose);
    connect(m_proposal, &ColumnProposal::taken, this, [this] { choose(m_proposal->proposed()); });
    connect(m_problems, &ProblemList::opened, this,
        [this](const QString& path, const ProblemPlace& place) {
            m_lines->showProblem(path, place);
            m_problemStack->setCurrentWidget(m_lines);
        });
    connect(m_lines, &FileLinesView::stepRequested, m_problems, &ProblemList::step);
    connect(m_lines, &FileLinesView::closeRequested, this,
        [this] { m_problemStack->setCurrentWidget(m_problems); });
    retranslate();
}

void FileViews::retranslate()
{
    setTabText(indexOf(m_facts), tr("What the file says"));
    setTabText(indexOf(m_columnsPage), tr("Columns"));
    tabBar()->setAccessibleName(tr("Views of the file"));
    m_facts->retranslate();
    m_columns->retranslate();
    m_proposal->retranslate();
    m_problems->retranslate();
    m_lines->retranslate();
}

QWidget* FileViews::buildColumns()
{
    auto* columns = new QWidget;
    auto* layout = new QVBoxLayout(columns);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_proposal);
    layout->addWidget(m_columns, 1);
    return columns;
}

void FileViews::remember(WizardSettings& settings)
{
    m_settings = &settings;
    propose();
}

void FileViews::choose(const std::vector<ColumnMapping>& columns)
{
    const QStringList header = m_columns->header();
    if (m_settings)
        m_settings->setColumnRoles(header, ColumnPreview::rolesOf(columns, header.size()));
    Q_EMIT mappingChosen(columns);
}

void FileViews::propose()
{
    const QStringList header = m_columns->header();
    if (!m_settings || m_file.path.isEmpty() || header.isEmpty())
        return m_proposal->propose({});
    const auto columns = ColumnPreview::mappingOf(m_settings->columnRoles(header));
    const bool isChosen = columns == m_file.choices.columns;
    m_proposal->propose(isChosen ? std::vector<ColumnMapping>() : columns);
}

void FileViews::show(const MeasurementFile& file, const ReadMeasurement* reading)
{
    m_file = file;
    m_columns->show(file.recorded ? QString() : file.path, file.choices);
    setTabVisible(indexOf(m_columnsPage), !file.recorded);
    propose();
    m_facts->show(reading);
    showProblems(reading);
}

void FileViews::showProblems(const ReadMeasurement* reading)
{
    DataFile file;
    if (reading && reading->reading) {
        file.problemsPath = reading->file.path;
        file.problems = reading->reading->diagnostics;
        file.suppressedProblems = reading->reading->suppressed;
    } else if (reading && reading->refusal) {
        file.problemsPath = reading->file.path;
        file.problems.push_back(
            {Severity::Error, DiagnosticCode::IoError, 0, 0, textOf(*reading->refusal), {}, {}});
    }
    const bool hasErrors = reading && reading->refusal;
    const std::size_t count = file.problems.size() + file.suppressedProblems;
    setTabText(indexOf(m_problemStack), tr("Problems (%1)").arg(countText(count)));
    setTabVisible(indexOf(m_problemStack), count > 0);
    if (!m_problems->setProblems(file))
        return;
    m_problemStack->setCurrentWidget(m_problems);
    // Who gives the columns their roles sees the problems come and go.
    if (hasErrors && currentWidget() != m_columnsPage)
        setCurrentWidget(m_problemStack);
}

} // namespace axiscomp::ui
