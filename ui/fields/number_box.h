// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

#include <optional>

namespace axiscomp::ui {

/// A spin box that takes both 2.5 and 2,5 for two and a half, whatever the language, and no sign
/// between thousands: where it may be one, the number before comes back.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr);

    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    void fixup(QString& text) const override;

private:
    [[nodiscard]] QString numberIn(const QString& text) const;
    [[nodiscard]] std::optional<QString> asTheLanguageWrites(const QString& text) const;

    std::optional<double> m_before; ///< what is being typed
};

} // namespace axiscomp::ui
