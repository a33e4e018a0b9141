// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/table_motion.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

#include <QLocale>

#include <algorithm>
#include <limits>
#include <locale>

namespace tst_formatcontract {

using namespace axiscomp;
using test::FormatSample;
using test::mentions;
using test::problemLines;

namespace {

/// In the order of the registry; a format that is not described has no format.
const std::vector<FormatSample>& samples()
{
    static const std::vector<FormatSample> all = [] {
        std::vector<FormatSample> result;
        for (const TableFormat* format : tableFormats()) {
            FormatSample sample;
            for (const auto& [described, describe] : test::describedFormats())
                if (described == format) {
                    sample.format = format;
                    describe(sample);
                }
            result.push_back(std::move(sample));
        }
        return result;
    }();
    return all;
}

std::string nameOf(const FormatSample& sample)
{
    return std::string(sample.format->facts.name);
}

bool isAny(const FormatSample&)
{
    return true;
}
bool isRead(const FormatSample& sample)
{
    return !sample.text.empty();
}
bool isReadAsText(const FormatSample& sample)
{
    return isRead(sample) && sample.format->facts.isText;
}
bool isWritten(const FormatSample& sample)
{
    return !sample.written.empty();
}

void addFormats(bool (*concerns)(const FormatSample&))
{
    QTest::addColumn<int>("format");
    for (std::size_t i = 0; i < samples().size(); ++i)
        if (samples()[i].format && concerns(samples()[i]))
            QTest::newRow(nameOf(samples()[i]).c_str()) << static_cast<int>(i);
}

/// A row for each of these of each format.
template <class Row> void addRows(std::vector<Row> FormatSample::*rows)
{
    QTest::addColumn<int>("format");
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < samples().size(); ++i)
        for (std::size_t n = 0; n < (samples()[i].*rows).size(); ++n)
            QTest::addRow(
                "%s, %s", nameOf(samples()[i]).c_str(), (samples()[i].*rows)[n].name.c_str())
                << static_cast<int>(i) << static_cast<int>(n);
}

const FormatSample& sample()
{
    QFETCH(int, format);
    return samples()[static_cast<std::size_t>(format)];
}
template <class Row> const Row& row(std::vector<Row> FormatSample::*rows)
{
    QFETCH(int, row);
    return (sample().*rows)[static_cast<std::size_t>(row)];
}

TableReadOptions readOptions(const FormatSample::Settings& settings = {})
{
    TableReadOptions options = sample().reading;
    options.settings = settings.value_or(options.settings);
    return options;
}
TableWriteOptions writeOptions(const FormatSample::Settings& settings = {})
{
    TableWriteOptions options = sample().writing;
    options.settings = settings.value_or(options.settings);
    return options;
}

/// What a file turned out to be. Binary files are refused by an error, texts by problems.
struct Outcome {
    std::vector<NeutralTable> tables;
    std::vector<Diagnostic> problems;
    std::string refusal; ///< empty: there are tables
};
Outcome outcomeOf(std::string_view text)
{
    const auto reading = sample().format->read(text, readOptions());
    if (!reading)
        return {{}, {}, test::describe(reading.error())};
    return {reading->tables, reading->diagnostics,
        reading->hasErrors() ? problemLines(*reading) : std::string()};
}

/// Why an outcome is none that a reader may have: either tables that are tables, or an error at a
/// place of the file that says something.
std::string faultOf(const Outcome& outcome, std::string_view text)
{
    if (outcome.tables.empty() == outcome.refusal.empty())
        return outcome.tables.empty() ? "neither a table nor an error"
                                      : "a table in spite of " + outcome.refusal;
    for (const NeutralTable& table : outcome.tables)
        if (const auto consistent = checkConsistent(table); !consistent)
            return "a table that is none: " + test::describe(consistent.error());
    const auto lines = static_cast<std::size_t>(std::ranges::count_if(text, [](char c) {
        return c == '\n' || c == '\r';
    })) + 1;
    for (const Diagnostic& problem : outcome.problems)
        if (message(problem).empty() || problem.line > lines + 1)
            return "line " + std::to_string(problem.line) + ": " + message(problem);
    return {};
}

/// What a table can be, in words: compared with what each format's test says.
std::string factsText(const TableFormat& format)
{
    const FormatFacts& facts = format.facts;
    const auto upTo = [](std::size_t number) {
        return number == 0 ? std::string("any") : std::to_string(number);
    };
    constexpr std::array knots{"any", "even", "square"};
    std::string text = std::string(signName(facts.sign)) + " is "
        + std::string(evidenceName(facts.signEvidence)) + "; "
        + std::to_string(facts.fewestDimensions) + " to " + std::to_string(facts.mostDimensions)
        + " dimensions, " + knots[static_cast<std::size_t>(facts.knots)] + " knots; points "
        + upTo(facts.mostPoints) + ", columns " + upTo(facts.mostColumns) + ", tables "
        + upTo(facts.mostTables) + ", bytes " + upTo(facts.mostBytes) + "; holds";
    const std::array holds{std::pair(facts.holdsNames, " names"),
        std::pair(facts.holdsUnits, " units"), std::pair(facts.holdsNotes, " notes"),
        std::pair(facts.holdsDirections, " directions"), std::pair(facts.holdsWrap, " wrap"),
        std::pair(facts.holdsPersistency, " persistency"), std::pair(!facts.isText, " bytes")};
    for (const auto& [isHeld, word] : holds)
        text += isHeld ? word : "";
    return text;
}

std::string withLineEnds(const std::string& text, std::string_view end)
{
    std::string result;
    for (const char c : text)
        c == '\n' ? result.append(end) : result.append(1, c);
    return result;
}

/// Each value again along an axis that is as much longer, so that it stays even.
NeutralTable grown(NeutralTable table, std::size_t axis, std::size_t knots)
{
    const std::size_t stride = strideOf(table, axis);
    const std::size_t before = table.axes[axis].knots.size();
    const double first = table.axes[axis].knots[0];
    const double distance = table.axes[axis].knots[1] - first;
    table.axes[axis] =
        test::evenAxis(table.axes[axis].name, table.axes[axis].unit, first, distance, knots);
    for (CompensationColumn& column : table.columns) {
        std::vector<double> values;
        for (std::size_t i = 0; i < table.pointCount(); ++i) {
            const std::size_t inAxis = i / stride % knots % before;
            values.push_back(
                column.values[i % stride + stride * (inAxis + before * (i / stride / knots))]);
        }
        column.values = std::move(values);
    }
    return table;
}

/// Without blanks round the notes, which a line may have at its end.
std::vector<NeutralTable> withTrimmedNotes(std::vector<NeutralTable> tables)
{
    for (NeutralTable& table : tables)
        for (std::string& note : table.notes)
            note = trimmed(note);
    return tables;
}
bool isTheSame(const Outcome& outcome, const std::vector<NeutralTable>& tables)
{
    return outcome.problems.empty() && withTrimmedNotes(outcome.tables) == tables;
}

const NeutralTable& heldTable()
{
    return sample().written.front().tables.front();
}

/// As on a German computer, whose numbers have commas.
class GermanLocale {
public:
    GermanLocale()
    {
        struct Commas : std::numpunct<char> {
            char do_decimal_point() const override { return ','; }
            char do_thousands_sep() const override { return '.'; }
            std::string do_grouping() const override { return "\3"; }
        };
        m_before = std::locale::global(std::locale(std::locale(), new Commas));
        QLocale::setDefault(QLocale(QLocale::German));
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_CH.UTF-8", "German"})
            if (std::setlocale(LC_NUMERIC, name))
                break;
    }
    ~GermanLocale()
    {
        std::setlocale(LC_NUMERIC, "C");
        std::locale::global(m_before);
        QLocale::setDefault(QLocale::c());
    }

private:
    std::locale m_before;
};

/// A softMC file has no names: what its writer knows is not read from it. A KMotion file has a
/// place for each axis, whichever the table names first.
std::vector<NeutralTable> withTargetsOf(
    std::vector<NeutralTable> read, const std::vector<NeutralTable>& held)
{
    for (std::size_t t = 0; t < std::min(read.size(), held.size()); ++t)
        for (std::size_t c = 0; c < std::min(read[t].columns.size(), held[t].columns.size()); ++c)
            if (sample().format == &softmc::format())
                read[t].columns[c].target = held[t].columns[c].target;
    if (sample().format != &kmotion_geo::format() && sample().format != &heidenhain_com::format())
        return read;
    for (std::size_t t = 0; t < std::min(read.size(), held.size()); ++t)
        std::ranges::sort(read[t].columns, {}, [&](const CompensationColumn& column) {
            return std::ranges::find(held[t].columns, column.target, &CompensationColumn::target)
                - held[t].columns.begin();
        });
    return read;
}

} // namespace

