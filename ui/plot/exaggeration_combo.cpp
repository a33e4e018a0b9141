// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/exaggeration_combo.h"

#include "ui/text/value_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

ExaggerationCombo::ExaggerationCombo(QWidget* parent) : QComboBox(parent)
{
    constexpr int letters = 6; // larger factors are rare, and seen in the list
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(letters);
    addItem(QString(), 0.0);
    constexpr double most = 1e7;
    for (double power = 1.0; power < most; power *= 10.0)
        for (const double factor : {1.0, 2.0, 5.0})
            addItem(QString(), factor * power);
    connect(this, &QComboBox::currentIndexChanged, this, &ExaggerationCombo::factorChanged);
    retranslate();
}

void ExaggerationCombo::retranslate()
{
    setAccessibleName(tr("Exaggeration"));
    setItemText(0, tr("fitting"));
    for (int n = 1; n < count(); ++n)
        setItemText(n, QStringLiteral("× %1").arg(factorText(itemData(n).toDouble())));
}

void ExaggerationCombo::setFitting(double factor)
{
    m_fitting = roundFactor(factor);
}

double ExaggerationCombo::factor() const
{
    const double chosen = currentData().toDouble();
    return chosen > 0.0 ? chosen : m_fitting;
}

void ExaggerationCombo::step(int steps)
{
    int at = currentIndex();
    constexpr double rounding = 0.999;
    for (int n = 1; at == 0 && n < count(); ++n)
        if (itemData(n).toDouble() >= m_fitting * rounding)
            at = n;
    setCurrentIndex(std::clamp(at + steps, 1, count() - 1));
}

void ExaggerationCombo::showFitting()
{
    setCurrentIndex(0);
}

double roundFactor(double number)
{
    if (!(number > 0.0) || !std::isfinite(number))
        return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(number)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= number)
            return factor * power;
    return power;
}

QString factorText(double factor)
{
    return factor < 1.0 ? numberText(factor) : countText(static_cast<std::size_t>(factor));
}

} // namespace axiscomp::ui
