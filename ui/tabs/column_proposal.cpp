// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/column_proposal.h"

#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/tabs/column_preview.h"

#include <QBoxLayout>
#include <QPushButton>

namespace axiscomp::ui {

ColumnProposal::ColumnProposal(QWidget* parent)
    : QWidget(parent)
    , m_symbol(new PlainLabel)
    , m_text(new PlainLabel)
    , m_take(new QPushButton)
{
    setObjectName(QStringLiteral("columnProposal"));
    m_text->setObjectName(QStringLiteral("columnProposalText"));
    m_text->setWordWrap(true);
    m_take->setObjectName(QStringLiteral("takeColumnsButton"));
    connect(m_take, &QPushButton::clicked, this, &ColumnProposal::taken);
    auto* layout = new QHBoxLayout(this);
    layout->addWidget(m_symbol, 0, Qt::AlignTop);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_take, 0, Qt::AlignTop);
    hide();
    retranslate();
}

void ColumnProposal::propose(const std::vector<ColumnMapping>& columns)
{
    m_columns = columns;
    retranslate();
    setVisible(!columns.empty());
}

void ColumnProposal::retranslate()
{
    constexpr int size = 16;
    m_symbol->setPixmap(symbolPixmap(
        Symbol::Information, frameColor(Tone::Information, palette()), size, devicePixelRatioF()));
    m_text->setText(tr("Proposed, as you chose it for the last file with these columns: %1.")
                        .arg(ColumnPreview::mappingText(m_columns)));
    m_take->setText(tr("Use T&hese"));
    m_take->setToolTip(tr("Read the columns of this file in the same way"));
    m_take->setAccessibleDescription(m_take->toolTip());
}

} // namespace axiscomp::ui
