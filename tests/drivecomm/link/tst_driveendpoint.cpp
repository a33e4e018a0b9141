// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link/drive_endpoint.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_driveendpoint {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

class DriveEndpointTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void readsAddresses_data();
    void readsAddresses();
    void readsSerialDevices();
    void refusesWhatIsNoAddress_data();
    void refusesWhatIsNoAddress();
    void neverShowsThePassword_data();
    void neverShowsThePassword();
};

void DriveEndpointTest::readsAddresses_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("host");
    QTest::addColumn<int>("port");
    QTest::addColumn<QString>("user");
    QTest::addColumn<QString>("password");
    QTest::addColumn<QString>("shown");
    const int http = static_cast<int>(DriveEndpoint::Kind::Http);
    const int https = static_cast<int>(DriveEndpoint::Kind::Https);
    const int demo = static_cast<int>(DriveEndpoint::Kind::Demo);
    const auto row = [](const char* text, int kind, const char* host, int port, const char* user,
                         const char* password, const char* shown) {
        QTest::newRow(text) << text << kind << host << port << user << password << shown;
    };
    row("http://192.168.1.20", http, "192.168.1.20", 80, "", "", "http://192.168.1.20");
    row("  http://192.168.1.20/ ", http, "192.168.1.20", 80, "", "", "http://192.168.1.20");
    row("HTTP://Drive:8080", http, "drive", 8080, "", "", "http://drive:8080");
    row("http://drive:80", http, "drive", 80, "", "", "http://drive");
    row("https://drive.local", https, "drive.local", 443, "", "", "https://drive.local");
    row("https://drive:80", https, "drive", 80, "", "", "https://drive:80");
    row("http://[fe80::1]:8080", http, "fe80::1", 8080, "", "", "http://[fe80::1]:8080");
    row("http://anna@drive", http, "drive", 80, "anna", "", "http://drive");
    row("http://anna:s%40c%3Aret@drive:65535", http, "drive", 65535, "anna", "s@c:ret",
        "http://drive:65535");
    row("demo:", demo, "", 0, "", "", "demo:");
    row("demo", demo, "", 0, "", "", "demo:");
}

void DriveEndpointTest::readsAddresses()
{
    QFETCH(QString, text);
    QFETCH(int, kind);
    QFETCH(QString, host);
    QFETCH(int, port);
    QFETCH(QString, user);
    QFETCH(QString, password);
    QFETCH(QString, shown);
    const auto endpoint = parseEndpoint(text.toStdString());
    VERIFY_RESULT(endpoint);
    QCOMPARE(static_cast<int>(endpoint->kind), kind);
    QCOMPARE(endpoint->host, host.toStdString());
    QCOMPARE(static_cast<int>(endpoint->port), port);
    QCOMPARE(endpoint->user, user.toStdString());
    QCOMPARE(endpoint->password, password.toStdString());
    QCOMPARE(displayText(*endpoint), shown.toStdString());
    const auto again = parseEndpoint(displayText(*endpoint));
    VERIFY_RESULT(again);
    QCOMPARE(again->host, endpoint->host);
    QCOMPARE(again->port, endpoint->port);
}

void DriveEndpointTest::readsSerialDevices()
{
    const auto plain = parseEndpoint("serial:/dev/ttyUSB0");
    VERIFY_RESULT(plain);
    QCOMPARE(plain->kind, DriveEndpoint::Kind::Serial);
    QCOMPARE(plain->device, std::string("/dev/ttyUSB0"));
    QCOMPARE(plain->baud, 115200);
    QCOMPARE(displayText(*plain), std::string("serial:/dev/ttyUSB0"));
    const auto slow = parseEndpoint("serial:/dev/serial/by-id/usb-A%20B?baud=9600");
    VERIFY_RESULT(slow);
    QCOMPARE(slow->device, std::string("/dev/serial/by-id/usb-A B"));
    QCOMPARE(slow->baud, 9600);
}

void DriveEndpointTest::refusesWhatIsNoAddress_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("reason");
    QTest::newRow("nothing") << ""
                             << "http://host";
    QTest::newRow("a bare name") << "drive"
                                 << "http://host";
    QTest::newRow("a bare address") << "192.168.1.20"
                                    << "http://host";
    QTest::newRow("another scheme") << "ftp://drive"
                                    << "http://host";
    QTest::newRow("no host") << "http://"
                             << "http";
    QTest::newRow("no host but a port") << "http://:80"
                                        << "http";
    QTest::newRow("a path") << "http://drive/directory"
                            << "no path";
    QTest::newRow("a query") << "http://drive?a=b"
                             << "no path";
    QTest::newRow("a fragment") << "http://drive#a"
                                << "no path";
    QTest::newRow("port 0") << "http://drive:0"
                            << "port 0";
    QTest::newRow("a port that is none") << "http://drive:70000"
                                         << "http://host";
    QTest::newRow("a bare @ in a password") << "http://anna:s3@cret@drive"
                                            << "%40 for @";
    QTest::newRow("a bare slash in a password") << "http://anna:12/s3cret@drive"
                                                << "%2F for /";
    QTest::newRow("a bare number sign in a password") << "http://anna:12#s3cret@drive"
                                                      << "%23 for #";
    QTest::newRow("a bare percent sign in a password") << "https://anna:s3%@drive"
                                                       << "%25 for %";
    QTest::newRow("a blank") << "http://dri ve"
                             << "http://host";
    QTest::newRow("a relative device") << "serial:ttyUSB0"
                                       << "absolute path";
    QTest::newRow("a device on a host") << "serial://host/dev/ttyUSB0"
                                        << "absolute path";
    QTest::newRow("no device") << "serial:"
                               << "absolute path";
    QTest::newRow("an unknown option") << "serial:/dev/ttyUSB0?speed=9600"
                                       << "baud";
    QTest::newRow("a baud rate that is none") << "serial:/dev/ttyUSB0?baud=fast"
                                              << "baud";
    QTest::newRow("a baud rate of 0") << "serial:/dev/ttyUSB0?baud=0"
                                      << "baud";
}

void DriveEndpointTest::refusesWhatIsNoAddress()
{
    QFETCH(QString, text);
    QFETCH(QString, reason);
    const auto endpoint = parseEndpoint(text.toStdString());
    VERIFY_ERROR(endpoint, ErrorCode::InvalidEndpoint);
    const QString said = QString::fromStdString(endpoint.error().context.english("reason"));
    QVERIFY2(said.contains(reason), qPrintable(said));
}

void DriveEndpointTest::neverShowsThePassword_data()
{
    QTest::addColumn<QString>("text");
    for (const char* text : {"http://anna:s3cret@", "http://anna:s3cret@drive/path",
             "http://anna:s3cret@drive:0", "ftp://anna:s3cret@drive", "http://anna:s3cret@dri ve",
             "http://anna:s3cret@drive:99999", "anna:s3cret@drive", "http//anna:s3cret@drive"})
        QTest::newRow(text) << text;
}

void DriveEndpointTest::neverShowsThePassword()
{
    QFETCH(QString, text);
    const auto endpoint = parseEndpoint(text.toStdString());
    VERIFY_ERROR(endpoint, ErrorCode::InvalidEndpoint);
    QVERIFY(describe(endpoint.error()).find("s3cret") == std::string::npos);
}

AXISCOMP_TEST(DriveEndpointTest)

} // namespace tst_driveendpoint

#include "tst_driveendpoint.moc"
