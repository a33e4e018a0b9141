// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/serial_codec.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <limits>
#include <random>

namespace tst_serialcodec {

using namespace axiscomp;
using namespace axiscomp::test;
using namespace axiscomp::drivecomm;

namespace {

using State = SerialLine::State;

std::vector<std::string> wordsOf(const std::string& text)
{
    return parseSerialLine(text).words;
}

} // namespace

class SerialCodecTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void readsLinesOfPeople_data();
    void readsLinesOfPeople();
    void knowsTheChecksumOfTheSpecification();
    void bindsTheLinesOfAReplyTogether();
    void refusesALine_data();
    void refusesALine();
    void seesEveryFlippedBit();
    void seesFlippedBytes();
    void keepsEveryWord();
    void makesLinesOfBytes_data();
    void makesLinesOfBytes();
    void doesNotGrowWithoutEnd();
    void takesNoLineThatWasCutOffForAWhole();
    void keepsErrors();
    void keepsTheReasonAsAValue();
    void leavesTheValueOutOfALineThatIsTooLong();
    void readsErrorsAsTheSpecificationWritesThem();
    void keepsIdentityFileAndReadings();
    void refusesWhatIsNoReply();
};

void SerialCodecTest::readsLinesOfPeople_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<int>("number"); // 0: none
    QTest::addColumn<QByteArrayList>("words");
    QTest::newRow("bare") << "identify" << 0 << QByteArrayList{"identify"};
    QTest::newRow("numbered") << "#1 identify" << 1 << QByteArrayList{"identify"};
    QTest::newRow("largest number") << "#65535 list" << 65535 << QByteArrayList{"list"};
    QTest::newRow("many blanks") << "  #7   get  a   b  " << 7 << QByteArrayList{"get", "a", "b"};
    QTest::newRow("quoted") << R"(set a "two words" b "")" << 0
                            << QByteArrayList{"set", "a", "two words", "b", ""};
    QTest::newRow("escapes") << R"(x "a\"b\\c\x20d")" << 0 << QByteArrayList{"x", R"(a"b\c d)"};
    QTest::newRow("a star inside") << "get a*b" << 0 << QByteArrayList{"get", "a*b"};
    QTest::newRow("checked") << "#1 identify *cce1" << 1 << QByteArrayList{"identify"};
    QTest::newRow("checked, capitals") << "#1 identify *CCE1 " << 1 << QByteArrayList{"identify"};
}

void SerialCodecTest::readsLinesOfPeople()
{
    QFETCH(QString, line);
    QFETCH(int, number);
    QFETCH(QByteArrayList, words);
    const SerialLine parsed = parseSerialLine(line.toStdString());
    QCOMPARE(parsed.state, State::Good);
    QCOMPARE(parsed.number.value_or(0), number);
    QByteArrayList found;
    for (const std::string& word : parsed.words)
        found += QByteArray::fromStdString(word);
    QCOMPARE(found, words);
    QCOMPARE(parsed.hasCrc, line.contains(QStringLiteral(" *")));
}

void SerialCodecTest::knowsTheChecksumOfTheSpecification()
{
    // CRC-16/CCITT-FALSE of "123456789" is 29b1
    QCOMPARE(serialLine(std::nullopt, "123456789", true), std::string("123456789 *29b1"));
    QCOMPARE(serialLine(7, "list", false), std::string("#7 list"));
}

void SerialCodecTest::bindsTheLinesOfAReplyTogether()
{
    const std::vector<std::string> words{"ok 3", "Single 0", "Single 0", "Single 1"};
    const QByteArray reply = QByteArray::fromStdString(serialReply(7, words, true));
    QVERIFY(reply.endsWith("\r\n"));
    const QByteArrayList lines = reply.trimmed().split('\n');
    QCOMPARE(lines.size(), qsizetype{4});
    std::vector<std::uint16_t> crcs{crcCcittFalse};
    for (qsizetype n = 0; n < lines.size(); ++n) {
        const std::string line = lines[n].trimmed().toStdString();
        const SerialLine parsed = parseSerialLine(line, crcs.back());
        QVERIFY(parsed.state == State::Good && parsed.hasCrc && parsed.number == 7);
        QCOMPARE(parsed.text, words[static_cast<std::size_t>(n)]);
        crcs.push_back(parsed.crc);
        for (std::size_t place = 0; place < crcs.size(); ++place)
            if (place != static_cast<std::size_t>(n))
                QCOMPARE(parseSerialLine(line, crcs[place]).state, State::BadCrc);
    }
    QCOMPARE(serialReply(7, {words.data(), 1}, false), std::string("#7 ok 3\r\n"));
}

