// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/text_json.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <limits>

namespace tst_textjson {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

class TextJsonTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void writesWhatTheProtocolSays();
    void keepsEveryKindOfArgument();
    void keepsWhatIsCounted();
    void keepsBytesThatAreNoText();
    void readsTextsInEachOtherUpToALimit();
    void readsArgumentsUpToALimit();
    void refusesTextsThatGrowWhenTheyAreFilled();
    void cutsLongStringsAtACharacter();
    void refusesAnythingElse_data();
    void refusesAnythingElse();
};

namespace {

/// depth texts in each other, each in a list of the one before.
Text nested(int depth)
{
    Text text = AXISCOMP_TEXT("Error", "the innermost");
    for (int n = 1; n < depth; ++n)
        text = AXISCOMP_TEXT("Error", "in {list}").with("list", std::vector<Text>{text});
    return text;
}

} // namespace

void TextJsonTest::writesWhatTheProtocolSays()
{
    const Text text = AXISCOMP_TEXT("Error", "{path} is read-only").with("path", Verbatim{"A/B"});
    QCOMPARE(textJson(text),
        std::string(R"({"context":"Error","words":"{path} is read-only",)"
                    R"("arguments":{"path":{"name":"A/B"}}})"));
}

void TextJsonTest::keepsEveryKindOfArgument()
{
    const Text text =
        AXISCOMP_TEXT("Error", "{name} {number} {plain} {count} {text} {list} {none}")
            .with("name", Verbatim{"\"µ\"\\\n"})
            .with("number", Quantity{"-0.5", "mm"})
            .with("plain", Quantity{"1e-05"})
            .with("count", std::numeric_limits<std::int64_t>::min())
            .with("text", AXISCOMP_TEXT("Error", "a {part}").with("part", Verbatim{"x"}))
            .with("list", std::vector<Text>{AXISCOMP_TEXT("Problem", "one"), Verbatim{"two"}})
            .with("none", std::vector<Text>{});
    const auto read = parseTextJson(textJson(text));
    QVERIFY(read);
    QVERIFY(*read == text);
    QCOMPARE(read->english(), text.english());
    QCOMPARE(read->pattern().context, "Error");
    for (const Text& plain : {Text(Verbatim{"words of a drive"}), Text()}) {
        const auto same = parseTextJson(textJson(plain));
        QVERIFY(same);
        QVERIFY(*same == plain);
        QCOMPARE(same->isEmpty(), plain.isEmpty());
    }
}

void TextJsonTest::keepsWhatIsCounted()
{
    const TextPattern pattern = AXISCOMP_COUNTED("Error", "{count} registers", "one register");
    for (const int count : {0, 1, 2}) {
        const Text text = pattern.with("count", count);
        const auto read = parseTextJson(textJson(text));
        QVERIFY(read);
        QVERIFY(read->pattern().one != nullptr);
        QCOMPARE(read->english(), text.english());
    }
    QVERIFY(parseTextJson(textJson(nested(1)))->pattern().one == nullptr);
}

void TextJsonTest::keepsBytesThatAreNoText()
{
    const auto read = parseTextJson(textJson(Verbatim{"a\xff"
                                                      "b"}));
    QVERIFY(read);
    QCOMPARE(read->english(),
        std::string("a\xEF\xBF\xBD"
                    "b"));
}

void TextJsonTest::readsTextsInEachOtherUpToALimit()
{
    const auto read = parseTextJson(textJson(nested(deepestTextJson)));
    QVERIFY(read);
    QCOMPARE(read->english(), nested(deepestTextJson).english());
    QVERIFY(!parseTextJson(textJson(nested(deepestTextJson + 1))));
    QVERIFY(!parseTextJson(textJson(nested(1000))));
}

