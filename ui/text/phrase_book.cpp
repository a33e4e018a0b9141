// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
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
    QString longest = {}; ///< piece between placeholders: to pass over most patterns fast
};

/// "{number2}"
bool isNumber(const QString& placeholder)
{
    static const QRegularExpression name(QStringLiteral("^\\{number\\d?\\}$"));
    return name.match(placeholder).hasMatch();
}

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
        if (literal.size() > pattern.longest.size())
            pattern.longest = literal;
        if (isLast)
            break;
        pattern.names += text.mid(open, close - open + 1);
        expression += isNumber(pattern.names.back())
            ? QStringLiteral("([+-]?(?:\\d+(?:\\.\\d+)?(?:e[+-]?\\d+)?|inf))")
            : QStringLiteral("(.*?)");
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

struct Translation {
    QString text;
    qsizetype known = 0; ///< characters of the English text that phrases and numbers account for
};

/// "0.5", "-1.5e-05 mm" with the decimal sign of the language; other texts as they are.
Translation withDecimalSign(QString text)
{
    static const QRegularExpression quantity(
        QStringLiteral("^([+-]?\\d+(\\.\\d+)?(e[+-]?\\d+)?)( [^\\s\\d]\\S*)?$"));
    const QRegularExpressionMatch match = quantity.match(text);
    if (match.hasMatch() && match.capturedLength(2) > 0)
        text.replace(match.capturedStart(2), 1, QLocale().decimalPoint());
    return {text, match.capturedLength(1)};
}

/// Translates a text and the texts within it. Each of them once: the phrases that match may be
/// many.
class Translator {
public:
    [[nodiscard]] Translation translated(const QString& english);
    [[nodiscard]] Translation translated(const QString& placeholder, const QString& english);

private:
    [[nodiscard]] Translation filled(const Pattern& pattern, const QRegularExpressionMatch& match);
    [[nodiscard]] Translation best(const QString& english);

    QHash<QString, Translation> m_done;
};

Translation Translator::translated(const QString& english)
{
    if (const auto done = m_done.constFind(english); done != m_done.constEnd())
        return *done;
    const Translation translation = best(english);
    m_done.insert(english, translation);
    return translation;
}

Translation Translator::translated(const QString& placeholder, const QString& english)
{
    static const QStringList written{QStringLiteral("example"), QStringLiteral("file"),
        QStringLiteral("folder"), QStringLiteral("name"), QStringLiteral("path"),
        QStringLiteral("table"), QStringLiteral("version")};
    if (written.contains(placeholder) && withDecimalSign(english).known == english.size())
        return {english, english.size()};
    return translated(english);
}

/// The translation of a pattern with what the English text has in place of its placeholders.
Translation Translator::filled(const Pattern& pattern, const QRegularExpressionMatch& match)
{
    const QString text = QCoreApplication::translate("Error", pattern.phrase);
    Translation result{{}, pattern.literals};
    qsizetype position = 0;
    while (true) {
        const qsizetype open = text.indexOf(u'{', position);
        const qsizetype close = text.indexOf(u'}', open);
        if (open < 0 || close < 0) {
            result.text += text.mid(position);
            return result;
        }
        result.text += text.mid(position, open - position);
        position = close + 1;
        const qsizetype n = pattern.names.indexOf(text.mid(open, position - open));
        const QString found = match.captured(static_cast<int>(n) + 1);
        const bool isQuotation =
            result.text.endsWith(u'"') && position < text.size() && text[position] == u'"';
        const Translation part = isQuotation
            ? Translation{found, found.size()}
            : translated(text.mid(open + 1, close - open - 1), found);
        result.text += part.text;
        result.known += part.known;
    }
}

/// Of all phrases that a text can be made from, and those within it, the ones that account for most
/// of it: a sentence within another may have a longer phrase than the whole.
Translation Translator::best(const QString& english)
{
    const QByteArray utf8 = english.toUtf8();
    const auto known = knownPhrases();
    const bool isWhole =
        std::ranges::any_of(known, [&](const char* phrase) { return utf8 == phrase; });
    if (isWhole)
        return {QCoreApplication::translate("Error", utf8.constData()), english.size()};
    // Core quotes whole problems of a file in the reason of an error.
    if (isProblemPhrase(english))
        return {QCoreApplication::translate("Problem", utf8.constData()), english.size()};
    Translation most = withDecimalSign(english);
    for (const Pattern& pattern : patterns()) {
        if (most.known >= english.size())
            break;
        if (!english.contains(pattern.longest))
            continue;
        const QRegularExpressionMatch match = pattern.expression.match(english);
        if (!match.hasMatch())
            continue;
        Translation other = filled(pattern, match);
        if (other.known > most.known)
            most = std::move(other);
    }
    return most;
}

} // namespace

QString placeholderText(const QString& name, const std::string& english)
{
    return Translator().translated(name, QString::fromStdString(english)).text;
}

QString translatedPhrase(const std::string& english)
{
    return Translator().translated(QString::fromStdString(english)).text;
}

} // namespace axiscomp::ui