/// A reader may have this outcome.
#define VERIFY_SOUND(outcome, text)                                                                \
    do {                                                                                           \
        const std::string fault = faultOf(outcome, text);                                          \
        QVERIFY2(fault.empty(), fault.c_str());                                                    \
    } while (false)

class TestFormatContract : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyFormatIsDescribed()
    {
        for (std::size_t i = 0; i < samples().size(); ++i)
            QVERIFY2(samples()[i].format, tableFormats()[i]->facts.name.data());
        QCOMPARE(test::describedFormats().size(), samples().size());
    }

    void theFactsAreComplete_data() { addFormats(isAny); }
    void theFactsAreComplete()
    {
        const TableFormat& format = *sample().format;
        const FormatFacts& facts = format.facts;
        QVERIFY2(factsText(format) == sample().facts, factsText(format).c_str());
        QCOMPARE(format.read != nullptr, isRead(sample()));
        QCOMPARE(format.write != nullptr, isWritten(sample()));
        QVERIFY(format.read || format.write);
        QCOMPARE(format.recognise != nullptr, isReadAsText(sample()));
        QCOMPARE(formatNamed(facts.name).value(), &format); // which it would not be with a twin
        QVERIFY(!facts.controller.empty() && !facts.numbers.empty());
        QVERIFY(!Text(facts.description).isEmpty());
        QVERIFY(!facts.extensions.empty());
        for (const std::string_view extension : facts.extensions)
            QVERIFY(extension.size() > 1 && extension.front() == '.');
        QVERIFY(1 <= facts.fewestDimensions && facts.fewestDimensions <= facts.mostDimensions);
        QVERIFY(facts.mostDimensions <= 3);
        QVERIFY(!facts.rules.empty());
        const auto isPublished = [](Evidence evidence) { return evidence == Evidence::Published; };
        QVERIFY(!facts.assumptions.empty()
            || (isPublished(facts.signEvidence) && isPublished(facts.outsideEvidence)));
        for (const FormatSetting& setting : facts.settings) {
            QVERIFY2(!Text(setting.meaning).isEmpty(), setting.key.data());
            QVERIFY2(setting.forReading || setting.forWriting, setting.key.data());
            QCOMPARE(setting.choices.empty(), setting.kind != FormatSetting::Kind::Choice);
        }
    }

    void aFileIsReadWithoutAProblem_data() { addFormats(isRead); }
    void aFileIsReadWithoutAProblem()
    {
        const Outcome outcome = outcomeOf(sample().text);
        VERIFY_SOUND(outcome, sample().text);
        QVERIFY2(outcome.refusal.empty(), outcome.refusal.c_str());
        QVERIFY2(outcome.problems.empty(),
            outcome.problems.empty() ? "" : message(outcome.problems.front()).c_str());
        for (const NeutralTable& table : outcome.tables)
            QCOMPARE(table.sign, sample().format->facts.sign);
    }

    void aTableIsAppliedAsByItsController_data()
    {
        addFormats([](const FormatSample& sample) { return !sample.applied.empty(); });
    }
    void aTableIsAppliedAsByItsController()
    {
        for (const FormatSample::Applied& applied : sample().applied) {
            const std::string& text = applied.text.empty() ? sample().text : applied.text;
            const auto reading = sample().format->read(text, readOptions());
            VERIFY_RESULT(reading);
            QVERIFY2(!reading->tables.empty(), problemLines(*reading).c_str());
            const NeutralTable& table = reading->tables.front();
            const ControllerLookup compensation(
                table, applied.column, sample().format->facts.behaviour);
            const double found = compensation.at(applied.position);
            QVERIFY2(found == applied.value || qFuzzyCompare(found, applied.value),
                (toText(found) + " instead of " + toText(applied.value) + " at "
                    + positionText(table, applied.position).english())
                    .c_str());
        }
    }

    void lineEndsAndBlanksMakeNoDifference_data() { addFormats(isReadAsText); }
    void lineEndsAndBlanksMakeNoDifference()
    {
        const std::string& text = sample().text;
        const auto plain = withTrimmedNotes(outcomeOf(text).tables);
        std::vector<std::string> spellings{withLineEnds(text, "\r\n"), withLineEnds(text, "\r"),
            withLineEnds(text, " \n"), withLineEnds(text, "\t \r\n"), "\xEF\xBB\xBF" + text,
            "\xEF\xBB\xBF" + withLineEnds(text, "\r\n")};
        if (text.ends_with('\n'))
            spellings.push_back(text.substr(0, text.size() - 1));
        for (const std::string& spelling : spellings) {
            QVERIFY2(isTheSame(outcomeOf(spelling), plain), spelling.c_str());
            QVERIFY2(sample().format->recognise(spelling) == sample().format->recognise(text),
                spelling.c_str());
        }
        QVERIFY(isTheSame(outcomeOf(text + "\n\r\n  \r\n\n"), plain));
    }

    void aLineMayEndAnywhereInABlockOfCharacters_data() { addFormats(isReadAsText); }
    void aLineMayEndAnywhereInABlockOfCharacters()
    {
        const auto plain = withTrimmedNotes(outcomeOf(sample().text).tables);
        for (std::size_t blanks = 0; blanks < 2 * CharacterSet::blockSize + 2; ++blanks) {
            const std::string end = std::string(blanks, ' ') + "\r\n";
            QVERIFY2(isTheSame(outcomeOf(withLineEnds(sample().text, end)), plain),
                std::to_string(blanks).c_str());
        }
    }

    void lettersOfOtherEncodingsAreKeptAsUtf8_data()
    {
        addFormats([](const FormatSample& sample) { return !sample.comment.empty(); });
    }
    void lettersOfOtherEncodingsAreKeptAsUtf8()
    {
        const Outcome plain = outcomeOf(sample().text);
        for (const char* word : {"M\xFCller\n", "M\xC3\xBCller\n"}) {
            Outcome outcome = outcomeOf(sample().comment + word + sample().text);
            QVERIFY2(outcome.refusal.empty(), outcome.refusal.c_str());
            QCOMPARE(outcome.tables.size(), plain.tables.size());
            for (std::size_t i = 0; i < plain.tables.size(); ++i) {
                COMPARE_TABLES(outcome.tables[i], plain.tables[i], 0.0);
                for (const std::string& note : outcome.tables[i].notes)
                    QCOMPARE(note, toUtf8(note, Encoding::Utf8));
            }
        }
    }

    void aFileWithoutATableIsRefused_data() { addFormats(isReadAsText); }
    void aFileWithoutATableIsRefused()
    {
        for (const char* empty : {"", "\n", "\n \n\t\n", "\r\n\r\n", "\xEF\xBB\xBF"}) {
            const auto reading = sample().format->read(empty, readOptions());
            VERIFY_RESULT(reading);
            QVERIFY(reading->tables.empty());
            QVERIFY2(problemLines(*reading).starts_with("0:0 EmptyFile"),
                problemLines(*reading).c_str());
            QCOMPARE(sample().format->recognise(empty), Recognition::No);
        }
        if (sample().comment.empty())
            return;
        const std::string comments = sample().comment + "nothing\n" + sample().comment + "else\n";
        const Outcome outcome = outcomeOf(comments);
        VERIFY_SOUND(outcome, comments);
        QVERIFY(!outcome.refusal.empty());
        QCOMPARE(sample().format->recognise(comments), Recognition::No);
    }

    void aFileThatIsNoTextIsRefused_data() { addFormats(isReadAsText); }
    void aFileThatIsNoTextIsRefused()
    {
        std::string text = sample().text;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const char before = std::exchange(text[i], '\0');
            const auto reading = sample().format->read(text, readOptions());
            VERIFY_RESULT(reading);
            QVERIFY(reading->tables.empty());
            const auto line =
                std::count(text.begin(), text.begin() + static_cast<long>(i), '\n') + 1;
            QVERIFY2(problemLines(*reading).starts_with(std::to_string(line) + ":0 NotText"),
                problemLines(*reading).c_str());
            text[i] = before;
        }
        for (const char* binary :
            {"\x01\x02\x03\x04\x05\x06\x07\x08", "\x7f\x45\x4c\x46\x01\x01\x01"}) {
            const auto reading = sample().format->read(binary, readOptions());
            VERIFY_RESULT(reading);
            QVERIFY(problemLines(*reading).starts_with("0:0 NotText"));
        }
    }

    void aFileThatIsCutOffIsRefused_data() { addFormats(isRead); }
    void aFileThatIsCutOffIsRefused()
    {
        const std::string_view text = sample().text;
        const std::size_t needed = text.size() - sample().spareBytes;
        for (std::size_t size = 0; size <= needed; ++size) {
            const std::string_view part = text.substr(0, size);
            const Outcome outcome = outcomeOf(part);
            VERIFY_SOUND(outcome, part);
            const std::string found = std::to_string(size) + " bytes: " + outcome.refusal;
            const bool mayBeRead = size + sample().warnedBytes >= needed;
            if (size == needed)
                QVERIFY2(outcome.problems.empty(), found.c_str());
            else
                QVERIFY2(mayBeRead ? !outcome.problems.empty() : !outcome.refusal.empty(),
                    found.c_str());
        }
        for (std::size_t size = needed; size < text.size(); ++size)
            VERIFY_SOUND(outcomeOf(text.substr(0, size)), text);
    }

    void aGarbledByteGivesATableOrAProblem_data() { addFormats(isRead); }
    void aGarbledByteGivesATableOrAProblem()
    {
        std::string text = sample().text;
        for (std::size_t i = 0; i < text.size(); ++i) {
            const char before = text[i];
            for (const char garbled : {'?', '9', '-', ' ', ',', '\n', ']', '\x01', '\xFF'}) {
                if (garbled == before)
                    continue;
                text[i] = garbled;
                const Outcome outcome = outcomeOf(text);
                VERIFY_SOUND(outcome, text);
            }
            text[i] = before;
        }
    }

    void aFileThatIsTooLargeIsRefused_data()
    {
        addFormats([](const FormatSample& sample) {
            return isReadAsText(sample) && sample.format->facts.mostBytes <= 64U << 20U;
        });
    }
    void aFileThatIsTooLargeIsRefused()
    {
        const std::size_t most = sample().format->facts.mostBytes;
        const auto reading = sample().format->read(
            sample().text + std::string(most + 1 - sample().text.size(), '\n'), readOptions());
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QCOMPARE(problemLines(*reading),
            "0:0 TooLarge " + std::to_string(most + 1) + " bytes|at most " + std::to_string(most)
                + " bytes\n");
    }

    void aProblemNamesItsPlace_data() { addRows(&FormatSample::problems); }
    void aProblemNamesItsPlace()
    {
        const FormatSample::Problem& expected = row(&FormatSample::problems);
        TableReadOptions options = readOptions(expected.settings);
        const auto reading = sample().format->read(expected.text, options);
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(expected.line), found.c_str());
        QCOMPARE(reading->diagnostics.front().controllerError, expected.controllerError);
        QVERIFY2(reading->hasErrors(), found.c_str());
        options.maximumDiagnostics = 1;
        const auto shorter = sample().format->read(expected.text, options);
        VERIFY_RESULT(shorter);
        QVERIFY(shorter->tables.empty() && shorter->hasErrors());
        const auto isError = [](const Diagnostic& d) { return d.severity == Severity::Error; };
        QVERIFY(std::ranges::count_if(shorter->diagnostics, isError) <= 1);
    }

    void aWarningLetsTheTablePass_data() { addRows(&FormatSample::warnings); }
    void aWarningLetsTheTablePass()
    {
        const FormatSample::Warning& expected = row(&FormatSample::warnings);
        const auto reading = sample().format->read(expected.text, readOptions(expected.settings));
        VERIFY_RESULT(reading);
        const std::string found = problemLines(*reading);
        QVERIFY2(!reading->tables.empty() && !reading->hasErrors(), found.c_str());
        std::size_t at = 0;
        for (const std::string& line : expected.lines) {
            QVERIFY2(found.substr(at).starts_with("warning " + line), found.c_str());
            at = found.find('\n', at) + 1;
        }
        QVERIFY2(at == found.size(), found.c_str());
    }

    void readingCanBeStopped_data() { addFormats(isReadAsText); }
    void readingCanBeStopped()
    {
        std::stop_source stop;
        stop.request_stop();
        TableReadOptions options = readOptions();
        options.stop = stop.get_token();
        const auto reading = sample().format->read(sample().text, options);
        VERIFY_RESULT(reading);
        QVERIFY(reading->cancelled && reading->tables.empty());
    }

    void aFileIsRecognisedByItsContent_data() { addFormats(isReadAsText); }
    void aFileIsRecognisedByItsContent()
    {
        QVERIFY(!sample().recognised.empty());
        for (const auto& [text, recognition] : sample().recognised)
            QVERIFY2(sample().format->recognise(text) == recognition, text.c_str());
        const std::string_view text = sample().text;
        const Recognition whole = sample().format->recognise(text);
        QCOMPARE(whole == Recognition::No, sample().isOnlyNamed);
        for (std::size_t size = 0; size < text.size(); ++size)
            QVERIFY(sample().format->recognise(text.substr(0, size)) <= whole);
    }

    void noFormatTakesTheFileOfAnotherForItsOwn_data() { addFormats(isReadAsText); }
    void noFormatTakesTheFileOfAnotherForItsOwn()
    {
        const TableFormat& format = *sample().format;
        const std::string name = "x" + std::string(format.facts.extensions.front());
        const FormatGuess guess = guessFormat(sample().text, name);
        QCOMPARE(guess.formats.empty(), sample().isOnlyNamed);
        if (!guess.formats.empty())
            QCOMPARE(guess.formats.front()->facts.name, format.facts.name);
        for (const FormatSample& other : samples())
            if (other.format && other.format != &format && other.format->recognise)
                QVERIFY2(other.format->recognise(sample().text) != Recognition::Certain,
                    nameOf(other).c_str());
        if (format.recognise(sample().text) == Recognition::Certain)
            QVERIFY(guessFormat(sample().text, "table").isCertain);
    }

    void settingsOfTheWrongKindAreRefused_data() { addFormats(isAny); }
    void settingsOfTheWrongKindAreRefused()
    {
        using Kind = FormatSetting::Kind;
        const std::map<Kind, std::vector<std::string>> wrong{{Kind::Text, {""}},
            {Kind::WholeNumber, {"", "1.5", "x", "1,5"}},
            {Kind::Number, {"", "many", "nan", "1,5"}}, {Kind::Choice, {"", "neither"}},
            {Kind::YesNo, {"", "perhaps", "YES"}}};
        for (const bool isWriting : {false, true}) {
            if (isWriting ? !isWritten(sample()) : !isRead(sample()))
                continue;
            refusesSetting(isWriting, "no-such-setting", "1", "no setting no-such-setting");
            for (const FormatSetting& setting : formatSettings(sample().format->facts, isWriting)) {
                const std::string key(setting.key);
                for (const std::string& value : wrong.at(setting.kind))
                    refusesSetting(isWriting, key, value, "the setting " + key + " is");
                if (setting.isNeeded)
                    refusesSetting(isWriting, key, std::nullopt, "needs the setting " + key);
            }
        }
    }

    void aNeededSettingMayHaveOthersInItsPlace_data()
    {
        addFormats([](const FormatSample& sample) {
            return std::ranges::any_of(sample.format->facts.settings,
                [](const FormatSetting& setting) { return !setting.unless.empty(); });
        });
    }
    void aNeededSettingMayHaveOthersInItsPlace()
    {
        const FormatFacts& facts = sample().format->facts;
        for (const FormatSetting& setting : facts.settings) {
            const std::string words(setting.unless);
            std::vector<Token> keys;
            splitTokens({words, 0, 0}, ", ", keys);
            if (keys.empty())
                continue;
            QVERIFY(setting.isNeeded);
            FormatSettings others;
            for (const Token& key : keys)
                others[std::string(key.text)] = "1000";
            VERIFY_RESULT(SettingValues::of(facts, others, setting.forWriting));
            others.erase(std::string(keys.back().text));
            VERIFY_ERROR(
                SettingValues::of(facts, others, setting.forWriting), ErrorCode::InvalidArgument);
        }
    }

    void settingsThatCannotBeAreRefused_data() { addRows(&FormatSample::refusedSettings); }
    void settingsThatCannotBeAreRefused()
    {
        const FormatSample::Problem& expected = row(&FormatSample::refusedSettings);
        const auto reading = sample().format->read(expected.text, readOptions(expected.settings));
        VERIFY_ERROR(reading, ErrorCode::InvalidArgument);
        QVERIFY2(
            mentions(sentence(reading.error()), expected.line), sentence(reading.error()).c_str());
    }

    void whatIsWrittenIsReadBackTheSame_data() { addRows(&FormatSample::written); }
    void whatIsWrittenIsReadBackTheSame()
    {
        const FormatSample::Written& expected = row(&FormatSample::written);
        const TableFormat& format = *sample().format;
        VERIFY_RESULT(checkHolds(format.facts, expected.tables));
        const auto written = format.write(expected.tables, writeOptions(expected.writing));
        VERIFY_RESULT(written);
        QVERIFY2(
            expected.bytes.empty() || written->bytes == expected.bytes, written->bytes.c_str());
        for (const std::string& part : expected.parts)
            QVERIFY2(mentions(written->bytes, part), written->bytes.c_str());
        for (const std::string& part : expected.remarks)
            QVERIFY2(mentions(test::joined(written->remarks), part),
                test::joined(written->remarks).c_str());
        const auto& tables = expected.becomes.empty() ? expected.tables : expected.becomes;
        QCOMPARE(written->held.size(), tables.size());
        bool isRounded = false;
        for (std::size_t i = 0; i < tables.size(); ++i) {
            const NeutralTable& held = written->held[i];
            const std::string why = test::difference(
                held, tables[i], expected.allowance, expected.allowanceOfPositions);
            QVERIFY2(why.empty(), why.c_str());
            if (format.facts.holdsNotes)
                QCOMPARE(held.notes, tables[i].notes);
            if (!tables[i].name.empty())
                QCOMPARE(held.name, tables[i].name);
            isRounded = isRounded || !test::difference(written->held[i], tables[i]).empty();
        }
        QVERIFY(isRounded || expected.allowance < 1e-9);
        if (!format.read)
            return;
        QVERIFY(!format.recognise
            || (format.recognise(written->bytes) == Recognition::No) == sample().isOnlyNamed);
        const auto again = format.read(written->bytes, readOptions(expected.reading));
        VERIFY_RESULT(again);
        // Several tables of one axis are understood as such, which is a warning.
        for (const Diagnostic& problem : again->diagnostics)
            QVERIFY2(problem.code == DiagnosticCode::UnitNotGiven
                    || (problem.code == DiagnosticCode::Assumption && tables.size() > 1),
                message(problem).c_str());
        QCOMPARE(withTargetsOf(again->tables, written->held), written->held);
    }

    void numbersDoNotDependOnTheLocale_data() { addFormats(isAny); }
    void numbersDoNotDependOnTheLocale()
    {
        const auto texts = [] {
            std::string text;
            for (const FormatSample::Written& row : sample().written) {
                const auto written = sample().format->write(row.tables, writeOptions(row.writing));
                text += written ? written->bytes : test::describe(written.error());
            }
            return text;
        };
        const auto tables = [] {
            return isRead(sample()) ? outcomeOf(sample().text).tables : std::vector<NeutralTable>();
        };
        const std::string plainTexts = texts();
        const std::vector<NeutralTable> plainTables = tables();
        const GermanLocale german;
        QCOMPARE(texts(), plainTexts);
        QCOMPARE(tables(), plainTables);
    }

    void twoMegabytesAreReadWhole_data()
    {
        addFormats([](const FormatSample& sample) {
            const FormatFacts& facts = sample.format->facts;
            return isRead(sample) && isWritten(sample) && facts.mostBytes > 3'000'000
                && (facts.mostPoints == 0 || facts.mostPoints > 1'000'000);
        });
    }
    void twoMegabytesAreReadWhole()
    {
        const TableFormat& format = *sample().format;
        NeutralTable table = heldTable();
        const std::size_t axis = table.axes.size() - 1;
        const auto small = format.write(std::array{grown(table, axis, 200)}, writeOptions());
        VERIFY_RESULT(small);
        const std::size_t knots = 200 * (3'000'000 / small->bytes.size() + 1);
        const auto written = format.write(std::array{grown(table, axis, knots)}, writeOptions());
        VERIFY_RESULT(written);
        QVERIFY(written->bytes.size() > 2'000'000);
        const auto again = format.read(written->bytes, readOptions());
        VERIFY_RESULT(again);
        QVERIFY2(again->tables.size() == 1, problemLines(*again).c_str());
        QVERIFY(withTargetsOf(again->tables, written->held) == written->held);
        QVERIFY(again->tables.front().axes[axis].knots.size() >= knots);
    }

    void theFirstAboveALimitIsRefused_data() { addFormats(isWritten); }
    void theFirstAboveALimitIsRefused()
    {
        const FormatFacts& facts = sample().format->facts;
        const NeutralTable& held = heldTable();
        NeutralTable deep = held;
        while (deep.axes.size() <= static_cast<std::size_t>(facts.mostDimensions))
            deep.axes.push_back(test::evenAxis("9", "mm", 0, 1, 2));
        refuses(deep, "possible are");
        if (facts.fewestDimensions > 1)
            refuses(test::changed(held, [](NeutralTable& t) { t.axes.resize(1); }), "possible are");
        if (facts.mostPoints > 0 && facts.mostDimensions == 1) {
            const auto full = grown(held, 0, facts.mostPoints);
            VERIFY_RESULT(checkHolds(facts, std::array{full}));
            refuses(grown(held, 0, facts.mostPoints + 1), std::to_string(facts.mostPoints));
        }
        if (facts.mostColumns > 0) {
            NeutralTable wide = held;
            while (wide.columns.size() <= facts.mostColumns)
                wide.columns.push_back(held.columns.front());
            refuses(wide, std::to_string(facts.mostColumns));
        }
        if (facts.mostTables > 0)
            refuses(std::vector(facts.mostTables + 1, held), "of one file");
        NeutralTable uneven = held;
        uneven.axes.back().knots.back() += 0.25;
        if (facts.knots != KnotRule::Any)
            refuses(uneven, "not evenly spaced");
        else
            VERIFY_RESULT(checkHolds(facts, std::array{uneven}));
        if (facts.knots == KnotRule::SquareCells)
            refuses(test::changed(held,
                        [](NeutralTable& t) {
                            for (double& knot : t.axes.back().knots)
                                knot *= 2;
                        }),
                "one distance for all");
        if (!facts.holdsWrap)
            refuses(test::changed(held, [](NeutralTable& t) { t.axes[0].wrap = 1e6; }), "modulo");
        if (facts.holdsDirections)
            return;
        NeutralTable directed = held;
        directed.columns = {held.columns.front(), held.columns.front()};
        directed.columns[0].direction = Direction::Positive;
        directed.columns[1].direction = Direction::Negative;
        refuses(directed, "both directions of motion");
    }

    void aSettingGivesDifferentAxesNoCommonName_data()
    {
        addFormats([](const FormatSample& sample) {
            return isWritten(sample) && sample.format->facts.mostTables != 1;
        });
    }
    void aSettingGivesDifferentAxesNoCommonName()
    {
        const FormatFacts& facts = sample().format->facts;
        const NeutralTable& first = heldTable();
        for (const FormatSetting& setting : formatSettings(facts, true)) {
            const bool namesAnAxis = setting.key.find("axis") != std::string_view::npos;
            QVERIFY2(setting.namedAxis.has_value() == namesAnAxis, setting.key.data());
            if (!setting.namedAxis)
                continue;
            const std::size_t number = setting.namedAxis->number;
            if (setting.namedAxis->isTarget && number >= first.columns.size())
                continue;
            NeutralTable other = first;
            if (setting.namedAxis->isTarget)
                other.columns[number].target = otherAxis;
            else
                other.axes[number].name = "9";
            const FormatSettings given{{std::string(setting.key), "1"}};
            VERIFY_RESULT(checkNamedAxes(facts, std::array{first, first}, given));
            VERIFY_RESULT(checkNamedAxes(facts, std::array{first, other}, {}));
            const auto refused = checkNamedAxes(facts, std::array{first, other}, given);
            VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
            QVERIFY2(mentions(sentence(refused.error()), "the setting " + std::string(setting.key)),
                sentence(refused.error()).c_str());
        }
    }

    void numbersThatAreNoneAreRefused_data() { addFormats(isWritten); }
    void numbersThatAreNoneAreRefused()
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (const double none : {std::nan(""), infinity, -infinity}) {
            for (const bool isValue : {true, false}) {
                NeutralTable table = heldTable();
                (isValue ? table.columns[0].values : table.axes[0].knots).back() = none;
                const auto result = checkHolds(sample().format->facts, std::array{table});
                QVERIFY2(!result, isValue ? "a value" : "a position");
                QVERIFY(isValue ? result.error().code == ErrorCode::InvalidArgument : true);
            }
        }
    }

    void whatTheFormatCannotHoldIsRefused_data() { addRows(&FormatSample::refused); }
    void whatTheFormatCannotHoldIsRefused()
    {
        const FormatSample::Refused& expected = row(&FormatSample::refused);
        const auto written =
            sample().format->write(expected.tables, writeOptions(expected.settings));
        VERIFY_ERROR(written, expected.code);
        const std::string text = test::describe(written.error());
        QVERIFY2(mentions(text, expected.reason), text.c_str());
    }

