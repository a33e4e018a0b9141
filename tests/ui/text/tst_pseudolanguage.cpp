// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/directions.h"
#include "core/conversion/resampling/resampling.h"
#include "core/conversion/sign_conversion.h"
#include "core/formats/formats.h"
#include "core/neutral/table_motion.h"
#include "core/table/table_layout.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_files.h"
#include "tests/ui/support/pseudo_language.h"
#include "tests/ui/support/varied_tables.h"
#include "ui/text/translated_text.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

namespace tst_pseudolanguage {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

const TableLayout& layout()
{
    static const TableLayout generic = genericTableLayout();
    return generic;
}

QString text(std::string_view from)
{
    return QString::fromUtf8(from.data(), static_cast<qsizetype>(from.size()));
}

/// Names of formats, keys of settings and what is chosen for them, units, and words of the files of
/// controllers: the same in every language.
QSet<QString> wordsThatAreKept()
{
    QSet<QString> words{QStringLiteral("nominal"), QStringLiteral("forward"),
        QStringLiteral("reverse"), QStringLiteral("bilateral"), QStringLiteral("neg"),
        QStringLiteral("pos"), QStringLiteral("joint"), QStringLiteral("version"),
        QStringLiteral("radius"), QStringLiteral("yes"), QStringLiteral("deg"),
        QStringLiteral("inf"), QStringLiteral("crosscomp"), QStringLiteral("ssfk"),
        QStringLiteral("points"), QStringLiteral("default"), QStringLiteral("height"),
        QStringLiteral("map"), QStringLiteral("file"), QStringLiteral("other")};
    static const QRegularExpression separator(QStringLiteral("[^a-z]+"));
    for (const TableFormat* format : tableFormats()) {
        words += text(format->facts.name);
        for (const FormatSetting& setting : format->facts.settings)
            for (const std::string_view part : {setting.key, setting.choices})
                for (const QString& word : text(part).split(separator, Qt::SkipEmptyParts))
                    words += word;
    }
    return words;
}

/// The words of a sentence in lower case, without quotations, names, keys and numbers.
QSet<QString> wordsOf(QString sentence)
{
    static const QRegularExpression quotation(
        QStringLiteral("\"[^\"]*\"|RepRapFirmware height map file v2"));
    static const QRegularExpression word(
        QStringLiteral("(?<![\\w.$#*=/,-])[a-z]{3,}(?![\\w=\\[/-]|[.,]\\w)"));
    QSet<QString> words;
    sentence.remove(quotation);
    for (auto matches = word.globalMatch(sentence); matches.hasNext();)
        words += matches.next().captured();
    return words;
}

/// Sentences that the window makes of problems and errors, in the language of brackets.
class Sentences {
public:
    void add(const Text& text)
    {
        static const QRegularExpression digits(QStringLiteral("[\\d.]+"));
        const QString shape =
            QString::fromStdString(text.english()).replace(digits, QStringLiteral("1"));
        if (m_known.contains(shape)) // the same with other numbers is the same sentence
            return;
        m_known += shape;
        const QString outside = test::outsideBrackets(translated(text));
        if (const auto words = wordsOf(outside) - m_kept; !words.isEmpty())
            m_untranslated += QStringLiteral("%1 -> %2").arg(shape, translated(text));
    }
    void add(const Error& error) { add(textOf(error)); }
    void add(const Diagnostic& problem) { add(textOf(problem)); }
    template <typename T> void add(const Result<T>& result)
    {
        if (!result)
            add(result.error());
    }

