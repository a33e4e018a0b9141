// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/field_row.h"

#include "ui/style/busy_mark.h"
#include "ui/style/contrast.h"
#include "ui/style/dirty_style.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/text/free_key.h"

#include <QAccessible>
#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

namespace axiscomp::ui {

namespace {

constexpr int fieldSymbolSize = 14;

/// A place to break a long path, as it has no blanks.
QString breakable(QString text)
{
    constexpr QChar zeroWidthSpace(0x200b);
    return text.replace(u'/', QString(u'/') + zeroWidthSpace);
}

QFont smallFont(const QWidget& widget)
{
    QFont font = widget.font();
    font.setPointSizeF(font.pointSizeF() * 0.88);
    return font;
}

QString objectNameOf(const QWidget& editor, QLatin1StringView part)
{
    return editor.objectName() + part;
}

} // namespace

FieldRow::FieldRow(QWidget* editor, QStyle* style, QWidget* parent)
    : QObject(parent)
    , m_editor(editor)
    , m_label(new PlainLabel(parent))
    , m_note(new PlainLabel)
    , m_noteSymbol(new PlainLabel)
    , m_noteLine(new QWidget(parent))
    , m_buttons(new QWidget(parent))
    , m_revert(new QToolButton)
    , m_current(new PlainLabel)
    , m_take(new QToolButton)
    , m_busy(new BusyMark)
{
    editor->setParent(parent);
    editor->setStyle(style);
    DirtyStyle::setDirty(*editor, false);
    editor->installEventFilter(this);
    if (auto* combo = qobject_cast<QComboBox*>(editor); combo && combo->isEditable())
        combo->lineEdit()->installEventFilter(this);
    m_label->setObjectName(objectNameOf(*editor, QLatin1StringView("Label")));
    m_label->setBuddy(editor);
    m_note->setObjectName(objectNameOf(*editor, QLatin1StringView("Note")));
    m_note->setFont(smallFont(*m_note));
    m_note->setWordWrap(true);
    m_note->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_note->setMinimumHeight(m_note->fontMetrics().height());
    m_note->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_noteSymbol->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_busy->hide();
    m_revert->setObjectName(objectNameOf(*editor, QLatin1StringView("Revert")));
    m_revert->setAutoRaise(true);
    m_revert->setIcon(symbolIcon(Symbol::Revert));
    m_revert->setIconSize({16, 16});
    QSizePolicy keepsPlace = m_revert->sizePolicy();
    keepsPlace.setRetainSizeWhenHidden(true);
    m_revert->setSizePolicy(keepsPlace);
    m_revert->setVisible(false);
    m_current->setObjectName(objectNameOf(*editor, QLatin1StringView("Current")));
    m_current->setFont(m_note->font());
    m_current->hide();
    m_take->setObjectName(objectNameOf(*editor, QLatin1StringView("Take")));
    m_take->setFont(m_note->font());
    m_take->setFocusPolicy(Qt::TabFocus);
    m_take->hide();
    auto* line = new QHBoxLayout(m_noteLine);
    line->setContentsMargins(2, 0, 0, 4);
    line->setSpacing(4);
    line->addWidget(m_current, 0, Qt::AlignTop);
    line->addWidget(m_busy);
    line->addWidget(m_noteSymbol);
    line->addWidget(m_note, 1);
    line->addWidget(m_take, 0, Qt::AlignTop);
    auto* buttons = new QHBoxLayout(m_buttons);
    buttons->setContentsMargins(0, 0, 0, 0);
    buttons->addWidget(m_revert);
    connect(m_revert, &QToolButton::clicked, this, &FieldRow::revertRequested);
    connect(m_take, &QToolButton::clicked, this, &FieldRow::proposalTaken);
    showState();
}

void FieldRow::addTo(QGridLayout& grid, int firstRow)
{
    grid.addWidget(m_label, firstRow, 0);
    grid.addWidget(m_editor, firstRow, 1);
    grid.addWidget(m_buttons, firstRow, 2);
    grid.addWidget(m_noteLine, firstRow + 1, 1, 1, 2);
    QWidget::setTabOrder(m_editor, m_revert);
    QWidget::setTabOrder(m_revert, m_take);
}

QWidget& FieldRow::editor()
{
    return *m_editor;
}

void FieldRow::setBuddy(QWidget& part)
{
    m_label->setBuddy(&part);
}

const FieldTexts& FieldRow::texts() const
{
    return m_texts;
}

void FieldRow::setTexts(const FieldTexts& texts)
{
    m_texts = texts;
    m_label->setText(texts.label);
    m_editor->setAccessibleName(withoutKey(texts.label));
    m_revert->setAccessibleName(tr("Revert %1").arg(withoutKey(texts.label)));
    showState();
}

void FieldRow::setRevertible(bool isRevertible)
{
    m_isRevertible = isRevertible;
    showState();
}

void FieldRow::setVisible(bool isVisible)
{
    m_isVisible = isVisible;
    m_label->setVisible(isVisible);
    m_editor->setVisible(isVisible);
    m_noteLine->setVisible(isVisible);
    m_buttons->setVisible(isVisible);
    m_revert->setVisible(isVisible && m_isDirty && m_isRevertible);
    showProposal();
}

bool FieldRow::isVisible() const
{
    return m_isVisible;
}

void FieldRow::setEnabled(bool isEnabled)
{
    m_label->setEnabled(isEnabled);
    m_editor->setEnabled(isEnabled);
    m_revert->setEnabled(isEnabled);
    m_take->setEnabled(isEnabled);
}

void FieldRow::setDirty(bool isDirty, const QString& driveText)
{
    if (m_isDirty == isDirty && m_driveText == driveText)
        return;
    m_isDirty = isDirty;
    m_driveText = driveText;
    DirtyStyle::setDirty(*m_editor, isDirty);
    showState();
}

bool FieldRow::isDirty() const
{
    return m_isDirty;
}

void FieldRow::setProblem(const QString& sentence)
{
    if (m_problem == sentence)
        return;
    m_problem = sentence;
    showState();
}

void FieldRow::setInformation(const QString& text)
{
    if (m_information == text)
        return;
    m_information = text;
    showState();
}

void FieldRow::setWarning(const QString& sentence)
{
    if (m_warning == sentence)
        return;
    m_warning = sentence;
    showState();
}

void FieldRow::setProposal(const QString& text)
{
    if (m_proposal == text)
        return;
    m_proposal = text;
    showState();
}

void FieldRow::setCurrent(const QString& text, bool isLive)
{
    const QPalette& palette = m_editor->palette();
    QPalette own = palette;
    own.setColor(QPalette::WindowText,
        isLive ? palette.color(QPalette::WindowText)
               : palette.color(QPalette::Disabled, QPalette::WindowText));
    m_current->setPalette(own);
    m_current->setText(text);
    m_current->setToolTip(text.isEmpty() || isLive ? QString() : tr("as last read"));
    m_current->setVisible(!text.isEmpty());
}

void FieldRow::setWholeValue(const QString& text)
{
    if (m_wholeValue == text)
        return;
    m_wholeValue = text;
    showState();
}

void FieldRow::setBusy(bool isBusy)
{
    m_busy->setBusy(isBusy);
    m_busy->setVisible(isBusy);
}

QString FieldRow::note() const
{
    QString text = m_note->text();
    return text.remove(QChar(0x200b));
}

QString FieldRow::changedText() const
{
    return tr("changed, on the drive: %1").arg(m_driveText);
}

Tone FieldRow::tone() const
{
    if (!m_problem.isEmpty())
        return Tone::Error;
    if (!m_warning.isEmpty())
        return Tone::Warning;
    return m_isDirty ? Tone::Changed : Tone::Information;
}

QString FieldRow::noteText() const
{
    if (!m_problem.isEmpty())
        return m_problem;
    QStringList lines;
    if (!m_warning.isEmpty())
        lines += m_warning;
    if (m_isDirty)
        lines += changedText();
    if (!m_proposal.isEmpty())
        lines += tr("proposed: %1").arg(m_proposal);
    return lines.isEmpty() ? m_information : lines.join(u'\n');
}

void FieldRow::showProposal()
{
    m_take->setVisible(m_isVisible && !m_proposal.isEmpty() && m_problem.isEmpty());
    m_take->setText(tr("Use", "what is proposed"));
    m_take->setToolTip(tr("Use what is proposed: %1").arg(m_proposal));
    m_take->setAccessibleName(tr("Use what is proposed for %1").arg(withoutKey(m_texts.label)));
    m_take->setAccessibleDescription(m_proposal);
}

void FieldRow::showState()
{
    const QPalette& palette = m_editor->palette();
    QColor color = mutedTextColor(palette);
    const Tone shown = tone();
    if (shown != Tone::Information) {
        color = textColor(shown, palette);
        const Symbol symbol = shown == Tone::Error ? Symbol::Error
            : shown == Tone::Warning               ? Symbol::Warning
                                                   : Symbol::Edit;
        m_noteSymbol->setPixmap(
            symbolPixmap(symbol, color, fieldSymbolSize, m_editor->devicePixelRatioF()));
    }
    m_noteSymbol->setVisible(shown != Tone::Information);
    QPalette notePalette = palette;
    notePalette.setColor(QPalette::WindowText, color);
    m_note->setPalette(notePalette);
    m_note->setText(breakable(noteText()));
    showProposal();
    m_revert->setVisible(m_isVisible && m_isDirty && m_isRevertible);

    QString toolTip =
        m_wholeValue.isEmpty() ? m_texts.toolTip : m_wholeValue + u'\n' + m_texts.toolTip;
    QString description = m_texts.description;
    if (m_isDirty) {
        const QString onDrive = tr("on the drive: %1").arg(m_driveText);
        toolTip = toolTip.isEmpty() ? onDrive : onDrive + u'\n' + toolTip;
        description = changedText() + QStringLiteral(". ") + description;
        m_revert->setToolTip(tr("Revert to the drive's value: %1").arg(m_driveText));
    }
    for (const QString& sentence : {m_warning, m_problem})
        if (!sentence.isEmpty())
            description = sentence + QStringLiteral(". ") + description;
    m_editor->setToolTip(toolTip);
    if (m_editor->accessibleDescription() != description) {
        m_editor->setAccessibleDescription(description);
        QAccessibleEvent event(m_editor, QAccessible::DescriptionChanged);
        QAccessible::updateAccessibility(&event);
    }
}

bool FieldRow::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ContextMenu && m_isRevertible) {
        showContextMenu(static_cast<QContextMenuEvent*>(event)->globalPos());
        return true;
    }
    // A wheel over the page must not change what goes to a machine.
    if (event->type() == QEvent::Wheel) {
        event->ignore();
        return true;
    }
    if (event->type() == QEvent::PaletteChange && watched == m_editor)
        showState();
    return QObject::eventFilter(watched, event);
}

void FieldRow::showContextMenu(const QPoint& position)
{
    QMenu* menu = nullptr;
    if (auto* combo = qobject_cast<QComboBox*>(m_editor); combo && combo->isEditable()) {
        menu = combo->lineEdit()->createStandardContextMenu();
        menu->addSeparator();
    } else {
        menu = new QMenu(m_editor);
    }
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setObjectName(objectNameOf(*m_editor, QLatin1StringView("Menu")));
    QAction* revert =
        menu->addAction(symbolIcon(Symbol::Revert), tr("&Revert to the drive's value"));
    revert->setEnabled(m_isDirty);
    connect(revert, &QAction::triggered, this, &FieldRow::revertRequested);
    menu->popup(position);
}

} // namespace axiscomp::ui