private:
    void refuses(const std::vector<NeutralTable>& tables, const std::string& reason)
    {
        const auto result = checkHolds(sample().format->facts, tables);
        VERIFY_ERROR(result, ErrorCode::FormatCannotHold);
        QVERIFY2(mentions(sentence(result.error()), reason)
                && mentions(sentence(result.error()), nameOf(sample())),
            sentence(result.error()).c_str());
    }
    void refuses(const NeutralTable& table, const std::string& reason)
    {
        refuses(std::vector{table}, reason);
    }

    /// Nothing is read or written with this value of a setting; no value: without the setting.
    void refusesSetting(bool isWriting, const std::string& key,
        const std::optional<std::string>& value, const std::string& reason)
    {
        TableReadOptions reading = readOptions();
        TableWriteOptions writing = writeOptions();
        FormatSettings& settings = isWriting ? writing.settings : reading.settings;
        settings.erase(key);
        if (value)
            settings[key] = *value;
        const TableFormat& format = *sample().format;
        const auto error = isWriting ? errorOf(format.write(std::array{heldTable()}, writing))
                                     : errorOf(format.read(sample().text, reading));
        QVERIFY2(error && error->code == ErrorCode::InvalidArgument, key.c_str());
        QVERIFY2(mentions(sentence(*error), reason), sentence(*error).c_str());
    }
    template <class Value> static std::optional<Error> errorOf(const Result<Value>& result)
    {
        return result ? std::nullopt : std::optional(result.error());
    }
};

AXISCOMP_TEST(TestFormatContract)

} // namespace tst_formatcontract

#include "tst_formatcontract.moc"
