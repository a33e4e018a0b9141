// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/message_stack.h"

#include "ui/style/accessible_role.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"

#include <QAccessible>
#include <QBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

namespace axiscomp::ui {

namespace {

constexpr int messageSymbolSize = 18;

class MessageBar final : public QWidget {
public:
    MessageBar(const Message& message, MessageStack& stack)
        : QWidget(&stack)
        , m_tone(message.tone)
        , m_symbol(new PlainLabel)
        , m_text(new PlainLabel(message.text))
    {
        setObjectName(message.id);
        setAccessibleRole(*this, QAccessible::AlertMessage);
        m_text->setObjectName(QStringLiteral("messageText"));
        m_text->setWordWrap(true);
        m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        auto* layout = new QHBoxLayout(this);
        layout->setContentsMargins(12, 6, 6, 6);
        layout->setSpacing(10);
        layout->addWidget(m_symbol, 0, Qt::AlignVCenter);
        layout->addWidget(m_text, 1);
        for (const Message::Button& button : message.buttons)
            addButton(*layout, button, stack);
        if (message.isClosable)
            addClose(*layout, stack);
        colour();
    }

    [[nodiscard]] QString text() const { return m_text->text(); }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(frameColor(m_tone, palette()), 1.0));
        painter.setBrush(fillColor(m_tone, palette()));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    }
    void changeEvent(QEvent* event) override
    {
        if (event->type() == QEvent::PaletteChange)
            colour();
        QWidget::changeEvent(event);
    }

private:
    void colour()
    {
        m_symbol->setPixmap(symbolPixmap(symbolOf(m_tone), frameColor(m_tone, palette()),
            messageSymbolSize, devicePixelRatioF()));
    }
    void addButton(QHBoxLayout& layout, const Message::Button& description, MessageStack& stack)
    {
        auto* button = new QPushButton(description.text, this);
        button->setObjectName(description.objectName);
        button->setAccessibleDescription(
            description.reason.isEmpty() ? m_text->text() : description.reason);
        button->setToolTip(description.reason);
        button->setEnabled(description.isEnabled);
        button->setAutoDefault(true);
        // Of a long text, the lines beyond the first two are scrolled to: not so what to press.
        layout.addWidget(button, 0, Qt::AlignTop);
        connect(button, &QPushButton::clicked, &stack,
            [&stack, id = objectName(), run = description.run] {
                stack.remove(id);
                run();
            });
    }
    void addClose(QHBoxLayout& layout, MessageStack& stack)
    {
        auto* close = new QToolButton(this);
        close->setObjectName(QStringLiteral("closeMessage"));
        close->setAutoRaise(true);
        close->setIcon(symbolIcon(Symbol::Close));
        close->setToolTip(MessageStack::tr("Close this message"));
        close->setAccessibleName(MessageStack::tr("Close this message"));
        layout.addWidget(close, 0, Qt::AlignVCenter);
        connect(close, &QToolButton::clicked, &stack,
            [&stack, id = objectName()] { stack.remove(id); });
    }

    Tone m_tone;
    QLabel* m_symbol;
    QLabel* m_text;
};

} // namespace

MessageStack::MessageStack(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this))
{
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(6);
    setVisible(false);
}

void MessageStack::show(const Message& message)
{
    remove(message.id);
    auto* bar = new MessageBar(message, *this);
    m_layout->insertWidget(0, bar);
    setVisible(true);
    bar->show();
    QAccessibleEvent event(bar, QAccessible::Alert);
    bar->setAccessibleName(message.text);
    QAccessible::updateAccessibility(&event);
    Q_EMIT shown();
}

void MessageStack::remove(const QString& id)
{
    QWidget* bar = find(id);
    if (!bar)
        return;
    bar->setObjectName({});
    bar->hide();
    m_layout->removeWidget(bar);
    bar->deleteLater();
    setVisible(m_layout->count() > 0);
}

int MessageStack::heightOfOne() const
{
    const int button = QPushButton(QStringLiteral("X")).sizeHint().height();
    return qMax(2 * fontMetrics().lineSpacing(), button) + 12;
}

bool MessageStack::contains(const QString& id) const
{
    return find(id) != nullptr;
}

QString MessageStack::text(const QString& id) const
{
    const auto* bar = dynamic_cast<const MessageBar*>(find(id));
    return bar ? bar->text() : QString();
}

QWidget* MessageStack::find(const QString& id) const
{
    return id.isEmpty() ? nullptr : findChild<QWidget*>(id, Qt::FindDirectChildrenOnly);
}

} // namespace axiscomp::ui
