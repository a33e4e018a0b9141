// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QRegularExpression>
#include <QString>

#include <vector>

namespace axiscomp::test {

struct Literal {
    QString text;
    qsizetype line = 0; ///< of its first character, from 1
};

/// The string literals of a C++ file, adjacent ones joined, without those of #include lines and of
/// comments.
inline std::vector<Literal> stringLiterals(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(file.readAll());
    static const QRegularExpression token(
        QStringLiteral(
            R"re((?<skip>#include[^\n]*|//[^\n]*|/\*.*?\*/|R"\(.*?\)"|'(?:\\.|[^'\\\n])+'))re"
            R"re(|"(?<text>(?:\\.|[^"\\\n])*)"|(?<other>\S))re"),
        QRegularExpression::DotMatchesEverythingOption);
    std::vector<Literal> literals;
    bool goesOn = false; // nothing but blanks since the last literal
    for (auto matches = token.globalMatch(text); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        if (match.hasCaptured(QStringLiteral("text"))) {
            QString literal = match.captured(QStringLiteral("text"));
            literal.replace(QStringLiteral("\\\""), QStringLiteral("\""));
            if (goesOn)
                literals.back().text += literal;
            else
                literals.push_back({literal, text.left(match.capturedStart()).count(u'\n') + 1});
            goesOn = true;
        } else if (match.hasCaptured(QStringLiteral("other"))) {
            goesOn = false;
        }
    }
    return literals;
}

/// Two words at least: what a person may read, not a name or a key.
inline bool isSentence(const QString& literal)
{
    static const QRegularExpression words(QStringLiteral("[A-Za-z]{2,}[,;:]? \\(?[a-zA-Z]+"));
    return words.match(literal).hasMatch();
}

/// A word with a blank beside it: of a sentence that is put together.
inline bool isPiece(const QString& literal)
{
    static const QRegularExpression piece(
        QStringLiteral("^[^A-Za-z]* [a-z]{2,}\\b|(^|[ (])[a-z]{2,}:? $"));
    return piece.match(literal).hasMatch();
}

} // namespace axiscomp::test