    [[nodiscard]] qsizetype count() const { return m_known.size(); }
    /// Those with words outside of the brackets.
    [[nodiscard]] const QStringList& untranslated() const { return m_untranslated; }

private:
    const QSet<QString> m_kept = wordsThatAreKept();
    QSet<QString> m_known;
    QStringList m_untranslated;
};

void addFormats(bool (*isWanted)(const TableFormat&))
{
    QTest::addColumn<const TableFormat*>("format");
    for (const TableFormat* format : tableFormats())
        if (isWanted(*format))
            QTest::newRow(std::string(format->facts.name).c_str()) << format;
}

FormatSettings neededSettings(const FormatFacts& facts, bool isWriting)
{
    FormatSettings settings;
    for (const FormatSetting& setting : facts.settings)
        if (setting.isNeeded && (isWriting ? setting.forWriting : setting.forReading))
            settings[std::string(setting.key)] = "1000";
    return settings;
}

/// The needed settings, and each of the others with values that fit and that do not.
std::vector<FormatSettings> variedSettings(const FormatFacts& facts, bool isWriting)
{
    std::vector<FormatSettings> varied{neededSettings(facts, isWriting), {},
        {{"position-unit", "mm"}, {"value-unit", "kg"}}, {{"position-unit", "deg"}},
        {{"unheard-of", "1"}}, {{"list-unit", "increments"}, {"increments-per-unit", "10"}}};
    for (const FormatSetting& setting : formatSettings(facts, isWriting))
        for (const char* value : {"0", "-1", "1", "7", "40", "128", "1e-9", "x y", "yes", "rotary",
                 "increments", "primary", "mm"}) {
            varied.push_back(neededSettings(facts, isWriting));
            varied.back()[std::string(setting.key)] = value;
        }
    return varied;
}

void read(const TableFormat& format, const QString& file, const FormatSettings& settings,
    Sentences& sentences)
{
    TableReadOptions options;
    options.dimensions = 2;
    options.settings = settings;
    const auto reading = format.read(file.toStdString(), options);
    sentences.add(reading);
    if (reading)
        for (const Diagnostic& problem : reading->diagnostics)
            sentences.add(problem);
}

void write(const TableFormat& format, const std::vector<NeutralTable>& tables,
    const FormatSettings& settings, Sentences& sentences)
{
    for (const NeutralTable& table : tables)
        if (!checkConsistent(table))
            return;
    if (const auto holds = checkHolds(format.facts, tables); !holds)
        return sentences.add(holds);
    TableWriteOptions options;
    options.layout = &layout();
    options.settings = settings;
    const auto written = format.write(tables, options);
    sentences.add(written);
    if (written)
        for (const Text& remark : written->remarks)
            sentences.add(remark);
}

void resampleAll(const NeutralTable& table, Sentences& sentences)
{
    const AxisRequest requests[] = {{}, {.points = 1}, {.points = 5}, {.points = 50'000'000},
        {.points = 4, .distance = 2}, {.distance = 7}, {.distance = -1}, {.distance = 1e-9},
        {.distance = 100}, {.distance = 7, .start = -20.0}, {.distance = 7, .end = 90.0},
        {.start = 5.0}, {.points = 3, .start = 5.0, .end = 2.0},
        {.points = 9'000'000, .start = 5.0, .end = 5.0 + 1e-8}};
    for (const AxisRequest& request : requests)
        for (const bool holdsEnds : {false, true}) {
            ResamplingRequest wanted{.holdsEnds = holdsEnds};
            wanted.axes.assign(table.axes.size(), request);
            const auto resampled = resample(table, wanted);
            sentences.add(resampled);
            if (resampled)
                for (const Text& remark : resampled->report.remarks)
                    sentences.add(remark);
        }
    sentences.add(resample(table, {}));
    for (const double deviation : {1e-7, -1.0, 0.1})
        for (const GridLimits& limits : {GridLimits{}, GridLimits{.mostPoints = 3},
                 GridLimits{.mostPoints = 9}, GridLimits{.mostPerAxis = {2, 2, 2}},
                 GridLimits{.mostPerAxis = {1}}, GridLimits{.mostPerAxis = {3, 3}}})
            sentences.add(coarsestGrid(table, deviation, ResamplingMethod::Linear, limits));
}

} // namespace

