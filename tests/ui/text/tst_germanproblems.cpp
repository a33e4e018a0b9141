// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/directions.h"
#include "core/conversion/resampling.h"
#include "core/conversion/sign_conversion.h"
#include "core/formats/formats.h"
#include "core/neutral/table_motion.h"
#include "core/table/table_layout.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"
#include "tests/ui/support/controller_files.h"
#include "tests/ui/support/varied_tables.h"
#include "ui/text/language.h"
#include "ui/text/message_text.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <functional>

namespace tst_germanproblems {

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

/// What a German sentence may share with the English one: names of formats, keys of settings and
/// what is chosen for them, units, and words of the files of controllers.
QSet<QString> wordsThatAreKept()
{
    QSet<QString> words{QStringLiteral("nominal"), QStringLiteral("forward"),
        QStringLiteral("reverse"), QStringLiteral("bilateral"), QStringLiteral("neg"),
        QStringLiteral("pos"), QStringLiteral("joint"), QStringLiteral("default"),
        QStringLiteral("version"), QStringLiteral("radius"), QStringLiteral("positive"),
        QStringLiteral("negative"), QStringLiteral("yes"), QStringLiteral("deg"),
        QStringLiteral("inf")};
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
    static const QRegularExpression quotation(QStringLiteral(
        "\"[^\"]*\"|RepRapFirmware height map file v2|(entry|Eintrag|second) points|points ein"));
    static const QRegularExpression word(
        QStringLiteral("(?<![\\w.$#*=/,-])[a-zäöüß]{3,}(?![\\w=\\[/-]|[.,]\\w)"));
    QSet<QString> words;
    sentence.remove(quotation);
    for (auto matches = word.globalMatch(sentence); matches.hasNext();)
        words += matches.next().captured();
    return words;
}

/// Sentences that the window makes of problems and errors, in English and in German.
class Sentences {
public:
    void add(const Error& error)
    {
        addOnce(sentence(error), [error] { return errorText(error); });
    }
    void add(const std::string& remark)
    {
        addOnce(remark, [remark] { return phraseText(remark); });
    }
    void add(const Diagnostic& problem)
    {
        addOnce(message(problem), [problem] {
            // What is quoted may hold quotation marks itself.
            return problemText(problem).remove(u'"' + QString::fromStdString(problem.found) + u'"');
        });
    }
    template <typename T> void add(const Result<T>& result)
    {
        if (!result)
            add(result.error());
    }

    [[nodiscard]] qsizetype count() const { return m_known.size(); }

    /// Those whose German has a word of the English sentence.
    [[nodiscard]] QStringList untranslated() const
    {
        static const QSet<QString> kept = wordsThatAreKept();
        const Language language(QStringLiteral("de"));
        QStringList wrong;
        for (const auto& [english, make] : m_sentences) {
            const QString german = make();
            if (!((wordsOf(english) & wordsOf(german)) - kept).isEmpty())
                wrong += QStringLiteral("%1 -> %2").arg(english, german);
        }
        return wrong;
    }

private:
    using Make = std::function<QString()>;

    /// The same with other numbers is the same sentence.
    void addOnce(const std::string& said, const Make& make)
    {
        static const QRegularExpression digits(QStringLiteral("[\\d.]+"));
        const QString shape = QString::fromStdString(said).replace(digits, QStringLiteral("1"));
        if (m_known.contains(shape))
            return;
        m_known += shape;
        m_sentences.emplace_back(make(), make);
    }

    QSet<QString> m_known;
    std::vector<std::pair<QString, Make>> m_sentences;
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
        for (const std::string& remark : written->remarks)
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
                for (const std::string& remark : resampled->report.remarks)
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

/// What is wrong with the files of other controllers, and why tables cannot be converted, in a
/// German window: without English pieces.
class TestGermanProblems : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aSentenceThatIsNotTranslatedIsNoticed()
    {
        Sentences sentences;
        sentences.add(std::string("an unheard of remark"));
        sentences.add(Diagnostic{Severity::Error, DiagnosticCode::Contradiction, 1, 0, "3 points",
            "as many apples as pears"});
        sentences.add(
            Diagnostic{Severity::Error, DiagnosticCode::NotANumber, 1, 0, "the word", "a number"});
        QCOMPARE(sentences.untranslated().size(), 2);
    }

    void problemsOfDamagedFilesAreGerman_data()
    {
        addFormats([](const TableFormat& f) { return f.read != nullptr && f.facts.isText; });
    }
    void problemsOfDamagedFilesAreGerman()
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
        const QStringList wrong = sentences.untranslated();
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }

    void reasonsOfWritersAreGerman_data()
    {
        addFormats([](const TableFormat& format) { return format.write != nullptr; });
    }
    void reasonsOfWritersAreGerman()
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
        const QStringList wrong = sentences.untranslated();
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }

    void reasonsOfConversionsAreGerman()
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
                    if (converted)
                        sentences.add(converted->example);
                }
                sentences.add(conversionDifference(table, {}, test::neutralExample(1), {}, 1000));
                sentences.add(conversionDifference(test::neutralExample(2), {}, table, {}, 1000));
            }
        QVERIFY2(sentences.count() >= 60, qPrintable(QString::number(sentences.count())));
        const QStringList wrong = sentences.untranslated();
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }
};

AXISCOMP_TEST(TestGermanProblems)

} // namespace tst_germanproblems

#include "tst_germanproblems.moc"
