// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/number_edit.h"

#include "ui/fields/wrong_mark.h"
#include "ui/text/typed_number.h"

#include <QLocale>
#include <QStringList>

#include <cmath>

namespace axiscomp::ui {

NumberEdit::NumberEdit(const Rule& rule, QWidget* parent) : QLineEdit(parent), m_rule(rule)
{
    connect(this, &QLineEdit::editingFinished, this, &NumberEdit::take);
}

void NumberEdit::setNumbers(const std::vector<double>& numbers)
{
    // What is being typed is the user's, until it is done or another number has its place.
    if (isModified() && numbers == m_numbers)
        return;
    m_numbers = numbers;
    const auto shown = numbersOf(text());
    if (!shown || *shown != numbers) {
        QLocale locale;
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        QStringList texts;
        for (const double number : numbers)
            texts += locale.toString(number, 'g', QLocale::FloatingPointShortest);
        setText(texts.join(QStringLiteral("; ")));
        setCursorPosition(0);
    }
    setWrong(false);
}

void NumberEdit::forgetTyped()
{
    setModified(false);
    setNumbers(std::vector(m_numbers));
}

QString NumberEdit::problem() const
{
    if (!m_isWrong)
        return {};
    return tr("%1: \"%2\" cannot be taken. %3")
        .arg(accessibleName(), text().trimmed(), accessibleDescription());
}

void NumberEdit::take()
{
    const auto numbers = numbersOf(text());
    setWrong(!numbers);
    if (!numbers)
        return;
    setModified(false);
    if (*numbers == m_numbers)
        return;
    m_numbers = *numbers;
    Q_EMIT chosen();
}

void NumberEdit::setWrong(bool isWrong)
{
    if (isWrong == m_isWrong && !isWrong)
        return;
    m_isWrong = isWrong;
    markWrong(*this, isWrong);
    Q_EMIT problemChanged();
}

std::optional<std::vector<double>> NumberEdit::numbersOf(const QString& text) const
{
    const auto parts = typedList(text);
    if (!parts)
        return std::nullopt;
    std::vector<double> numbers;
    for (const QString& part : *parts) {
        const auto number = typedNumber(part);
        if (!number)
            return std::nullopt;
        const bool isLargeEnough = !m_rule.smallest || *number > *m_rule.smallest
            || (!m_rule.isMore && *number == *m_rule.smallest);
        const bool isWhole = !m_rule.areWhole || *number == std::floor(*number);
        if (!isLargeEnough || !isWhole)
            return std::nullopt;
        numbers.push_back(*number);
    }
    if (numbers.size() > m_rule.most)
        return std::nullopt;
    return numbers;
}

} // namespace axiscomp::ui
