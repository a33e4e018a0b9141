// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/translated_text.h"

#include "core/text/utf8.h"
#include "ui/text/value_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <limits>

namespace axiscomp::ui {

namespace {

QString translatedWords(const TextPattern& pattern, const Arguments& arguments)
{
    if (pattern.one == nullptr)
        return QCoreApplication::translate(pattern.context, pattern.words);
    const std::int64_t count = arguments.integer("count").value_or(0);
    const auto form =
        static_cast<int>(std::clamp<std::int64_t>(count, 0, std::numeric_limits<int>::max()));
    const QString words =
        QCoreApplication::translate(pattern.context, pattern.words, pattern.one, form);
    const bool isEnglish = words == QString::fromUtf8(pattern.words);
    return isEnglish && count == 1 ? QString::fromUtf8(pattern.one) : words;
}

struct ArgumentText {
    /// A drive or a file may have said it.
    QString operator()(const Verbatim& name) const
    {
        return QString::fromStdString(visibleText(name.text, true));
    }
    QString operator()(const Quantity& quantity) const { return translated(quantity); }
    QString operator()(std::int64_t count) const { return QString::number(count); }
    QString operator()(const Text& text) const { return translated(text); }
    QString operator()(const std::vector<Text>& list) const
    {
        QStringList items;
        for (const Text& item : list)
            items += translated(item);
        return listText(items);
    }
};

/// As a page has it; core says it in letters of ASCII.
QString unitText(const std::string& unit)
{
    if (unit == "um")
        return QStringLiteral("µm");
    if (unit == "degC")
        return QStringLiteral("°C");
    return QCoreApplication::translate("Unit", unit.c_str());
}

} // namespace

QString translated(const Quantity& quantity)
{
    QString text = QString::fromStdString(quantity.digits).replace(u'.', QLocale().decimalPoint());
    if (!quantity.unit.empty())
        text += u' ' + unitText(quantity.unit);
    return text;
}

QString translated(const Text& text)
{
    if (text.isEmpty())
        return {};
    const QString words = translatedWords(text.pattern(), text.arguments());
    QString result;
    qsizetype position = 0;
    while (true) {
        const qsizetype open = words.indexOf(u'{', position);
        const qsizetype close = open < 0 ? -1 : words.indexOf(u'}', open);
        if (close < 0)
            return result += QStringView(words).mid(position);
        result += QStringView(words).mid(position, open - position);
        const std::string name = words.mid(open + 1, close - open - 1).toStdString();
        const Argument* const value = text.arguments().find(name);
        const QString said =
            value ? std::visit(ArgumentText(), value->value()) : QStringLiteral("?");
        result += said;
        position = close + 1;
        const bool isStopNext = position < words.size()
            && (words[position] == u'.' || words[position] == QChar(0x3002));
        if (value && isStopNext && endsInQuestion(*value, said.toStdString()))
            ++position;
    }
}

} // namespace axiscomp::ui
