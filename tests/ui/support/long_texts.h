// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QRegularExpression>
#include <QTranslator>

namespace axiscomp::test {

/// English with every text of the program a third longer, as a language may need it: the words of
/// the text begin once more. What placeholders hold, and the keys, are those of the text.
class LongTexts final : public QTranslator {
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* text,
        const char* /*disambiguation*/, int /*n*/) const override
    {
        // Qt's own texts have translations of their own.
        if (QByteArray(context).startsWith('Q'))
            return {};
        const QString source = QString::fromUtf8(text);
        static const QRegularExpression notWords(
            QStringLiteral("\\{\\w+\\}|%L?\\d+|%n|%%|<[^>]*>|\"|\\(&.\\)|&|\\n|…"));
        QString words = source;
        words.remove(notWords);
        const qsizetype more = (words.size() + 2) / 3;
        static const QRegularExpression letter(QStringLiteral("\\w"));
        return words.contains(letter) ? source + u'·' + words.simplified().left(more) : QString();
    }
};

} // namespace axiscomp::test
