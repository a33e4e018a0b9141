// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/record_bar.h"

#include "ui/record/record_file.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"

#include <QBoxLayout>
#include <QEvent>
#include <QToolButton>

namespace axiscomp::ui {

namespace {

constexpr int shownCharacters = 28;

QToolButton* barButton(const char* name, Symbol symbol)
{
    auto* button = new QToolButton;
    button->setObjectName(QLatin1StringView(name));
    button->setIcon(symbolIcon(symbol));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

void describe(QToolButton& button, const QString& text, const QString& description)
{
    button.setText(text);
    button.setToolTip(description);
    button.setAccessibleDescription(description);
}

} // namespace

RecordBar::RecordBar(const RecordFile& file, QWidget* parent)
    : QWidget(parent)
    , m_file(file)
    , m_title(new PlainLabel)
    , m_name(new PlainLabel)
    , m_open(barButton("openRecord", Symbol::Open))
    , m_save(barButton("saveRecord", Symbol::Save))
    , m_report(barButton("reportRecord", Symbol::Log))
{
    setObjectName(QStringLiteral("recordBar"));
    m_name->setObjectName(QStringLiteral("recordName"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_title);
    layout->addWidget(m_name);
    layout->addSpacing(4);
    for (QToolButton* button : {m_open, m_save, m_report})
        layout->addWidget(button);
    connect(m_open, &QToolButton::clicked, this, &RecordBar::openRequested);
    connect(m_save, &QToolButton::clicked, this, &RecordBar::saveRequested);
    connect(m_report, &QToolButton::clicked, this, &RecordBar::reportRequested);
    connect(&file, &RecordFile::changed, this, &RecordBar::follow);
    retranslate();
}

void RecordBar::retranslate()
{
    m_title->setText(tr("Record:"));
    describe(*m_open, tr("Open…"),
        tr("Open a record (.axcal); it can also be dropped on the window (Ctrl+Alt+O)"));
    describe(*m_save, tr("Save"),
        tr("Save measurement, table, what it promised and what came of it (Ctrl+S)"));
    describe(*m_report, tr("Report…"), tr("The report of the record as PDF or HTML (Ctrl+P)"));
    m_open->setAccessibleName(tr("Open record"));
    m_save->setAccessibleName(tr("Save record"));
    m_report->setAccessibleName(tr("Report of the record"));
    follow();
}

void RecordBar::follow()
{
    const bool isUnsaved = m_file.isModified() && !m_file.isEmpty();
    const int width = shownCharacters * fontMetrics().averageCharWidth();
    const QString name = m_file.isEmpty() ? tr("none") : m_file.name();
    m_name->setText(fontMetrics().elidedText(name, Qt::ElideMiddle, width)
        + (isUnsaved ? QStringLiteral("*") : QString()));
    const QString state =
        isUnsaved ? tr("It has changes that are not saved.") : tr("There are no unsaved changes.");
    m_name->setToolTip(m_file.path().isEmpty() ? state : m_file.path() + u'\n' + state);
    m_name->setAccessibleName(tr("Record %1").arg(name));
    m_name->setAccessibleDescription(state);
    m_open->setEnabled(!m_file.isBusy());
    m_save->setEnabled(isUnsaved && !m_file.isBusy());
    m_report->setEnabled(!m_file.isEmpty() && !m_file.isBusy());
}

void RecordBar::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::FontChange)
        follow();
    QWidget::changeEvent(event);
}

} // namespace axiscomp::ui
