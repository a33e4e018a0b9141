// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/fine_scale.h"

#include "core/metrology/judge/uncertainty.h"
#include "ui/text/value_text.h"

#include <QLocale>

#include <cmath>

namespace axiscomp::ui {

QString FineScale::symbol() const
{
    return QString::fromUtf8(m_unit.symbol);
}

QString FineScale::text(double value) const
{
    constexpr int decimals = 2;
    constexpr double half = 0.005;
    const double shown = value * m_unit.factor;
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(std::abs(shown) < half ? 0.0 : shown, 'f', decimals);
}

QString FineScale::textWithUnit(double value) const
{
    return text(value) + u' ' + symbol();
}

QString fineText(double value, bool isAngular)
{
    const std::optional<double> shown[] = {value};
    return FineScale(fineUnit(shown, isAngular)).textWithUnit(value);
}

QString amountText(double value, bool isAngular)
{
    const std::optional<double> shown[] = {value};
    const FineUnit unit = fineUnit(shown, isAngular);
    return numberText(value * unit.factor) + u' ' + QString::fromUtf8(unit.symbol);
}

Result<double> amountOf(const QString& text, bool isAngular)
{
    QString plain = text.trimmed();
    plain.replace(QLocale().decimalPoint(), QStringLiteral("."));
    for (const QChar micro : {QChar(0x00b5), QChar(0x03bc)})
        plain.replace(micro, u'u');
    plain.replace(QChar(0x2033), QStringLiteral("arcsec"));
    plain.replace(QChar(0x00b0), QStringLiteral("deg"));
    return amountFromText(plain.toStdString(), isAngular, isAngular ? "arcsec" : "um");
}

} // namespace axiscomp::ui
