// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/crc16.h"
#include "drivecomm/serial/ymodem.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <random>

namespace tst_ymodem {

using namespace axiscomp;
using namespace axiscomp::test;
using namespace axiscomp::drivecomm;
using namespace std::chrono_literals;
using ymodem::Clock;
using ymodem::Receiver;
using ymodem::Sender;
using ymodem::State;

namespace {

constexpr int ack = 6;
constexpr int nak = 21;
constexpr int can = 24;
constexpr int eot = 4;
constexpr std::uint64_t limit = std::uint64_t{4} << 20;

Bytes someFile(std::size_t size, std::uint32_t seed = 1)
{
    std::mt19937 random(seed);
    Bytes file(size);
    for (std::byte& byte : file)
        byte = static_cast<std::byte>(random() & 0xFFU);
    return file;
}

Bytes bytesOf(std::initializer_list<int> values)
{
    Bytes bytes;
    for (const int value : values)
        bytes.push_back(static_cast<std::byte>(value));
    return bytes;
}

/// A sender and a receiver with a wire between them, in a time of their own.
struct Wire {
    using Noise = std::function<void(Bytes&, bool fromSender)>;

    explicit Wire(const Bytes& theFile) : file(theFile) { }

    void run(const Noise& noise = {})
    {
        for (int rounds = 0; rounds < 200'000; ++rounds) {
            Bytes forth = sender.output();
            Bytes back = receiver.output();
            if (!sender.isRunning() && !receiver.isRunning())
                return;
            sent += forth.size();
            if (noise) {
                noise(forth, true);
                noise(back, false);
            }
            if (forth.empty() && back.empty()) {
                now = std::min(sender.isRunning() ? sender.wakeAt() : Clock::time_point::max(),
                    receiver.isRunning() ? receiver.wakeAt() : Clock::time_point::max());
                sender.tick(now);
                receiver.tick(now);
                continue;
            }
            now += 1ms;
            (void)receiver.feed(forth, now);
            (void)sender.feed(back, now);
        }
        QFAIL("the transfer does not end");
    }

    Bytes file;
    Clock::time_point now{std::chrono::hours(1)};
    Sender sender{"small1.TAMtbl", file, now};
    Receiver receiver{limit, std::nullopt, now};
    std::size_t sent = 0;
};

/// Changes bytes with the given probability.
Wire::Noise flips(std::uint32_t seed, double probability)
{
    return [random = std::mt19937(seed), probability](Bytes& bytes, bool) mutable {
        std::bernoulli_distribution hit(probability);
        std::uniform_int_distribution<unsigned> mask(1, 255);
        for (std::byte& byte : bytes)
            if (hit(random))
                byte ^= static_cast<std::byte>(mask(random));
    };
}

Bytes block(int kind, int number, Bytes content)
{
    content.resize(kind == 1 ? 128 : 1024, std::byte{0x1A});
    Bytes bytes = bytesOf({kind, number, 255 - number});
    bytes.insert(bytes.end(), content.begin(), content.end());
    const std::uint16_t crc = crc16(content, crcXmodem);
    bytes.push_back(static_cast<std::byte>(crc >> 8U));
    bytes.push_back(static_cast<std::byte>(crc & 0xFFU));
    return bytes;
}

Bytes headerBlock(std::string_view text)
{
    Bytes content(asBytes(text).begin(), asBytes(text).end());
    content.resize(128, std::byte{0});
    return block(1, 0, content);
}

} // namespace

class YmodemTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void hasTheChecksumOfTheProtocol();
    void bringsAFileOver_data();
    void bringsAFileOver();
    void usesTheLine();
    void asksForAGarbledBlockAgain();
    void survivesALostAnswer_data();
    void survivesALostAnswer();
    void neverGivesAWrongFile_data();
    void neverGivesAWrongFile();
    void losesNothingWithLostBytes();
    void endsAtOnceWhenOneSideCancels();
    void takesADoubleCancelInsideDataForData();
    void givesUpWithoutTheOtherSide();
    void refusesATooLargeFile();
    void takesAFileWithoutASize();
    void leavesWhatComesAfterTheEnd();
    void theNextLineEndsATransferWhoseLastAnswerWasLost();
    void readsHeadersOfOthers_data();
    void readsHeadersOfOthers();
    void repeatsTheSameBlockUnderANumber();
};

