// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/typed_number.h"

#include <QRegularExpression>

#include <cmath>

namespace axiscomp::ui {

namespace {

std::optional<double> withoutGroups(const QString& text, QLocale language)
{
    language.setNumberOptions(QLocale::RejectGroupSeparator);
    bool isNumber = false;
    const double number = language.toDouble(text, &isNumber);
    return isNumber ? std::optional(number) : std::nullopt;
}

} // namespace

bool hasThousands(const QString& text, const QLocale& language)
{
    // No thousands begin with 0.
    static const QRegularExpression belowOne(QStringLiteral("^\\s*[+-]?0[.,]\\d+\\s*$"));
    if (text.contains(belowOne))
        return false;
    QLocale grouping = language;
    grouping.setNumberOptions(QLocale::DefaultNumberOptions);
    bool isNumber = false;
    static_cast<void>(grouping.toDouble(text, &isNumber));
    return isNumber && !withoutGroups(text, language);
}

std::optional<double> typedNumber(const QString& text)
{
    auto number = withoutGroups(text, QLocale());
    if (!number && !hasThousands(text))
        number = withoutGroups(text, QLocale::c());
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<QStringList> typedList(const QString& text, bool hasCommas)
{
    // One to three digits that are no decimals, then three.
    static const QRegularExpression blank(
        QStringLiteral("(?<![\\d.,])\\d{1,3}[ \\x{a0}\\x{202f}]\\d{3}(?!\\d)"));
    static const QRegularExpression comma(QStringLiteral("(?<![\\d.,])\\d{1,3},\\d{3}(?!\\d)"));
    if (text.contains(blank) || (hasCommas && text.contains(comma)))
        return std::nullopt;
    static const QRegularExpression between(QStringLiteral("[;\\s]+"));
    static const QRegularExpression betweenOrComma(QStringLiteral("[;,\\s]+"));
    return text.split(hasCommas ? betweenOrComma : between, Qt::SkipEmptyParts);
}

Text thousandsProblem(const QString& text)
{
    return AXISCOMP_TEXT(
        "Error", "\"{text}\" can be read in two ways; write thousands without a sign between them")
        .with("text", text.toStdString());
}

} // namespace axiscomp::ui
