// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/phrase_book.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <vector>

namespace axiscomp::ui {

namespace {

/// A phrase with placeholders, as an expression that finds what they stand for.
struct Pattern {
    const char* phrase = nullptr;
    QRegularExpression expression;
    QStringList names;
    qsizetype literals = 0; ///< characters outside placeholders: the more, the surer is a match
};

Pattern patternOf(const char* phrase)
{
    Pattern pattern{phrase, {}, {}, 0};
    QString expression;
    const QString text = QString::fromUtf8(phrase);
    qsizetype position = 0;
    while (true) {
        const qsizetype open = text.indexOf(u'{', position);
        const qsizetype close = text.indexOf(u'}', open);
        const bool isLast = open < 0 || close < 0;
        const QString literal = text.mid(position, isLast ? -1 : open - position);
        expression += QRegularExpression::escape(literal);
        pattern.literals += literal.size();
        if (isLast)
            break;
        pattern.names += text.mid(open, close - open + 1);
        expression += QStringLiteral("(.*?)");
        position = close + 1;
    }
    pattern.expression.setPattern(QRegularExpression::anchoredPattern(expression));
    pattern.expression.setPatternOptions(QRegularExpression::DotMatchesEverythingOption);
    return pattern;
}

const std::vector<Pattern>& patterns()
{
    static const std::vector<Pattern> all = [] {
        std::vector<Pattern> made;
        for (const char* phrase : knownPhrases()) {
            Pattern pattern = patternOf(phrase);
            if (!pattern.names.isEmpty() && pattern.literals > 0)
                made.push_back(std::move(pattern));
        }
        std::ranges::stable_sort(made, std::ranges::greater{}, &Pattern::literals);
        return made;
    }();
    return all;
}

} // namespace

QString translatedPhrase(const std::string& english)
{
    const auto known = knownPhrases();
    const bool isWhole =
        std::ranges::any_of(known, [&](const char* phrase) { return english == phrase; });
    if (isWhole || english.empty())
        return QCoreApplication::translate("Error", english.c_str());
    const QString text = QString::fromStdString(english);
    for (const Pattern& pattern : patterns()) {
        const QRegularExpressionMatch match = pattern.expression.match(text);
        if (!match.hasMatch())
            continue;
        QString translated = QCoreApplication::translate("Error", pattern.phrase);
        for (qsizetype i = 0; i < pattern.names.size(); ++i)
            translated.replace(pattern.names[i],
                translatedPhrase(match.captured(static_cast<int>(i) + 1).toStdString()));
        return translated;
    }
    return text;
}

} // namespace axiscomp::ui
