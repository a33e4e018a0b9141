// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QRegularExpression>
#include <QTranslator>

namespace axiscomp::test {

/// "<the drive has no axis >{axis}<; it has: >{known}": what is in brackets has been translated,
/// and what a placeholder is filled with is not.
inline QString bracketed(const QString& words)
{
    static const QRegularExpression placeholder(QStringLiteral("\\{\\w+\\}|%L?\\d+|%n|%%|<[^>]*>"));
    static const QRegularExpression letter(QStringLiteral("\\w"));
    QString result;
    const auto addWords = [&result](const QString& part) {
        result += part.contains(letter) ? u'\u2039' + part + u'\u203a' : part;
    };
    qsizetype position = 0;
    for (auto matches = placeholder.globalMatch(words); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        addWords(words.mid(position, match.capturedStart() - position));
        result += match.captured();
        position = match.capturedEnd();
    }
    addWords(words.mid(position));
    return result;
}

/// What stands outside of the brackets of a text.
inline QString outsideBrackets(QString text)
{
    static const QRegularExpression brackets(QStringLiteral("\u2039[^\u203a]*\u203a"));
    return text.replace(brackets, QStringLiteral(" "));
}

/// A language of its own, in which everything that was translated stands in brackets.
class Brackets final : public QTranslator {
public:
    Brackets() { QCoreApplication::installTranslator(this); }
    ~Brackets() override { QCoreApplication::removeTranslator(this); }
    [[nodiscard]] QString translate(const char*, const char* text, const char*, int) const override
    {
        return bracketed(QString::fromUtf8(text));
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

} // namespace axiscomp::test