void SerialCodecTest::refusesALine_data()
{
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("state");
    const int malformed = static_cast<int>(State::Malformed);
    const int garbled = static_cast<int>(State::BadCrc);
    QTest::newRow("empty") << QByteArray() << malformed;
    QTest::newRow("blanks") << QByteArray("   ") << malformed;
    QTest::newRow("number only") << QByteArray("#5") << malformed;
    QTest::newRow("number 0") << QByteArray("#0 list") << malformed;
    QTest::newRow("number too large") << QByteArray("#65536 list") << malformed;
    QTest::newRow("no number") << QByteArray("#x list") << malformed;
    QTest::newRow("open quotation") << QByteArray("get \"a") << malformed;
    QTest::newRow("quotation inside") << QByteArray("get a\"b\"") << malformed;
    QTest::newRow("stuck to a quotation") << QByteArray("get \"a\"b") << malformed;
    QTest::newRow("unknown escape") << QByteArray("get \"\\n\"") << malformed;
    QTest::newRow("half an escape") << QByteArray("get \"\\x4\"") << malformed;
    QTest::newRow("not ASCII") << QByteArray("get \xC3\xA4") << malformed;
    QTest::newRow("a control character") << QByteArray("get a\x01") << malformed;
    QTest::newRow("too long") << QByteArray(4097, 'a') << malformed;
    QTest::newRow("wrong CRC") << QByteArray("#1 identify *cce0") << garbled;
    QTest::newRow("short CRC") << QByteArray("#1 identify *ce1") << garbled;
    QTest::newRow("CRC is no number") << QByteArray("#1 identify *ccg1") << garbled;
    QTest::newRow("a star alone") << QByteArray("#1 identify *") << garbled;
}

void SerialCodecTest::refusesALine()
{
    QFETCH(QByteArray, line);
    QFETCH(int, state);
    QCOMPARE(static_cast<int>(parseSerialLine(line.toStdString()).state), state);
}

void SerialCodecTest::seesEveryFlippedBit()
{
    const std::string line = serialLine(4711, "set Axes[0]/Table Small1", true);
    QCOMPARE(parseSerialLine(line).state, State::Good);
    for (std::size_t i = 0; i < line.size(); ++i) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            std::string flipped = line;
            flipped[i] = static_cast<char>(static_cast<unsigned>(flipped[i]) ^ (1U << bit));
            const SerialLine parsed = parseSerialLine(flipped);
            // Hexadecimal digits may change from small to large, and nothing else may.
            const bool isSame = parsed.text == "set Axes[0]/Table Small1" && parsed.number == 4711;
            QVERIFY2(parsed.state != State::Good || !parsed.hasCrc || isSame, flipped.c_str());
        }
    }
}

void SerialCodecTest::seesFlippedBytes()
{
    std::mt19937 random(3);
    const std::string line = serialLine(12, "ok 2", true);
    for (int run = 0; run < 20'000; ++run) {
        std::string flipped = line;
        flipped[random() % flipped.size()] = static_cast<char>(random() & 0xFFU);
        const SerialLine parsed = parseSerialLine(flipped);
        const bool isSame = parsed.text == "ok 2" && parsed.number == 12;
        QVERIFY2(parsed.state != State::Good || !parsed.hasCrc || isSame, flipped.c_str());
    }
}

void SerialCodecTest::keepsEveryWord()
{
    std::mt19937 random(5);
    for (int run = 0; run < 3000; ++run) {
        std::vector<std::string> words;
        std::string text;
        for (unsigned n = 0; n <= random() % 4; ++n) {
            std::string word;
            for (auto size = random() % 12; size > 0; --size)
                word +=
                    static_cast<char>(random() % 3 == 0 ? random() & 0xFFU : 32 + random() % 95);
            text += (text.empty() ? "" : " ") + serialWord(word);
            words.push_back(std::move(word));
        }
        const SerialLine parsed = parseSerialLine(serialLine(9, text, true));
        QCOMPARE(parsed.state, State::Good);
        QVERIFY2(parsed.words == words, text.c_str());
    }
}

