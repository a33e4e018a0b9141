// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/fine_scale.h"

#include "ui/text/typed_number.h"
#include "ui/text/value_text.h"

#include <QLocale>

#include <cmath>

namespace axiscomp::ui {

namespace {

ComparedTexts textsOf(const ComparedDigits& shown, double value, double limit)
{
    return {FineScale(shown.value).textWithUnit(value, shown.decimals),
        FineScale(shown.limit).textWithUnit(limit, shown.decimals)};
}

} // namespace

QString FineScale::symbol() const
{
    return QString::fromUtf8(m_unit.symbol);
}

QString FineScale::text(double value, int decimals) const
{
    const double half = 0.5 * std::pow(10.0, -decimals);
    const double shown = value * m_unit.factor;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(std::abs(shown) < half ? 0.0 : shown, 'f', decimals);
}

QString FineScale::textWithUnit(double value, int decimals) const
{
    return text(value, decimals) + u' ' + symbol();
}

QString fineText(double value, bool isAngular)
{
    const std::optional<double> shown[] = {value};
    return FineScale(fineUnit(shown, isAngular)).textWithUnit(value);
}

ComparedTexts comparedTexts(const Verdict& verdict, bool isAngular)
{
    const double limit = verdict.tolerance.value;
    return textsOf(verdictDigits(verdict, isAngular, FineScale::usualDecimals),
        verdict.value.value_or(limit), limit);
}

ComparedTexts comparedTexts(double value, double limit, bool isAngular)
{
    return textsOf(comparedDigits(value, limit, isAngular, FineScale::usualDecimals), value, limit);
}

QString amountText(double value, bool isAngular)
{
    const std::optional<double> shown[] = {value};
    const FineUnit unit = fineUnit(shown, isAngular);
    return numberText(value * unit.factor) + u' ' + QString::fromUtf8(unit.symbol);
}

namespace {

/// Of an amount, without its unit.
QString numberBefore(const QString& amount)
{
    const QString group = QLocale().groupSeparator();
    qsizetype length = 0;
    while (length < amount.size()
        && (amount[length].isDigit() || QStringLiteral("+-.,").contains(amount[length])
            || group.contains(amount[length])))
        ++length;
    return amount.left(length);
}

} // namespace

Result<double> amountOf(const QString& text, bool isAngular)
{
    QString plain = text.trimmed();
    const QString number = numberBefore(plain);
    if (hasThousands(number))
        return fail(ErrorCode::InvalidArgument, {{"reason", thousandsProblem(number)}});
    // One comma that stands between no thousands is a decimal one, also where the language has
    // none.
    if (number.count(u',') == 1 && !number.contains(u'.'))
        plain.replace(number.indexOf(u','), 1, u'.');
    plain.replace(QLocale().decimalPoint(), QStringLiteral("."));
    for (const QChar micro : {QChar(0x00b5), QChar(0x03bc)})
        plain.replace(micro, u'u');
    plain.replace(QChar(0x2033), QStringLiteral("arcsec"));
    plain.replace(QChar(0x00b0), QStringLiteral("deg"));
    return amountFromText(plain.toStdString(), isAngular, isAngular ? "arcsec" : "um");
}

} // namespace axiscomp::ui
