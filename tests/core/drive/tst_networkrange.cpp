// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/network_range.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_networkrange {

using namespace axiscomp;

class TestNetworkRange : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    // Compared with Python's ipaddress.ip_network(...).hosts().
    void aRangeIsReadAndSaidAgain_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("said");
        QTest::addColumn<int>("count");
        const auto row = [](const char* text, const char* said, int count) {
            QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(said) << count;
        };
        row("192.168.1.0/24", "192.168.1.1-192.168.1.254", 254);
        row("192.168.1.77/24", "192.168.1.1-192.168.1.254", 254);
        row("10.20.30.0/22", "10.20.28.1-10.20.31.254", 1022);
        row("10.0.0.4/30", "10.0.0.5-10.0.0.6", 2);
        row("10.0.0.4/31", "10.0.0.4-10.0.0.5", 2);
        row("10.0.0.4/32", "10.0.0.4", 1);
        row("192.168.1.10-192.168.2.9", "192.168.1.10-192.168.2.9", 256);
        row("192.168.1.10-40", "192.168.1.10-192.168.1.40", 31);
        row("192.168.1.20", "192.168.1.20", 1);
        row(" 127.0.0.1-5:8080 ", "127.0.0.1-127.0.0.5:8080", 5);
        row("10.0.0.0-10.0.3.255", "10.0.0.0-10.0.3.255", 1024);
        row("192.168.1.20:80", "192.168.1.20", 1);
        row("223.255.255.255", "223.255.255.255", 1);
    }
    void aRangeIsReadAndSaidAgain()
    {
        QFETCH(QString, text);
        QFETCH(QString, said);
        QFETCH(int, count);
        const auto range = parseNetworkRange(text.toStdString());
        VERIFY_RESULT(range);
        QCOMPARE(QString::fromStdString(toText(*range)), said);
        QCOMPARE(static_cast<int>(range->count()), count);
        const auto again = parseNetworkRange(toText(*range));
        VERIFY_RESULT(again);
        QVERIFY(*again == *range);
        const auto all = addressesIn(*range);
        QCOMPARE(static_cast<int>(all.size()), count);
        QVERIFY(said.startsWith(QString::fromStdString(all.front())));
        QVERIFY(said.contains(QString::fromStdString(all.back())));
    }

    void whatIsNoRangeSaysWhy_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* text, const char* reason) {
            QTest::newRow(*text ? text : "empty")
                << QString::fromUtf8(text) << QString::fromUtf8(reason);
        };
        for (const char* text : {"", " ", "drive-7", "192.168.1", "192.168.1.256", "192.168.01.1",
                 "192.168.1.1.1", "192.168.1.0/33", "192.168.1.0/", "192.168.1.0/-1",
                 "192.168.1.1-", "-192.168.1.1", "192.168.1.1-2-3", "fe80::1", "192.168.1.+1",
                 "192.168.1.1 - 5", "192.168.1.0/24-30", "192.168.1.1-5/24"})
            row(text, "192.168.1.0/24");
        row("192.168.1.40-192.168.1.10", "before the first");
        row("192.168.1.40-10", "before the first");
        row("10.0.0.0/8", "16777214 addresses");
        row("10.0.0.0/21", "2046 addresses");
        row("10.0.0.0-10.0.4.0", "1025 addresses");
        row("0.0.0.0/0", "addresses");
        row("0.0.0.1", "no addresses of computers");
        row("223.255.255.255-224.0.0.1", "no addresses of computers");
        row("255.255.255.255", "no addresses of computers");
        row("192.168.1.20:0", "1 to 65535");
        row("192.168.1.20:65536", "1 to 65535");
        row("192.168.1.20:", "1 to 65535");
    }
    void whatIsNoRangeSaysWhy()
    {
        QFETCH(QString, text);
        QFETCH(QString, reason);
        const auto range = parseNetworkRange(text.toStdString());
        VERIFY_ERROR(range, ErrorCode::InvalidArgument);
        const QString said = QString::fromStdString(sentence(range.error()));
        QVERIFY2(said.contains(reason), qPrintable(said));
    }

    void theNetworkOfAnAddressIsProposed()
    {
        constexpr std::uint32_t address = 0xc0a8014d; // 192.168.1.77
        QCOMPARE(networkAround(address, 24), std::string("192.168.1.0/24"));
        QCOMPARE(networkAround(address, 28), std::string("192.168.1.64/28"));
        QCOMPARE(networkAround(address, 22), std::string("192.168.0.0/22"));
        QCOMPARE(networkAround(address, 16), std::string("192.168.1.0/24"));
        QCOMPARE(networkAround(address, 0), std::string("192.168.1.0/24"));
        QCOMPARE(networkAround(address, 32), std::string("192.168.1.77/32"));
        for (int prefixLength = 0; prefixLength <= 32; ++prefixLength)
            VERIFY_RESULT(parseNetworkRange(networkAround(address, prefixLength)));
    }
};

AXISCOMP_TEST(TestNetworkRange)

} // namespace tst_networkrange

#include "tst_networkrange.moc"
