// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

#include <optional>

namespace axiscomp::ui {

/// A spin box that takes both 2.5 and 2,5 for two and a half, whatever the language, and no sign
/// between thousands: where it may be one, the number before comes back, with a problem.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr);

    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    void fixup(QString& text) const override;
    void stepBy(int steps) override;
    /// Why the number that was typed last is not the one that is shown, a translated sentence;
    /// empty: it is.
    [[nodiscard]] QString problem() const;

Q_SIGNALS:
    void problemChanged();

private:
    void forgetRefused();
    [[nodiscard]] QString numberIn(const QString& text) const;
    [[nodiscard]] std::optional<QString> asTheLanguageWrites(const QString& text) const;

    std::optional<double> m_before; ///< what is being typed
    mutable QString m_refused; ///< by fixup(); empty: nothing was
};

} // namespace axiscomp::ui
