// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

#include <vector>

namespace axiscomp::ui {

/// One register that may be a source.
struct SourceChoice {
    QString uri; ///< tam://mc/<drive>/<path>
    QString name; ///< for people: "X · PositionController/MasterPosition"
    friend bool operator==(const SourceChoice&, const SourceChoice&) = default;
};

/// A register by choice from a list, or by typing any path, URI or address. What is typed counts
/// when editing is finished; until then the field belongs to the user.
class SourceCombo : public QComboBox {
    Q_OBJECT

public:
    explicit SourceCombo(QWidget* parent = nullptr);

    void setChoices(std::vector<SourceChoice> choices);
    /// Shows the value, unless the user is typing: then it is what Escape goes back to.
    /// name: for people, shown where the URI does not fit.
    void showValue(const QString& uri, const QString& name = {});
    /// What showValue was last told.
    [[nodiscard]] const QString& value() const;
    /// The value's name while it is shown, otherwise what is in the field.
    [[nodiscard]] QString nameOfValue() const;
    /// The user has typed something that has not been taken over yet.
    [[nodiscard]] bool isTyping() const;
    /// The text that was chosen last was refused; it stays for correction while the field has the
    /// focus. Said again it changes nothing.
    void refuse();

Q_SIGNALS:
    void chosen(const QString& text);
    void edited(); ///< typing has begun, goes on or is given up

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void finish();
    void leave();
    void showText(const QString& text);

    std::vector<SourceChoice> m_choices;
    QString m_value;
    QString m_name;
    QString m_asked; ///< the text that was handed on last and not answered
    bool m_isTyping = false;
};

} // namespace axiscomp::ui
