// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

#include <optional>
#include <vector>

namespace axiscomp::ui {

/// Numbers as the language writes them, "0.5; 10": none, one or several. What is no number stays in
/// the field, marked, and is not taken.
class NumberEdit : public QLineEdit {
    Q_OBJECT

public:
    /// smallest: that a number may have; isMore: it has to be larger.
    struct Rule {
        std::size_t most = 1; ///< numbers
        std::optional<double> smallest = {};
        bool isMore = false;
        bool areWhole = false;
    };
    explicit NumberEdit(const Rule& rule, QWidget* parent = nullptr);

    void setMost(std::size_t most) { m_rule.most = most; }
    /// Of which the text is, or which it was before it became wrong.
    [[nodiscard]] const std::vector<double>& numbers() const { return m_numbers; }
    /// Leaves what is being typed, or is wrong, as long as they are numbers() already.
    void setNumbers(const std::vector<double>& numbers);
    /// Shows numbers() in place of what was typed and not taken.
    void forgetTyped();
    /// Why the text is not taken, a translated sentence; empty: it is.
    [[nodiscard]] QString problem() const;

Q_SIGNALS:
    void chosen(); ///< numbers() are others, by the user
    void problemChanged();

private:
    void take();
    void setWrong(bool isWrong);
    [[nodiscard]] std::optional<std::vector<double>> numbersOf(const QString& text) const;

    Rule m_rule;
    std::vector<double> m_numbers;
    bool m_isWrong = false;
};

} // namespace axiscomp::ui