void YmodemTest::hasTheChecksumOfTheProtocol()
{
    QCOMPARE(crc16(asBytes("123456789"), crcXmodem), std::uint16_t{0x31C3});
    QCOMPARE(crc16(asBytes("123456789"), crcCcittFalse), std::uint16_t{0x29B1});
}

void YmodemTest::bringsAFileOver_data()
{
    QTest::addColumn<int>("size");
    for (const int size : {0, 1, 127, 128, 129, 1023, 1024, 1025, 63360, 300'000})
        QTest::addRow("%d bytes", size) << size;
}

void YmodemTest::bringsAFileOver()
{
    QFETCH(int, size);
    Wire wire(someFile(static_cast<std::size_t>(size)));
    wire.run();
    QCOMPARE(wire.sender.state(), State::Done);
    QCOMPARE(wire.receiver.state(), State::Done);
    QVERIFY(wire.receiver.takeFile() == wire.file);
    QCOMPARE(QString::fromStdString(wire.receiver.header().name), QStringLiteral("small1.TAMtbl"));
    QCOMPARE(wire.receiver.header().size.value(), std::uint64_t(size));
    QCOMPARE(wire.sender.acknowledged(), std::uint64_t(size));
}

void YmodemTest::usesTheLine()
{
    Wire wire(someFile(1'000'000));
    wire.run();
    QVERIFY(static_cast<double>(wire.file.size()) / static_cast<double>(wire.sent) > 0.99);
}

void YmodemTest::asksForAGarbledBlockAgain()
{
    int blocks = 0;
    Wire wire(someFile(5000));
    wire.run([&](Bytes& bytes, bool fromSender) {
        if (fromSender && bytes.size() > 1000 && ++blocks % 2 == 1)
            bytes[500] ^= std::byte{1};
    });
    QCOMPARE(wire.receiver.state(), State::Done);
    QVERIFY(wire.receiver.takeFile() == wire.file);
    QCOMPARE(blocks, 10);
}

void YmodemTest::survivesALostAnswer_data()
{
    QTest::addColumn<int>("lost");
    for (int n = 0; n < 12; ++n)
        QTest::addRow("answer %d", n) << n;
}

void YmodemTest::survivesALostAnswer()
{
    QFETCH(int, lost);
    int answers = 0;
    Wire wire(someFile(3000));
    wire.run([&](Bytes& bytes, bool fromSender) {
        if (!fromSender && !bytes.empty() && answers++ == lost)
            bytes.clear();
    });
    QCOMPARE(wire.sender.state(), State::Done);
    QCOMPARE(wire.receiver.state(), State::Done);
    QVERIFY(wire.receiver.takeFile() == wire.file);
}

void YmodemTest::neverGivesAWrongFile_data()
{
    QTest::addColumn<double>("probability");
    QTest::addColumn<int>("runs");
    QTest::addColumn<int>("mustArrive");
    QTest::newRow("1 in 20000") << 1.0 / 20000 << 40 << 40;
    QTest::newRow("1 in 2000") << 1.0 / 2000 << 40 << 38;
    QTest::newRow("1 in 300") << 1.0 / 300 << 20 << 0;
    QTest::newRow("1 in 20") << 1.0 / 20 << 10 << 0;
}

void YmodemTest::neverGivesAWrongFile()
{
    QFETCH(double, probability);
    QFETCH(int, runs);
    QFETCH(int, mustArrive);
    int arrived = 0;
    for (int run = 0; run < runs; ++run) {
        Wire wire(someFile(20'000, static_cast<std::uint32_t>(run)));
        wire.run(flips(static_cast<std::uint32_t>(1000 + run), probability));
        if (wire.receiver.state() != State::Done)
            continue;
        ++arrived;
        QVERIFY2(wire.receiver.takeFile() == wire.file, qPrintable(QString::number(run)));
    }
    QVERIFY2(arrived >= mustArrive, qPrintable(QString::number(arrived)));
}

void YmodemTest::losesNothingWithLostBytes()
{
    std::mt19937 random(7);
    Wire wire(someFile(30'000));
    wire.run([&](Bytes& bytes, bool) {
        if (!bytes.empty() && random() % 8 == 0)
            bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(random() % bytes.size()));
    });
    QCOMPARE(wire.receiver.state(), State::Done);
    QVERIFY(wire.receiver.takeFile() == wire.file);
}

void YmodemTest::endsAtOnceWhenOneSideCancels()
{
    for (const bool senderCancels : {true, false}) {
        Wire wire(someFile(50'000));
        int blocks = 0;
        Clock::time_point cancelled;
        wire.run([&](Bytes& bytes, bool fromSender) {
            if (fromSender && bytes.size() > 1000 && ++blocks == 5) {
                if (senderCancels)
                    wire.sender.cancel();
                else
                    wire.receiver.cancel();
                cancelled = wire.now;
            }
        });
        QCOMPARE(senderCancels ? wire.receiver.state() : wire.sender.state(), State::Cancelled);
        QCOMPARE(senderCancels ? wire.sender.state() : wire.receiver.state(), State::Failed);
        QVERIFY(wire.now - cancelled <= 10ms);
    }
}

void YmodemTest::takesADoubleCancelInsideDataForData()
{
    Wire wire(Bytes(10'000, std::byte{can}));
    int blocks = 0;
    wire.run([&](Bytes& bytes, bool fromSender) {
        // A garbled kind: what follows is no block for the receiver.
        if (fromSender && bytes.size() > 1000 && ++blocks == 3)
            bytes[0] = std::byte{0x55};
    });
    QCOMPARE(wire.receiver.state(), State::Done);
    QVERIFY(wire.receiver.takeFile() == wire.file);
}

void YmodemTest::givesUpWithoutTheOtherSide()
{
    const Bytes file = someFile(3000);
    Clock::time_point now{};
    Sender sender("a", file, now);
    Receiver receiver(limit, std::nullopt, now);
    while (sender.isRunning() || receiver.isRunning()) {
        now += 500ms;
        sender.tick(now);
        receiver.tick(now);
        QVERIFY(now < Clock::time_point(2min));
    }
    QCOMPARE(sender.state(), State::Failed);
    QVERIFY(!sender.failure().empty());
    QCOMPARE(receiver.state(), State::Failed);
    QVERIFY(!receiver.failure().empty());

    Wire wire(someFile(50'000)); // and in mid-transfer
    int blocks = 0;
    wire.run([&](Bytes& bytes, bool fromSender) {
        if (fromSender && bytes.size() > 1000 && ++blocks > 5)
            bytes.clear();
        else if (!fromSender && blocks > 5)
            bytes.clear();
    });
    QCOMPARE(wire.sender.state(), State::Failed);
    QCOMPARE(wire.receiver.state(), State::Failed);
}

void YmodemTest::refusesATooLargeFile()
{
    const Bytes file = someFile(2000);
    Clock::time_point now{};
    Receiver announced(1999, std::nullopt, now);
    (void)announced.feed(headerBlock(std::string_view("a\0"
                                                      "2000",
                             6)),
        now);
    QCOMPARE(announced.state(), State::Failed);
    Receiver endless(1000, std::nullopt, now);
    (void)endless.feed(headerBlock("a"), now);
    QVERIFY(endless.isRunning());
    (void)endless.feed(block(2, 1, file), now);
    QCOMPARE(endless.state(), State::Failed);
    QVERIFY(endless.failure().find("too large") != std::string::npos);
}

void YmodemTest::takesAFileWithoutASize()
{
    const Bytes file = someFile(1024);
    const Clock::time_point now{};
    Receiver receiver(limit, std::nullopt, now);
    (void)receiver.feed(headerBlock("a"), now);
    (void)receiver.feed(block(2, 1, file), now);
    (void)receiver.output();
    (void)receiver.feed(bytesOf({eot}), now); // may be a garbled byte
    QVERIFY(receiver.output() == bytesOf({nak}));
    (void)receiver.feed(bytesOf({eot}), now);
    QVERIFY(receiver.output() == bytesOf({ack, 'C'}));
    (void)receiver.feed(headerBlock(""), now);
    QCOMPARE(receiver.state(), State::Done);
    QVERIFY(receiver.takeFile() == file);

    Receiver told(limit, 1000, now); // by whoever asked for the file
    (void)told.feed(headerBlock("a"), now);
    (void)told.feed(block(2, 1, file), now);
    QCOMPARE(told.received(), std::uint64_t{1000});
}

void YmodemTest::leavesWhatComesAfterTheEnd()
{
    const Clock::time_point now{};
    Receiver receiver(limit, std::nullopt, now);
    (void)receiver.feed(headerBlock(std::string_view("a\0"
                                                     "0",
                            3)),
        now);
    Bytes rest = bytesOf({eot});
    const Bytes last = headerBlock("");
    rest.insert(rest.end(), last.begin(), last.end());
    const std::size_t whole = rest.size();
    rest.push_back(std::byte{'#'});
    rest.push_back(std::byte{'6'});
    QCOMPARE(receiver.feed(rest, now), whole);
    QCOMPARE(receiver.state(), State::Done);
}

/// rb empties its output when it ends, and its last ACK with it.
void YmodemTest::theNextLineEndsATransferWhoseLastAnswerWasLost()
{
    const Bytes file = someFile(100, 1);
    Clock::time_point now{std::chrono::hours(1)};
    Sender sender("small1.TAMtbl", file, now);
    const auto say = [&](std::initializer_list<int> values) {
        now += 1ms;
        return sender.feed(bytesOf(values), now);
    };
    say({'C'});
    say({ack});
    say({'C'});
    say({ack});
    say({ack});
    say({'C'});
    (void)sender.output();
    QVERIFY(say({0x07}) == 1); // an ACK that the line changed: it is said again
    QVERIFY(sender.isRunning());
    const std::string line = "identify\r";
    QCOMPARE(sender.feed(asBytes(line), now), std::size_t{0});
    QVERIFY(sender.state() == State::Done);
    QVERIFY(sender.output().empty());
}

void YmodemTest::readsHeadersOfOthers_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<qint64>("size"); // -1: none, -2: no header
    QTest::newRow("lrzsz") << QByteArray("t.bin\0"
                                         "63360 14567012345 100644 0 1 63360\0",
        42) << QByteArray("t.bin")
                           << qint64(63360);
    QTest::newRow("name only") << QByteArray("t.bin\0\0\0", 8) << QByteArray("t.bin") << qint64(-1);
    QTest::newRow("the last") << QByteArray(128, '\0') << QByteArray() << qint64(-1);
    QTest::newRow("no end") << QByteArray(128, 'x') << QByteArray() << qint64(-2);
    QTest::newRow("no number") << QByteArray("a\0"
                                             "12x4\0",
        7) << QByteArray() << qint64(-2);
    QTest::newRow("a minus") << QByteArray("a\0-1\0", 5) << QByteArray() << qint64(-2);
    QTest::newRow("too large") << QByteArray("a\0"
                                             "99999999999999999999999\0",
        26) << QByteArray() << qint64(-2);
}

void YmodemTest::readsHeadersOfOthers()
{
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, name);
    QFETCH(qint64, size);
    const auto header = ymodem::parseHeader(
        asBytes({content.constData(), static_cast<std::size_t>(content.size())}));
    QCOMPARE(header.has_value(), size != -2);
    if (!header)
        return;
    QCOMPARE(QByteArray::fromStdString(header->name), name);
    QCOMPARE(header->size ? static_cast<qint64>(*header->size) : -1, size);
}

void YmodemTest::repeatsTheSameBlockUnderANumber()
{
    const Bytes file = someFile(5000);
    Clock::time_point now{};
    Sender sender("a", file, now);
    const auto feed = [&](std::initializer_list<int> bytes) {
        now += 1s;
        (void)sender.feed(bytesOf(bytes), now);
        return sender.output();
    };
    QCOMPARE(feed({'C'}).size(), std::size_t{133});
    QVERIFY(feed({ack}).empty());
    const Bytes first = feed({'C'});
    QCOMPARE(first.size(), std::size_t{1029});
    for (int n = 0; n < 5; ++n)
        QVERIFY(feed({nak}) == first);
    // Only what follows becomes short.
    QCOMPARE(feed({ack}).size(), std::size_t{133});
    QCOMPARE(sender.acknowledged(), std::uint64_t{1024});
}

AXISCOMP_TEST(YmodemTest)

} // namespace tst_ymodem

#include "tst_ymodem.moc"
