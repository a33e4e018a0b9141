// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/contrast.h"

#include <QWidget>

#include <functional>
#include <vector>

class QVBoxLayout;

namespace axiscomp::ui {

/// Something to read, with what can be done about it.
struct Message {
    /// Names the message: another one of the same id takes its place.
    QString id;
    Tone tone = Tone::Information;
    QString text;
    struct Button {
        QString objectName;
        QString text;
        std::function<void()> run; ///< the message is gone by then
        bool isEnabled = true;
        QString reason{}; ///< what it does, or why it cannot be pressed
    };
    std::vector<Button> buttons;
    bool isClosable = true;
};

/// Messages one above the other within the page, in place of message boxes: a colour, a symbol and
/// words.
class MessageStack : public QWidget {
    Q_OBJECT

public:
    explicit MessageStack(QWidget* parent = nullptr);

    void show(const Message& message);
    void remove(const QString& id);
    [[nodiscard]] bool contains(const QString& id) const;
    /// Empty: there is none.
    [[nodiscard]] QString text(const QString& id) const;
    /// Of a message with two lines of text, or with buttons.
    [[nodiscard]] int heightOfOne() const;

Q_SIGNALS:
    void shown(); ///< a message that was not there

private:
    [[nodiscard]] QWidget* find(const QString& id) const;

    QVBoxLayout* m_layout;
};

} // namespace axiscomp::ui
