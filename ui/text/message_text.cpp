// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/message_text.h"

#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace axiscomp::ui {

namespace {

struct Step {
    const char* id;
    const char* words;
};
constexpr std::array steps{
    Step{"plan", QT_TRANSLATE_NOOP("Step", "planning")},
    Step{"backup", QT_TRANSLATE_NOOP("Step", "backing up the old state")},
    Step{"begin", QT_TRANSLATE_NOOP("Step", "checking for changes since the plan")},
    Step{"switch off", QT_TRANSLATE_NOOP("Step", "detaching the table from the axis")},
    Step{"upload", QT_TRANSLATE_NOOP("Step", "uploading the table")},
    Step{"verify", QT_TRANSLATE_NOOP("Step", "verifying the table")},
    Step{"commit", QT_TRANSLATE_NOOP("Step", "storing the table in flash")},
    Step{"switch", QT_TRANSLATE_NOOP("Step", "switching the axis over")},
    Step{"save", QT_TRANSLATE_NOOP("Step", "saving the parameters")},
    Step{"delete", QT_TRANSLATE_NOOP("Step", "deleting the table")},
    Step{"done", QT_TRANSLATE_NOOP("Step", "reading back")},
    Step{"putting back", QT_TRANSLATE_NOOP("Step", "rolling back")},
    Step{"download", QT_TRANSLATE_NOOP("Step", "reading the table")},
};

} // namespace

QString errorText(const Error& error)
{
    return sentenceText(textOf(error));
}

bool saysTheSame(const Error& a, const Error& b)
{
    return a.code == b.code && a.context == b.context;
}

QString stepText(const QString& step)
{
    const auto* const known =
        std::ranges::find_if(steps, [&](const Step& row) { return step == QLatin1String(row.id); });
    return known == steps.end() ? step : QCoreApplication::translate("Step", known->words);
}

QString sentenceText(const Text& text)
{
    return asSentence(translated(text));
}

QString asSentence(const QString& text)
{
    QString sentence = text.trimmed();
    if (sentence.isEmpty())
        return sentence;
    // An address at the beginning is not a word, and "dX" is a name.
    const qsizetype wordEnd = sentence.indexOf(u' ');
    const QStringView firstWord = QStringView(sentence).left(wordEnd);
    const bool isWord = std::ranges::all_of(firstWord, [](QChar c) { return c.isLetter(); })
        && firstWord.mid(1).toString() == firstWord.mid(1).toString().toLower();
    if (isWord)
        sentence[0] = sentence[0].toUpper();
    static const QString ends = QStringLiteral(".!?:。！？：");
    if (!ends.contains(sentence.back()))
        sentence += sentenceEnd();
    return sentence;
}

QString problemText(const Diagnostic& diagnostic)
{
    QString text = translated(textOf(diagnostic));
    if (!diagnostic.controllerError.empty())
        text += QCoreApplication::translate("Problem", " (error %1 of the controller)")
                    .arg(QString::fromStdString(diagnostic.controllerError));
    return asSentence(text);
}

} // namespace axiscomp::ui
