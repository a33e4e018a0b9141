// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/message_text.h"

#include "ui/text/phrase_book.h"

#include <QCoreApplication>
#include <QSet>

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
    Step{"backup", QT_TRANSLATE_NOOP("Step", "keeping the old state in a backup")},
    Step{"begin", QT_TRANSLATE_NOOP("Step", "checking that nothing has changed meanwhile")},
    Step{"switch off", QT_TRANSLATE_NOOP("Step", "switching the axis to no table")},
    Step{"upload", QT_TRANSLATE_NOOP("Step", "uploading the table")},
    Step{"verify", QT_TRANSLATE_NOOP("Step", "verifying the table")},
    Step{"commit", QT_TRANSLATE_NOOP("Step", "storing the table in flash")},
    Step{"switch", QT_TRANSLATE_NOOP("Step", "switching the axis over")},
    Step{"save", QT_TRANSLATE_NOOP("Step", "saving the parameters")},
    Step{"done", QT_TRANSLATE_NOOP("Step", "reading back")},
    Step{"putting back", QT_TRANSLATE_NOOP("Step", "putting the old state back")},
    Step{"download", QT_TRANSLATE_NOOP("Step", "reading the table")},
};

/// What is wrong, and what to do about it where the expected text does not say that already.
struct Words {
    const char* problem;
    const char* wayOut;
    bool quotesFile = false; ///< what was found are characters of the file
};

Words wordsOf(DiagnosticCode code)
{
    switch (code) {
    case DiagnosticCode::EmptyFile:
        return {QT_TRANSLATE_NOOP("Problem", "the file holds no data"),
            QT_TRANSLATE_NOOP("Problem",
                "a calibration file has a header line and one line per grid point; save an "
                "example file to see one")};
    case DiagnosticCode::NoHeader:
        return {QT_TRANSLATE_NOOP(
                    "Problem", "the header line with the names of the columns is missing"),
            QT_TRANSLATE_NOOP("Problem", "add a first line such as X [mm],Table 1 [mm]"), true};
    case DiagnosticCode::TooFewColumns:
        return {QT_TRANSLATE_NOOP("Problem", "the header has too few columns"),
            QT_TRANSLATE_NOOP("Problem", "choose the dimensionality that the file has")};
    case DiagnosticCode::ColumnCount:
        return {
            QT_TRANSLATE_NOOP("Problem", "this line does not have as many columns as the header"),
            ""};
    case DiagnosticCode::NotANumber:
        return {QT_TRANSLATE_NOOP("Problem", "this is not a number"), "", true};
    case DiagnosticCode::NotFinite:
        return {QT_TRANSLATE_NOOP("Problem", "this number is not finite"), "", true};
    case DiagnosticCode::MixedDecimals:
        return {QT_TRANSLATE_NOOP("Problem", "decimal comma and decimal point are mixed"),
            QT_TRANSLATE_NOOP("Problem", "use the same decimal sign in every number"), true};
    case DiagnosticCode::UnterminatedQuote:
        return {QT_TRANSLATE_NOOP("Problem", "a quotation mark is not closed as it should be"), "",
            true};
    case DiagnosticCode::DuplicatePoint:
        return {QT_TRANSLATE_NOOP("Problem", "the same position occurs twice"),
            QT_TRANSLATE_NOOP("Problem", "delete one of the two lines")};
    case DiagnosticCode::MissingPoint:
        return {QT_TRANSLATE_NOOP("Problem", "the grid is incomplete"),
            QT_TRANSLATE_NOOP(
                "Problem", "measure the missing points, or resample the data onto a full grid")};
    case DiagnosticCode::UnevenSpacing:
        return {QT_TRANSLATE_NOOP("Problem", "the positions are not evenly spaced"),
            QT_TRANSLATE_NOOP("Problem", "resample the data onto an even grid")};
    case DiagnosticCode::TooFewPoints:
        return {QT_TRANSLATE_NOOP("Problem", "there are too few points"), ""};
    case DiagnosticCode::TooLarge:
        return {QT_TRANSLATE_NOOP("Problem", "the file is too large"),
            QT_TRANSLATE_NOOP("Problem", "choose a coarser grid, or split the file")};
    case DiagnosticCode::NotText:
        return {QT_TRANSLATE_NOOP("Problem", "this is not a text file"),
            QT_TRANSLATE_NOOP("Problem", "save it as UTF-8 CSV")};
    case DiagnosticCode::IoError:
        return {QT_TRANSLATE_NOOP("Problem", "the file cannot be read"), ""};
    case DiagnosticCode::Encoding:
        return {
            QT_TRANSLATE_NOOP("Problem", "the file is not valid UTF-8 and is read as Windows-1252"),
            QT_TRANSLATE_NOOP("Problem", "check the names and notes, or save it as UTF-8 CSV")};
    case DiagnosticCode::RoundedSpacing:
        return {QT_TRANSLATE_NOOP(
                    "Problem", "the positions are even only within the printed precision"),
            QT_TRANSLATE_NOOP(
                "Problem", "the even grid is used; print more decimals if that is not meant")};
    case DiagnosticCode::FloatPrecision:
        return {
            QT_TRANSLATE_NOOP("Problem", "a value loses precision when it is stored as float32"),
            QT_TRANSLATE_NOOP("Problem", "check the unit of the values")};
    case DiagnosticCode::LargeGradient:
        return {
            QT_TRANSLATE_NOOP("Problem", "the table is very steep, which is likely a unit mistake"),
            QT_TRANSLATE_NOOP("Problem", "the values must be in the unit of the positions")};
    case DiagnosticCode::ConstantTable:
        return {QT_TRANSLATE_NOOP("Problem", "all values of the table are equal"),
            QT_TRANSLATE_NOOP("Problem", "check that this column is meant")};
    case DiagnosticCode::Syntax:
        return {
            QT_TRANSLATE_NOOP("Problem", "this is not written as the format demands"), "", true};
    case DiagnosticCode::Contradiction:
        return {
            QT_TRANSLATE_NOOP("Problem", "two statements of the file contradict each other"), ""};
    case DiagnosticCode::NotMonotonic:
        return {QT_TRANSLATE_NOOP("Problem", "the positions do not go in one direction"), ""};
    case DiagnosticCode::NotPeriodic:
        return {QT_TRANSLATE_NOOP("Problem", "the table does not close after one revolution"), ""};
    case DiagnosticCode::LimitExceeded:
        return {QT_TRANSLATE_NOOP("Problem", "the controller does not take as much"), ""};
    case DiagnosticCode::UnknownKey:
        return {QT_TRANSLATE_NOOP("Problem", "this entry is not known and is left out"), "", true};
    case DiagnosticCode::UnitNotGiven:
        return {QT_TRANSLATE_NOOP("Problem", "the file does not say a unit"), ""};
    case DiagnosticCode::Assumption:
        return {QT_TRANSLATE_NOOP("Problem", "the file can be understood in several ways"), ""};
    }
    return {"", ""};
}