void SerialCodecTest::makesLinesOfBytes_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QByteArrayList>("lines");
    QTest::newRow("CR LF") << QByteArray("a\r\nb\r\n") << QByteArrayList{"a", "b"};
    QTest::newRow("CR") << QByteArray("a\rb\r") << QByteArrayList{"a", "b"};
    QTest::newRow("LF") << QByteArray("a\n\n\nb\n") << QByteArrayList{"a", "b"};
    QTest::newRow("unfinished") << QByteArray("a\nb") << QByteArrayList{"a"};
    QTest::newRow("backspace") << QByteArray("\x08sex\x08t\x7ft\r") << QByteArrayList{"set"};
    QTest::newRow("Ctrl-X") << QByteArray("rubbish\x18list\r") << QByteArrayList{"list"};
    QTest::newRow("tab") << QByteArray("get\ta\r") << QByteArrayList{"get a"};
}

void SerialCodecTest::makesLinesOfBytes()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QByteArrayList, lines);
    SerialLineAssembler assembler;
    QByteArrayList found;
    for (const char byte : bytes)
        if (const auto line = assembler.feed(byte))
            found += QByteArray::fromStdString(*line);
    QCOMPARE(found, lines);
}

void SerialCodecTest::doesNotGrowWithoutEnd()
{
    SerialLineAssembler assembler;
    for (int n = 0; n < 1'000'000; ++n)
        QVERIFY(!assembler.feed('x'));
    const auto line = assembler.feed('\n');
    QVERIFY(line.has_value());
    QCOMPARE(line->size(), longestSerialLine + 1);
    QCOMPARE(parseSerialLine(*line).state, State::Malformed);
    QVERIFY(assembler.feed('x') == std::nullopt);
    QCOMPARE(assembler.feed('\n').value(), std::string("x"));
}

void SerialCodecTest::takesNoLineThatWasCutOffForAWhole()
{
    // The last character that is kept is a blank: without it the line would have the right length.
    SerialLineAssembler assembler;
    for (std::size_t n = 0; n < longestSerialLine; ++n)
        QVERIFY(!assembler.feed('x'));
    for (const char byte : std::string(" and more"))
        QVERIFY(!assembler.feed(byte));
    const auto line = assembler.feed('\n');
    QVERIFY(line.has_value());
    QCOMPARE(parseSerialLine(*line).state, State::Malformed);
}

void SerialCodecTest::keepsErrors()
{
    const Error unknown{ErrorCode::UnknownRegister,
        {{"path", Verbatim{"Axes[0]/Nix"}}, {"nearest", Verbatim{"Axes[0]/A, Axes[0]/B"}}}, {}};
    const auto first = parseSerialError(wordsOf(serialError(unknown)));
    QVERIFY(first.has_value());
    QCOMPARE(first->code, ErrorCode::UnknownRegister);
    QCOMPARE(first->context.english("path"), std::string("Axes[0]/Nix"));
    QCOMPARE(first->context.english("nearest"), std::string("Axes[0]/A, Axes[0]/B"));
    const Error wear{ErrorCode::FlashWear, {{"seconds", 583}}, {}};
    const auto second = parseSerialError(wordsOf(serialError(wear)));
    QVERIFY(second.has_value());
    QCOMPARE(second->code, ErrorCode::FlashWear);
    QCOMPARE(second->context.english("seconds"), std::string("583"));
    const Error refused{ErrorCode::TableRefused, {{"reason", Verbatim{"say \"no\"\nµ"}}}, {}};
    const auto third = parseSerialError(wordsOf(serialError(refused)));
    QVERIFY(third.has_value());
    QCOMPARE(third->context.english("reason"), std::string("say \"no\"\nµ"));
}

