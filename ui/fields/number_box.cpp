// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/number_box.h"

#include "ui/text/message_text.h"
#include "ui/text/typed_number.h"

#include <QLineEdit>

#include <utility>

namespace axiscomp::ui {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent)
{
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
        if (!m_before)
            m_before = value();
        forgetRefused();
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
        m_before.reset();
        if (!m_refused.isEmpty())
            Q_EMIT problemChanged();
    });
}

/// "1.000" may become "1.0005", which is read in one way.
QValidator::State NumberBox::validate(QString& text, int& position) const
{
    const auto written = asTheLanguageWrites(text);
    if (!written)
        return QValidator::Intermediate;
    QString copy = *written;
    const QValidator::State state = QDoubleSpinBox::validate(copy, position);
    if (copy != *written)
        text = copy;
    return state;
}

double NumberBox::valueFromText(const QString& text) const
{
    const auto written = asTheLanguageWrites(text);
    return written ? QDoubleSpinBox::valueFromText(*written) : value();
}

/// That of Qt takes signs between thousands out.
void NumberBox::fixup(QString& text) const
{
    if (const auto written = asTheLanguageWrites(text)) {
        text = *written;
        QDoubleSpinBox::fixup(text);
    } else {
        m_refused = numberIn(text);
        text = prefix() + textFromValue(m_before.value_or(value())) + suffix();
    }
}

void NumberBox::stepBy(int steps)
{
    forgetRefused();
    QDoubleSpinBox::stepBy(steps);
}

QString NumberBox::problem() const
{
    if (m_refused.isEmpty())
        return {};
    return tr("%1: %2", "field and problem")
        .arg(accessibleName(), sentenceText(thousandsProblem(m_refused)));
}

void NumberBox::forgetRefused()
{
    if (!std::exchange(m_refused, {}).isEmpty())
        Q_EMIT problemChanged();
}

QString NumberBox::numberIn(const QString& text) const
{
    QString number = text;
    if (number.startsWith(prefix()))
        number.remove(0, prefix().size());
    if (number.endsWith(suffix()))
        number.chop(suffix().size());
    return number.trimmed();
}

/// Nothing where one of its signs may stand between thousands.
std::optional<QString> NumberBox::asTheLanguageWrites(const QString& text) const
{
    const QString number = numberIn(text);
    const QString decimal = locale().decimalPoint();
    const QString group = locale().groupSeparator();
    const QString other = decimal == u"." ? QStringLiteral(",") : QStringLiteral(".");
    const bool isGrouped = group != other && number.contains(group);
    const qsizetype others = number.count(other);
    if ((others == 0 && !isGrouped) || text == specialValueText())
        return text;
    if (isGrouped || others > 1 || number.contains(decimal) || hasThousands(number, locale()))
        return std::nullopt;
    QString written = text;
    return written.replace(other, decimal);
}

} // namespace axiscomp::ui