void TextJsonTest::readsArgumentsUpToALimit()
{
    const auto listed = [](std::size_t items) {
        return AXISCOMP_TEXT("Error", "{list}").with("list", std::vector<std::string>(items, "x"));
    };
    // The list, and each item with the argument of its own.
    constexpr std::size_t most = (mostTextJsonArguments - 1) / 2;
    const auto read = parseTextJson(textJson(listed(most)));
    QVERIFY(read);
    QVERIFY(*read == listed(most));
    QVERIFY(!parseTextJson(textJson(listed(most + 1))));
    Text many = AXISCOMP_TEXT("Error", "many");
    for (std::size_t n = 0; n < mostTextJsonArguments; ++n)
        many = std::move(many).with("a" + std::to_string(n), n);
    QVERIFY(parseTextJson(textJson(many)));
    QVERIFY(!parseTextJson(textJson(std::move(many).with("more", 1))));
}

void TextJsonTest::refusesTextsThatGrowWhenTheyAreFilled()
{
    const auto doubled = [](int times) {
        Text text = Verbatim{std::string(100, 'x')};
        for (int n = 0; n < times; ++n)
            text = AXISCOMP_TEXT("Error", "{part}{part}").with("part", std::move(text));
        return text;
    };
    const auto read = parseTextJson(textJson(doubled(3)));
    QVERIFY(read);
    QCOMPARE(read->english(), std::string(800, 'x'));
    QVERIFY2(!parseTextJson(textJson(doubled(4))), "1600 bytes");
}

void TextJsonTest::cutsLongStringsAtACharacter()
{
    std::string characters = "x";
    while (characters.size() < 3 * longestTextJsonString)
        characters += "µ";
    const auto read = parseTextJson(
        textJson(AXISCOMP_TEXT("Error", "{name}").with("name", Verbatim{characters})));
    QVERIFY(read);
    QCOMPARE(read->english(), characters.substr(0, longestTextJsonString - 1));
    const auto words =
        parseTextJson(textJson(Text::withWords(characters, characters, characters, {})));
    QVERIFY(words);
    const std::size_t kept = longestTextJsonString - 1;
    QCOMPARE(std::string(words->pattern().context), characters.substr(0, kept));
    QCOMPARE(std::string(words->pattern().words), characters.substr(0, kept));
    QCOMPARE(std::string(words->pattern().one), characters.substr(0, kept));
}

void TextJsonTest::refusesAnythingElse_data()
{
    QTest::addColumn<QByteArray>("json");
    const auto argument = [](const char* name, const char* value) {
        QTest::newRow(name) << QByteArray(R"({"context":"","words":"w","arguments":{"a":)") + value
                + "}}";
    };
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("no JSON") << QByteArray("{");
    QTest::newRow("a string") << QByteArray("\"w\"");
    QTest::newRow("a list") << QByteArray("[]");
    QTest::newRow("no words") << QByteArray(R"({"context":"","arguments":{}})");
    QTest::newRow("no context") << QByteArray(R"({"words":"w","arguments":{}})");
    QTest::newRow("no arguments") << QByteArray(R"({"context":"","words":"w"})");
    QTest::newRow("words that are a number")
        << QByteArray(R"({"context":"","words":1,"arguments":{}})");
    QTest::newRow("a list of arguments")
        << QByteArray(R"({"context":"","words":"w","arguments":[]})");
    QTest::newRow("a counted one that is none")
        << QByteArray(R"({"context":"","words":"w","one":1,"arguments":{}})");
    argument("an argument that is a string", "\"x\"");
    argument("an argument that is a list", "[]");
    argument("an argument of an unknown kind", "{\"colour\":\"red\"}");
    argument("a name that is a number", "{\"name\":1}");
    argument("a count with decimals", "{\"count\":1.5}");
    argument("a count that is too large", "{\"count\":9223372036854775808}");
    argument("a count that is a string", "{\"count\":\"5\"}");
    argument("a text that is a string", "{\"text\":\"x\"}");
    argument("a text without words", "{\"text\":{}}");
    argument("a list that is none", "{\"list\":{}}");
    argument("a list of strings", "{\"list\":[\"x\"]}");
}

void TextJsonTest::refusesAnythingElse()
{
    QFETCH(QByteArray, json);
    QVERIFY(!parseTextJson(json.toStdString()));
}

AXISCOMP_TEST(TextJsonTest)

} // namespace tst_textjson

#include "tst_textjson.moc"
