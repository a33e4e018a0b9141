// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/conversion_dialog.h"

#include "ui/dialogs/setting_fields.h"
#include "ui/style/busy_mark.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/text/message_text.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>

#include <utility>

namespace axiscomp::ui {

ConversionDialog::ConversionDialog(ConversionForm::Purpose purpose, QWidget* parent)
    : QDialog(parent)
    , m_form(new ConversionForm(purpose))
    , m_introduction(new PlainLabel)
    , m_reportTitle(new PlainLabel)
    , m_report(new QPlainTextEdit)
    , m_busy(new BusyMark)
    , m_reason(new ToneLabel)
    , m_buttons(new QDialogButtonBox)
    , m_accept(m_buttons->addButton(QDialogButtonBox::Ok))
    , m_cancel(m_buttons->addButton(QDialogButtonBox::Cancel))
{
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(m_form, &ConversionForm::changed, this, &ConversionDialog::takeChange);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

ConversionDialog::~ConversionDialog() = default;

void ConversionDialog::build()
{
    m_introduction->setObjectName(QStringLiteral("conversionIntroduction"));
    m_introduction->setWordWrap(true);
    m_report->setObjectName(QStringLiteral("conversionReport"));
    m_report->setReadOnly(true);
    m_report->setTabChangesFocus(true);
    m_report->setMinimumHeight(80);
    m_reportTitle->setBuddy(m_report);
    m_reason->setObjectName(QStringLiteral("conversionReason"));
    m_reason->setWordWrap(true);
    m_reason->setTone(Tone::Error);
    m_reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_buttons->setObjectName(QStringLiteral("conversionButtons"));
    m_accept->setObjectName(QStringLiteral("acceptConversion"));
    m_cancel->setObjectName(QStringLiteral("cancelConversion"));
    auto* heading = new QHBoxLayout;
    heading->addWidget(m_reportTitle);
    heading->addWidget(m_busy);
    heading->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_introduction);
    layout->addWidget(m_form);
    layout->addLayout(heading);
    layout->addWidget(m_report, 1);
    layout->addWidget(m_reason);
    layout->addWidget(m_buttons);
    resize(760, 600);
}

void ConversionDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

void ConversionDialog::retranslate()
{
    const Words said = words();
    setWindowTitle(said.title);
    m_introduction->setText(said.introduction);
    m_accept->setText(said.accept);
    m_accept->setAccessibleDescription(said.acceptMeaning);
    m_cancel->setText(tr("&Cancel"));
    m_cancel->setToolTip(tr("Change nothing (Esc)"));
    m_cancel->setAccessibleDescription(m_cancel->toolTip());
    m_reportTitle->setText(tr("&Result"));
    m_report->setAccessibleName(tr("Result"));
    m_report->setToolTip(tr("What the conversion does to the numbers, with an example"));
    m_report->setAccessibleDescription(m_report->toolTip());
    m_form->retranslate(
        {keyOf(said.accept), keyOf(m_cancel->text()), keyOf(m_reportTitle->text())});
    takeChange();
}

void ConversionDialog::takeChange()
{
    const QString problem = m_form->problem();
    if (problem.isEmpty())
        return startComputing();
    m_isComputing = false; // what still comes is of other choices
    m_reasonText = problem;
    m_lines.clear();
    showState();
}

void ConversionDialog::startComputing()
{
    m_isComputing = true;
    m_reasonText.clear();
    showState();
    compute();
}

void ConversionDialog::showReport(const std::vector<Text>& lines)
{
    if (!std::exchange(m_isComputing, false))
        return;
    m_reasonText.clear();
    m_lines = lines;
    showState();
}

void ConversionDialog::showReason(const QString& reason)
{
    if (!std::exchange(m_isComputing, false))
        return;
    m_reasonText = reason;
    m_lines.clear();
    showState();
}

void ConversionDialog::showState()
{
    m_busy->setBusy(m_isComputing);
    QStringList lines;
    for (const Text& line : m_lines)
        lines += sentenceText(line);
    if (m_report->toPlainText() != lines.join(u'\n'))
        m_report->setPlainText(lines.join(u'\n'));
    m_reason->setText(m_reasonText);
    m_reason->setVisible(!m_reasonText.isEmpty());
    m_accept->setEnabled(!m_isComputing && m_reasonText.isEmpty());
    m_accept->setToolTip(!m_reasonText.isEmpty() ? m_reasonText
            : m_isComputing                      ? tr("Computing …")
                                                 : words().acceptMeaning);
}

} // namespace axiscomp::ui