/// In a language that is nothing but a translation file made from the sources, nothing that a
/// sentence of core says stands outside of it but names and numbers.
class TestPseudoLanguage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_language.isValid()); }
    void init() { test::failOnWarnings(); }

    void aSentenceThatIsNotTranslatedIsNoticed()
    {
        Sentences sentences;
        sentences.add(Text(Verbatim{"an unheard of remark"}));
        sentences.add(Text(TextPattern{"Error", "words that no source has", nullptr}));
        sentences.add(Diagnostic{Severity::Error, DiagnosticCode::NotANumber, 1, 0,
            Verbatim{"the word"}, AXISCOMP_TEXT("Error", "a finite number")});
        QCOMPARE(sentences.untranslated().size(), 2);
    }

    void everyErrorIsTranslated()
    {
        Sentences sentences;
        for (const ErrorCode code : allErrorCodes())
            sentences.add(Text(errorPattern(code)));
        QCOMPARE(sentences.untranslated(), QStringList());
    }

    void whatTheDialogsSayAboutFormatsIsTranslated()
    {
        Sentences sentences;
        QStringList untranslated;
        for (const TableFormat* format : tableFormats()) {
            sentences.add(Text(format->facts.description));
            for (const FormatSetting& setting : format->facts.settings) {
                sentences.add(Text(setting.meaning));
                QStringList words =
                    text(setting.choices).split(QStringLiteral(", "), Qt::SkipEmptyParts);
                words += text(setting.key).replace(u'-', u' ');
                for (const QString& word : words)
                    if (word.size() > 1 && word[0].isLetter() && word != QStringLiteral("mm")
                        && QCoreApplication::translate("Setting", word.toUtf8().constData())
                            == word)
                        untranslated += word;
            }
        }
        QCOMPARE(sentences.untranslated(), QStringList());
        QVERIFY2(untranslated.isEmpty(), qPrintable(untranslated.join(u'\n')));
    }

    void problemsOfDamagedFilesAreTranslated_data()
    {
        addFormats([](const TableFormat& f) { return f.read != nullptr && f.facts.isText; });
    }
    void problemsOfDamagedFilesAreTranslated()
    {
        QFETCH(const TableFormat*, format);
        const QString file = test::controllerFile(text(format->facts.name));
        QVERIFY(!file.isEmpty());
        Sentences sentences;
        for (const FormatSettings& settings : variedSettings(format->facts, false))
            read(*format, file, settings, sentences);
        const FormatSettings needed = neededSettings(format->facts, false);
        for (const QString& damaged : test::damagedTexts(file))
            read(*format, damaged, needed, sentences);
        QVERIFY2(sentences.count() >= 15, qPrintable(QString::number(sentences.count())));
        QVERIFY2(
            sentences.untranslated().isEmpty(), qPrintable(sentences.untranslated().join(u'\n')));
    }

    void reasonsOfWritersAreTranslated_data()
    {
        addFormats([](const TableFormat& format) { return format.write != nullptr; });
    }
    void reasonsOfWritersAreTranslated()
    {
        QFETCH(const TableFormat*, format);
        Sentences sentences;
        const auto most = static_cast<std::size_t>(format->facts.mostDimensions);
        const FormatSettings needed = neededSettings(format->facts, true);
        for (std::size_t dimensions = 1; dimensions <= 3; ++dimensions)
            for (const NeutralTable& table : test::variedTables(dimensions)) {
                write(*format, {table}, needed, sentences);
                write(*format, {table, table}, needed, sentences);
            }
        for (const FormatSettings& settings : variedSettings(format->facts, true))
            write(*format, {test::neutralExample(most)}, settings, sentences);
        QVERIFY2(sentences.count() >= 5, qPrintable(QString::number(sentences.count())));
        QVERIFY2(
            sentences.untranslated().isEmpty(), qPrintable(sentences.untranslated().join(u'\n')));
    }

    void reasonsOfConversionsAreTranslated()
    {
        Sentences sentences;
        for (std::size_t dimensions = 1; dimensions <= 3; ++dimensions)
            for (const NeutralTable& table : test::variedTables(dimensions)) {
                resampleAll(table, sentences);
                for (const auto choice :
                    {DirectionChoice::Mean, DirectionChoice::Positive, DirectionChoice::Negative})
                    sentences.add(mergeDirections(table, choice));
                for (const auto to : {SignConvention::Feedback, SignConvention::Command}) {
                    const auto converted = convertSign(table, to, {});
                    sentences.add(converted);
                    if (!converted)
                        continue;
                    const bool toCommand = to == SignConvention::Command;
                    sentences.add(table.sign == to ? examplePoint(table)
                            : toCommand            ? examplePoint(table, converted->table)
                                                   : examplePoint(converted->table, table));
                }
                sentences.add(conversionDifference(table, {}, test::neutralExample(1), {}, 1000));
                sentences.add(conversionDifference(test::neutralExample(2), {}, table, {}, 1000));
            }
        QVERIFY2(sentences.count() >= 60, qPrintable(QString::number(sentences.count())));
        QVERIFY2(
            sentences.untranslated().isEmpty(), qPrintable(sentences.untranslated().join(u'\n')));
    }

private:
    const test::PseudoLanguage m_language;
};

AXISCOMP_TEST(TestPseudoLanguage)

} // namespace tst_pseudolanguage

#include "tst_pseudolanguage.moc"
