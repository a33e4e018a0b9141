// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/problem_list.h"

#include "ui/data/problem_model.h"
#include "ui/style/plain_label.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeView>

#include <algorithm>

namespace axiscomp::ui {

ProblemList::ProblemList(QWidget* parent, About about)
    : QWidget(parent)
    , m_about(about)
    , m_title(new PlainLabel)
    , m_useDimensions(new QPushButton)
    , m_model(new ProblemModel(this))
    , m_list(new QTreeView)
{
    setObjectName(QStringLiteral("problemList"));
    build();
    connect(m_list, &QTreeView::clicked, this, &ProblemList::open);
    connect(m_list, &QTreeView::activated, this, &ProblemList::open);
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
    m_list->setModel(m_model);
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
    if (m_path == file.problemsPath && m_model->problems() == file.problems
        && m_suppressed == file.suppressedProblems && m_fullGrid == file.fullGrid)
        return false;
    m_path = file.problemsPath;
    m_suppressed = file.suppressedProblems;
    m_fullGrid = file.fullGrid;
    m_model->setProblems(file.problems);
    showSummary();
    return true;
}

void ProblemList::retranslate()
{
    m_list->setAccessibleName(tr("Problems of the file"));
    m_list->setAccessibleDescription(
        tr("Click a problem, or press Enter, to see the file's line."));
    m_list->setToolTip(m_list->accessibleDescription());
    m_model->retranslate();
    showSummary();
}

void ProblemList::showSummary()
{
    const QString name = QFileInfo(m_path).fileName();
    const bool hasErrors =
        std::ranges::count(m_model->problems(), Severity::Error, &Diagnostic::severity) > 0;
    const QString refusal = m_about == About::Table
        ? tr("%1 cannot be used; the previous selection is kept.")
        : tr("%1 cannot be used.");
    QString title = (hasErrors ? refusal : tr("%1 is used, with these warnings.")).arg(name);
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
    if (m_list->currentIndex().isValid())
        Q_EMIT opened(m_path, m_model->place(m_list->currentIndex().row()));
}

void ProblemList::step(int step)
{
    const int count = m_model->rowCount();
    if (count == 0)
        return;
    const int row = m_list->currentIndex().row(); // -1: none
    m_list->setCurrentIndex(m_model->index((row + step + count) % count, ProblemModel::Line));
    open();
}

} // namespace axiscomp::ui