QString problemWords(const char* text)
{
    return *text == '\0' ? QString() : QCoreApplication::translate("Problem", text);
}

QString foundText(const Diagnostic& diagnostic, bool quotesFile)
{
    if (diagnostic.found.empty())
        return diagnostic.code == DiagnosticCode::NotANumber
            ? QCoreApplication::translate("Problem", "found an empty cell")
            : QString();
    const QString found =
        quotesFile ? QString::fromStdString(diagnostic.found) : translatedPhrase(diagnostic.found);
    if (diagnostic.code == DiagnosticCode::IoError)
        return found;
    return quotesFile ? QCoreApplication::translate("Problem", "found \"%1\"").arg(found)
                      : QCoreApplication::translate("Problem", "found %1").arg(found);
}

} // namespace

QString errorText(const Error& error)
{
    const std::string text(errorTemplate(error));
    const QString sentence = QCoreApplication::translate("Error", text.c_str());
    ErrorContext context;
    for (const auto& [key, value] : error.context)
        context.emplace(key, placeholderText(QString::fromStdString(key), value).toStdString());
    return asSentence(QString::fromStdString(fillTemplate(sentence.toStdString(), context)));
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

QString phraseText(const std::string& english)
{
    return asSentence(translatedPhrase(english));
}

QString asSentence(const QString& text)
{
    QString sentence = text.trimmed();
    if (sentence.isEmpty())
        return sentence;
    // An address at the beginning is not a word.
    const qsizetype wordEnd = sentence.indexOf(u' ');
    const QStringView firstWord = QStringView(sentence).left(wordEnd);
    const bool isWord = std::ranges::all_of(firstWord, [](QChar c) { return c.isLetter(); });
    if (isWord)
        sentence[0] = sentence[0].toUpper();
    static const QString ends = QStringLiteral(".!?:");
    if (!ends.contains(sentence.back()))
        sentence += u'.';
    return sentence;
}

bool isProblemPhrase(const QString& english)
{
    static const QSet<QString> phrases = [] {
        QSet<QString> all;
        for (int i = 0; i <= static_cast<int>(DiagnosticCode::Assumption); ++i) {
            const Words words = wordsOf(static_cast<DiagnosticCode>(i));
            all << QString::fromUtf8(words.problem) << QString::fromUtf8(words.wayOut);
        }
        all.remove({});
        return all;
    }();
    return phrases.contains(english);
}

QString problemText(const Diagnostic& diagnostic)
{
    const Words words = wordsOf(diagnostic.code);
    QString text = problemWords(words.problem);
    if (const QString found = foundText(diagnostic, words.quotesFile); !found.isEmpty())
        text += QStringLiteral(": ") + found;
    if (!diagnostic.expected.empty())
        text += QCoreApplication::translate("Problem", ", expected %1")
                    .arg(translatedPhrase(diagnostic.expected));
    if (const QString wayOut = problemWords(words.wayOut); !wayOut.isEmpty())
        text += QStringLiteral("; ") + wayOut;
    if (!diagnostic.controllerError.empty())
        text += QCoreApplication::translate("Problem", " (error %1 of the controller)")
                    .arg(QString::fromStdString(diagnostic.controllerError));
    return asSentence(text);
}

} // namespace axiscomp::ui
