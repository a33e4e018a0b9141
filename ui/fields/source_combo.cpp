// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/source_combo.h"

#include "ui/style/contrast.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QCompleter>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <QStyleOptionFrame>
#include <QStyledItemDelegate>

#include <utility>

namespace axiscomp::ui {

namespace {

constexpr int nameRole = Qt::UserRole;
constexpr int longestPopupWidth = 640;

/// A URI that is too long to be seen whole gives way to the register's name as long as nobody edits
/// it.
class SourceLineEdit final : public QLineEdit {
public:
    using QLineEdit::QLineEdit;

    bool event(QEvent* event) override
    {
        // What is not being typed is undone by the page, as every other field.
        if (event->type() == QEvent::ShortcutOverride
            && !static_cast<const SourceCombo*>(parentWidget())->isTyping()) {
            const auto* key = static_cast<QKeyEvent*>(event);
            if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
                event->ignore();
                return false;
            }
        }
        return QLineEdit::event(event);
    }

protected:
    void paintEvent(QPaintEvent* event) override
    {
        const bool isEdited = hasFocus() || parentWidget()->hasFocus();
        QStyleOptionFrame option;
        initStyleOption(&option);
        const QRect contents = style()
                                   ->subElementRect(QStyle::SE_LineEditContents, &option, this)
                                   .adjusted(2, 0, -2, 0);
        if (isEdited || fontMetrics().horizontalAdvance(text()) <= contents.width()) {
            QLineEdit::paintEvent(event);
            return;
        }
        QPainter painter(this);
        style()->drawPrimitive(QStyle::PE_PanelLineEdit, &option, &painter, this);
        const auto* combo = static_cast<const SourceCombo*>(parentWidget());
        const QString shown =
            fontMetrics().elidedText(combo->nameOfValue(), Qt::ElideMiddle, contents.width());
        style()->drawItemText(&painter, contents, Qt::AlignLeft | Qt::AlignVCenter, palette(),
            isEnabled(), shown, QPalette::Text);
    }
};

/// The name, and below it the URI in small letters.
class SourceDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& original,
        const QModelIndex& index) const override
    {
        QStyleOptionViewItem option = original;
        initStyleOption(&option, index);
        const QString uri = option.text;
        option.text.clear();
        const QWidget* widget = option.widget;
        widget->style()->drawControl(QStyle::CE_ItemViewItem, &option, painter, widget);
        const bool isSelected = option.state.testFlag(QStyle::State_Selected);
        const QRect inside = option.rect.adjusted(8, 3, -8, -3);
        const QFontMetrics nameMetrics(option.font);
        painter->save();
        painter->setPen(
            option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text));
        painter->setFont(option.font);
        painter->drawText(inside, Qt::AlignLeft | Qt::AlignTop,
            nameMetrics.elidedText(
                index.data(nameRole).toString(), Qt::ElideMiddle, inside.width()));
        const QFont small = smallFont(option.font);
        painter->setFont(small);
        if (!isSelected)
            painter->setPen(mutedTextColor(option.palette));
        painter->drawText(inside, Qt::AlignLeft | Qt::AlignBottom,
            QFontMetrics(small).elidedText(uri, Qt::ElideMiddle, inside.width()));
        painter->restore();
    }

    [[nodiscard]] QSize sizeHint(
        const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const QFontMetrics names(option.font);
        const QFontMetrics uris(smallFont(option.font));
        const int width = qMax(names.horizontalAdvance(index.data(nameRole).toString()),
            uris.horizontalAdvance(index.data().toString()));
        return {qMin(width, longestPopupWidth) + 24, names.height() + uris.height() + 8};
    }

private:
    [[nodiscard]] static QFont smallFont(QFont font)
    {
        font.setPointSizeF(font.pointSizeF() * 0.86);
        return font;
    }
};

} // namespace

