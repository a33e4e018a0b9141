// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_text {

using namespace axiscomp;

class TestText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void placeholdersAreFilled_data()
    {
        QTest::addColumn<QByteArray>("words");
        QTest::addColumn<QByteArray>("expected");
        const auto row = [](const char* words, const char* expected) {
            QTest::newRow(words) << QByteArray(words) << QByteArray(expected);
        };
        row("{a}", "1");
        row("x {a} y {b} z", "x 1 y {a} z"); // a value like a placeholder is not filled again
        row("{a}{a}", "11");
        row("{missing}", "?");
        row("no placeholder", "no placeholder");
        row("open {a", "open {a");
        row("a} {b", "a} {b");
    }
    void placeholdersAreFilled()
    {
        QFETCH(const QByteArray, words);
        QFETCH(const QByteArray, expected);
        const Text text = TextPattern{"Error", words.constData(), nullptr}.with("a", 1).with(
            "b", Verbatim{"{a}"});
        QCOMPARE(text.english(), expected.toStdString());
    }

    void everyKindOfArgumentHasItsEnglish()
    {
        const TextPattern inner{"Error", "at {x}", nullptr};
        QCOMPARE(Argument(Quantity{"0.5", "mm"}).english(), "0.5 mm");
        QCOMPARE(Argument(Quantity{"-1e-05"}).english(), "-1e-05");
        QCOMPARE(Argument(std::uint32_t{4'000'000'000U}).english(), "4000000000");
        QCOMPARE(Argument(inner.with("x", Verbatim{"home"})).english(), "at home");
        QCOMPARE(Argument(std::vector<std::string>{"X", "Y", "Z"}).english(), "X, Y, Z");
        QCOMPARE(Argument(std::vector<Text>{}).english(), "");
    }

    void aQuestionWithinASentenceHasNoFullStopBehindIt()
    {
        const TextPattern sentence{"Error", "{a}. Look {a}; {a}", nullptr};
        const TextPattern question{"Error", "is it on?", nullptr};
        QCOMPARE(sentence.with("a", question).english(),
            std::string("is it on? Look is it on?; is it on?"));
        QCOMPARE(sentence.with("a", TextPattern{"Error", "off", nullptr}).english(),
            std::string("off. Look off; off"));
        // What is called so is no question.
        QCOMPARE(sentence.with("a", Verbatim{"a?"}).english(), std::string("a?. Look a?; a?"));
        QCOMPARE(Text(sentence).english(), std::string("?. Look ?; ?"));
        Wording japanese;
        japanese.words = [](const TextPattern& pattern, std::optional<std::int64_t>) {
            const bool isInner = std::string_view(pattern.words).ends_with('?');
            return std::string(isInner ? "\u304b\uff1f" : "{a}\u3002");
        };
        QCOMPARE(sentence.with("a", question).in(japanese), std::string("\u304b\uff1f"));
    }

    void aCountOfOneHasWordsOfItsOwn()
    {
        const TextPattern pattern{"Error", "{count} lines", "one line"};
        QCOMPARE(pattern.with("count", 0).english(), "0 lines");
        QCOMPARE(pattern.with("count", 1).english(), "one line");
        QCOMPARE(pattern.with("count", 2).english(), "2 lines");
        // A number that is no count has the words for several.
        QCOMPARE(pattern.with("count", Quantity{"1"}).english(), "1 lines");
    }

    void anEmptyTextSaysNothing()
    {
        QVERIFY(Text().isEmpty());
        QVERIFY(Text(Verbatim{""}).isEmpty());
        QVERIFY(!Text(Verbatim{"x"}).isEmpty());
        QCOMPARE(Text().english(), "");
    }

    void textsAreComparedByWhatTheySay()
    {
        const TextPattern pattern{"Error", "{a} and {b}", nullptr};
        const Text one = pattern.with("a", 1).with("b", 2);
        QVERIFY(one == pattern.with("b", 2).with("a", 1));
        QVERIFY(!(one == pattern.with("a", 1).with("b", 3)));
        QVERIFY(one == Text::withWords("Error", "{a} and {b}", {}, {{"a", 1}, {"b", 2}}));
        QVERIFY(!(one == Text::withWords("Problem", "{a} and {b}", {}, {{"a", 1}, {"b", 2}})));
    }

    void aTextThatOwnsItsWordsCanBeCopied()
    {
        Text copy;
        {
            const Text text = Text::withWords("Error", std::string(100, 'x'), {}, {});
            copy = text;
        }
        QCOMPARE(copy.english(), std::string(100, 'x'));
    }

    void argumentsAreFoundByTheirNames()
    {
        Arguments arguments{{"axis", 3}, {"path", Verbatim{"Axes[0]"}}};
        QCOMPARE(arguments.integer("axis").value(), 3);
        QVERIFY(!arguments.integer("path"));
        QVERIFY(!arguments.integer("none"));
        QCOMPARE(arguments.english("path"), "Axes[0]");
        QCOMPARE(arguments.english("none"), "");
        arguments.setIfMissing("axis", 4);
        arguments.setIfMissing("slot", Verbatim{"Small1"});
        arguments.set("path", Verbatim{"Axes[1]"});
        QVERIFY(arguments
            == (Arguments{
                {"slot", Verbatim{"Small1"}}, {"axis", 3}, {"path", Verbatim{"Axes[1]"}}}));
        arguments.remove("axis");
        QVERIFY(!arguments.contains("axis"));
    }
};

AXISCOMP_TEST(TestText)

} // namespace tst_text

#include "tst_text.moc"