void SerialCodecTest::keepsTheReasonAsAValue()
{
    const Text reason =
        AXISCOMP_TEXT("Error", "{path} is \"read-only\"").with("path", Verbatim{"µ\n"});
    const Error error{ErrorCode::DriveRejected, {{"reason", reason}}, {}};
    const std::string line = serialError(error);
    QVERIFY(line.find(" \"text={") != std::string::npos);
    const auto parsed = parseSerialError(wordsOf(line));
    QVERIFY(parsed.has_value());
    QVERIFY(*parsed->context.find("reason") == Argument(reason));
    const auto odd = parseSerialError(wordsOf(R"(error DriveRejected "no" "text={\"words\":1}")"));
    QVERIFY(odd.has_value());
    QCOMPARE(odd->context.english("reason"), std::string("no"));
}

void SerialCodecTest::leavesTheValueOutOfALineThatIsTooLong()
{
    constexpr std::size_t longest = 1'981; // with which the line has 4096 characters
    for (const std::size_t size : {std::size_t{100}, longest, longest + 1, std::size_t{3'000}}) {
        const Text reason =
            AXISCOMP_TEXT("Error", "no {path}").with("path", std::string(size, 'x'));
        const std::string words = serialError({ErrorCode::DriveRejected, {{"reason", reason}}, {}});
        QVERIFY(serialLine(65535, words, true).size() <= longestSerialLine);
        QCOMPARE(words.find("text=") != std::string::npos, size <= longest);
        const auto parsed = parseSerialError(wordsOf(words));
        QVERIFY(parsed.has_value());
        QVERIFY(parsed->context.english("reason").starts_with("no xxx"));
    }
}

void SerialCodecTest::readsErrorsAsTheSpecificationWritesThem()
{
    const auto number = parseSerialError(wordsOf("error FlashWear 12 \"wait\""));
    QCOMPARE(number->context.english("seconds"), std::string("12"));
    QCOMPARE(number->context.english("reason"), std::string("wait"));
    const auto spelled = parseSerialError(wordsOf("error FlashWear retry 12 \"wait\""));
    QCOMPARE(spelled->context.english("seconds"), std::string("12"));
    const auto strange = parseSerialError(wordsOf("error Overheated \"too hot\""));
    QCOMPARE(strange->code, ErrorCode::DriveRejected);
    QCOMPARE(strange->detail, std::string("Overheated"));
    QCOMPARE(strange->context.english("reason"), std::string("too hot"));
    QVERIFY(!parseSerialError(wordsOf("ok error")));
    QVERIFY(!parseSerialError(wordsOf("error")));
}

void SerialCodecTest::keepsIdentityFileAndReadings()
{
    const DriveIdentity identity{"Press \"7\"", -4711, 2};
    const auto words = wordsOf(serialIdentity(identity, "generic"));
    QVERIFY(parseSerialIdentity(words) == identity);
    const DriveFile file{"tables/small1.TAMtbl", 304, 63360};
    QVERIFY(parseSerialFile(wordsOf(serialFile(file))) == file);
    using Limits = std::numeric_limits<float>;
    for (const RegisterValue& value :
        {RegisterValue{0.1F}, RegisterValue{-0.0F}, RegisterValue{Limits::denorm_min()},
            RegisterValue{Limits::max()}, RegisterValue{Limits::infinity()}}) {
        const RegisterReading reading{"Axes[0]/A", 17, "Single", value};
        QVERIFY(parseSerialTreeLine(wordsOf(serialTreeLine(reading))) == reading);
    }
    const RegisterReading state{"Axes[0]/A", 17, "HomingState", std::string("HomingDone")};
    QVERIFY(parseSerialTreeLine(wordsOf(serialTreeLine(state))) == state);
}

void SerialCodecTest::refusesWhatIsNoReply()
{
    for (const char* text : {"a", "a 1", "a b 2", "a 1 2000", "a 99999999999 2", "a 1 -2"})
        QVERIFY2(!parseSerialIdentity(wordsOf(text)), text);
    for (const char* text : {"Double", "Double x", "Double 1 2", "Int32 1.5", "Boolean maybe"})
        QVERIFY2(!parseSerialReading(wordsOf(text)), text);
    for (const char* text : {"a", "a 1", "a 1 x", "a -1 2", "a 1 2 3", "\"\" 1 2"})
        QVERIFY2(!parseSerialFile(wordsOf(text)), text);
    QCOMPARE(parseSerialNumber("1c291ca3", 16).value(), 0x1c291ca3U);
    for (const char* text : {"", "x", "1 ", "0x10", "100000000"})
        QVERIFY2(!parseSerialNumber(text, 16), text);
}

AXISCOMP_TEST(SerialCodecTest)

} // namespace tst_serialcodec

#include "tst_serialcodec.moc"