SourceCombo::SourceCombo(QWidget* parent) : QComboBox(parent)
{
    setLineEdit(new SourceLineEdit(this));
    setEditable(true);
    setInsertPolicy(NoInsert);
    setFocusPolicy(Qt::StrongFocus);
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(9);
    setMaxVisibleItems(12);
    setItemDelegate(new SourceDelegate(this));
    completer()->setCompletionMode(QCompleter::PopupCompletion);
    completer()->setFilterMode(Qt::MatchContains);
    completer()->setCaseSensitivity(Qt::CaseInsensitive);
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
        m_isTyping = true;
        Q_EMIT edited();
    });
    connect(lineEdit(), &QLineEdit::returnPressed, this, &SourceCombo::finish);
    connect(this, &QComboBox::textActivated, this, [this] {
        m_isTyping = true;
        finish();
    });
    // While the list of proposals is open it keeps focusOutEvent from being called.
    connect(
        qApp, &QApplication::focusChanged, this, [this](const QWidget* left, const QWidget* now) {
            if (left != this || !now || !completer()->popup()->isVisible())
                return;
            completer()->popup()->hide();
            leave();
        });
}

void SourceCombo::setChoices(std::vector<SourceChoice> choices)
{
    if (m_choices == choices)
        return;
    m_choices = std::move(choices);
    const QSignalBlocker blocker(this);
    const QString text = currentText();
    const int cursor = lineEdit()->cursorPosition();
    clear();
    int width = 0;
    for (const SourceChoice& choice : m_choices) {
        addItem(choice.uri);
        setItemData(count() - 1, choice.name, nameRole);
        setItemData(count() - 1, choice.name, Qt::AccessibleTextRole);
        width = qMax(width, fontMetrics().horizontalAdvance(choice.uri));
    }
    view()->setMinimumWidth(qMin(width, longestPopupWidth) + 40);
    setCurrentIndex(m_isTyping ? -1 : findText(text));
    setEditText(text);
    lineEdit()->setCursorPosition(cursor);
}

void SourceCombo::showValue(const QString& uri, const QString& name)
{
    m_value = uri;
    m_name = name;
    m_asked.clear();
    if (!m_isTyping)
        showText(uri);
}

const QString& SourceCombo::value() const
{
    return m_value;
}

QString SourceCombo::nameOfValue() const
{
    return m_name.isEmpty() || currentText() != m_value ? currentText() : m_name;
}

bool SourceCombo::isTyping() const
{
    return m_isTyping;
}

void SourceCombo::refuse()
{
    const QString asked = std::exchange(m_asked, {});
    if (m_isTyping || asked.isEmpty())
        return;
    if (!hasFocus()) {
        showText(m_value);
        return;
    }
    showText(asked);
    m_isTyping = true;
}

void SourceCombo::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && m_isTyping) {
        m_isTyping = false;
        showText(m_value);
        lineEdit()->selectAll();
        Q_EMIT edited();
        return;
    }
    QComboBox::keyPressEvent(event);
}

void SourceCombo::focusOutEvent(QFocusEvent* event)
{
    QComboBox::focusOutEvent(event);
    const bool isOwnPopup =
        event->reason() == Qt::PopupFocusReason || event->reason() == Qt::ActiveWindowFocusReason;
    if (isOwnPopup)
        return;
    leave();
}

void SourceCombo::leave()
{
    finish();
    // What was refused while the keyboard is still here stays for correction.
    if (m_asked.isEmpty() && !m_isTyping)
        showText(m_value);
}

void SourceCombo::finish()
{
    if (!m_isTyping)
        return;
    m_isTyping = false;
    const QString text = lineEdit()->text().trimmed();
    if (text == m_value) {
        showText(m_value);
        return;
    }
    if (text == m_asked)
        return;
    m_asked = text;
    Q_EMIT chosen(text);
}

void SourceCombo::showText(const QString& text)
{
    if (currentText() == text)
        return;
    const QSignalBlocker blocker(this);
    const int cursor = lineEdit()->cursorPosition();
    const bool keepsCursor = hasFocus();
    setCurrentIndex(findText(text));
    setEditText(text);
    lineEdit()->setCursorPosition(keepsCursor ? qMin<int>(cursor, int(text.size())) : 0);
}

} // namespace axiscomp::ui
