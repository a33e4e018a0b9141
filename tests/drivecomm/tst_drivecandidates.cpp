// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/drive_candidates.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <filesystem>

namespace tst_drivecandidates {

using namespace axiscomp;
using namespace axiscomp::drivecomm;

namespace {

using Endpoints = std::vector<std::string>;

} // namespace

class TestDriveCandidates : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void anAddressIsTriedAsItIs_data();
    void anAddressIsTriedAsItIs();
    void theGivenBaudRateIsTriedFirst();
    void aPortIsLookedAtWithItsHardware();
    void aPortThatAnAddressNamesIsLeftOut();
    void aPortIsTheSameUnderAnotherName();
    void portsOfThisMachineHaveAbsolutePaths();
    void theAddressesOfARangeAreLookedAtOverHttp();
    void anAddressThatIsKnownIsNotAskedAgain();
    void networksOfThisMachineCanBeSearched();
};

void TestDriveCandidates::anAddressIsTriedAsItIs_data()
{
    QTest::addColumn<QString>("endpoint");
    QTest::newRow("web") << "http://192.168.1.20";
    QTest::newRow("with a password") << "http://user:secret@drive";
    QTest::newRow("demo") << "demo:";
    QTest::newRow("not valid") << "nonsense";
}

void TestDriveCandidates::anAddressIsTriedAsItIs()
{
    QFETCH(const QString, endpoint);
    const std::string text = endpoint.toStdString();
    QVERIFY(candidateAt(text, BaudRates::Usual)
        == (DriveCandidate{.endpoints = {text}, .description = {}}));
}

void TestDriveCandidates::theGivenBaudRateIsTriedFirst()
{
    const auto asGiven = candidateAt("serial:/dev/ttyS0?baud=57600");
    QVERIFY(asGiven.endpoints == Endpoints{"serial:/dev/ttyS0?baud=57600"});
    const auto any = candidateAt("serial:/dev/ttyS0?baud=57600", BaudRates::Usual);
    QCOMPARE(any.endpoints.front(), std::string("serial:/dev/ttyS0?baud=57600"));
    QCOMPARE(any.endpoints.at(1), std::string("serial:/dev/ttyS0"));
    QCOMPARE(std::ranges::count(any.endpoints, any.endpoints.front()), 1);
    QCOMPARE(any.endpoints.size(), std::size_t(8));
    // A rate of one's own is one more.
    QCOMPARE(candidateAt("serial:/dev/ttyS0?baud=250000", BaudRates::Usual).endpoints.size(),
        std::size_t(9));
}

void TestDriveCandidates::aPortIsLookedAtWithItsHardware()
{
    const std::vector<SerialPort> ports{{"/dev/ttyUSB0", "FT232R USB UART, FTDI"}};
    const auto candidates = candidatesAt(ports, {});
    QCOMPARE(candidates.size(), std::size_t(1));
    QVERIFY(candidates.front().endpoints == Endpoints{"serial:/dev/ttyUSB0"});
    QCOMPARE(candidates.front().description, std::string("FT232R USB UART, FTDI"));
    // In more time the link would send more than one `identify`.
    QVERIFY(candidates.front().timeout <= std::chrono::milliseconds(500));
    QCOMPARE(candidatesAt(ports, {}, BaudRates::Usual).front().endpoints.size(), std::size_t(8));
}

void TestDriveCandidates::aPortThatAnAddressNamesIsLeftOut()
{
    const std::vector<SerialPort> ports{{"/dev/none-0", ""}, {"/dev/none-1", ""}};
    const Endpoints known{"http://192.168.1.20", "serial:/dev/none-1?baud=921600"};
    const auto candidates = candidatesAt(ports, known);
    QCOMPARE(candidates.size(), std::size_t(1));
    QVERIFY(candidates.front().endpoints == Endpoints{"serial:/dev/none-0"});
}

void TestDriveCandidates::aPortIsTheSameUnderAnotherName()
{
    const QTemporaryDir folder;
    const std::filesystem::path link =
        std::filesystem::path(folder.path().toStdString()) / "usb-FTDI-if00";
    std::filesystem::create_symlink("/dev/null", link);
    const std::vector<SerialPort> ports{{"/dev/null", ""}};
    QVERIFY(candidatesAt(ports, Endpoints{"serial:" + link.string()}).empty());
    QCOMPARE(placeOf("serial:" + link.string() + "?baud=9600"), std::string("/dev/null"));
    QCOMPARE(placeOf("http://user:secret@192.168.1.20"), std::string("http://192.168.1.20"));
    QCOMPARE(placeOf("no address"), std::string("no address"));
}

void TestDriveCandidates::portsOfThisMachineHaveAbsolutePaths()
{
    for (const SerialPort& port : serialPorts()) {
        const auto candidates = candidatesAt(std::vector{port}, {});
        QCOMPARE(candidates.size(), std::size_t(1));
        QVERIFY2(candidates.front().endpoints.front().starts_with("serial:/"),
            candidates.front().endpoints.front().c_str());
    }
}

void TestDriveCandidates::theAddressesOfARangeAreLookedAtOverHttp()
{
    const auto range = parseNetworkRange("127.0.0.9-127.0.0.11:8080");
    VERIFY_RESULT(range);
    const auto candidates = candidatesIn(*range, {});
    QCOMPARE(candidates.size(), std::size_t(3));
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        QVERIFY(candidates[i].endpoints
            == Endpoints{"http://127.0.0." + std::to_string(9 + i) + ":8080"});
        QVERIFY(candidates[i].isUnknown);
        QCOMPARE(candidates[i].timeout, std::chrono::milliseconds(1000));
    }
}

void TestDriveCandidates::anAddressThatIsKnownIsNotAskedAgain()
{
    const auto range = parseNetworkRange("127.0.0.1-3");
    VERIFY_RESULT(range);
    const std::vector<std::string> known{
        "http://user:secret@127.0.0.2/", "http://127.0.0.3:8080", "demo:", "nonsense"};
    const auto candidates = candidatesIn(*range, known);
    QCOMPARE(candidates.size(), std::size_t(2));
    QCOMPARE(candidates[0].endpoints.front(), std::string("http://127.0.0.1"));
    QCOMPARE(candidates[1].endpoints.front(), std::string("http://127.0.0.3"));
}

/// Nothing is asked: this only reads what the computer has.
void TestDriveCandidates::networksOfThisMachineCanBeSearched()
{
    for (const std::string& network : ownNetworks()) {
        VERIFY_RESULT(parseNetworkRange(network));
        QVERIFY2(!network.starts_with("127."), network.c_str());
    }
}

AXISCOMP_TEST(TestDriveCandidates)

} // namespace tst_drivecandidates

#include "tst_drivecandidates.moc"
