// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivecomm/web/web_site.h"
#include "tests/support/test_registry.h"

#include <QElapsedTimer>
#include <QTest>

#include <sys/socket.h>

namespace tst_webconnections {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

class WebConnectionsTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void answersAClientThatHasSaidAll();
    void answersOneRequestAfterTheOther();
    void cutsAtTheExactByte_data();
    void cutsAtTheExactByte();
    void cutsOnlyOnce();
    void aHangingClientKeepsNobodyWaiting();
    void stopsWhateverItsClientsDo();
    void stopsWhileItDecidesOverAReply();
    void garblesOneReply();
    void refusesAnAddressInUse();
    void refusesACertificateThatIsNone();
};

void WebConnectionsTest::answersAClientThatHasSaidAll()
{
    Site site;
    RawClient client(site.server->port());
    client.send(get(registersOf({stateOfX})));
    ::shutdown(static_cast<int>(client.socket.socketDescriptor()), SHUT_WR);
    const QByteArray reply = client.receiveAll();
    QVERIFY(reply.startsWith("HTTP/1.1 200 OK"));
    QVERIFY(reply.contains("\"Disabled\""));
    QCOMPARE(client.socket.state(), QAbstractSocket::UnconnectedState);
}

void WebConnectionsTest::answersOneRequestAfterTheOther()
{
    Site site;
    RawClient client(site.server->port());
    for (int i = 0; i < 20; ++i) {
        client.send(get(registersOf({stateOfX})));
        QVERIFY(client.socket.waitForReadyRead(webPatienceMs));
        while (!client.received().endsWith("]\n"))
            QVERIFY(client.socket.waitForReadyRead(webPatienceMs));
        QVERIFY(client.take().startsWith("HTTP/1.1 200 OK"));
    }
}

void WebConnectionsTest::cutsAtTheExactByte_data()
{
    QTest::addColumn<int>("bytes");
    for (const int bytes : {1, 2, 10, 50, 117, 118, 119, 150, 200, 400, 999, 1000, 1111})
        QTest::addRow("%d bytes", bytes) << bytes;
}

void WebConnectionsTest::cutsAtTheExactByte()
{
    QFETCH(int, bytes);
    Site site;
    VERIFY_RESULT(site.drive.upload(small1, asBytes(tableFile(300))));
    const std::string request = get("/files/" + small1, "Connection: close\r\n");
    RawClient whole(site.server->port());
    whole.send(request);
    const QByteArray complete = whole.receiveAll();
    QVERIFY(complete.size() > 1200);

    site.fault("drop-after=" + std::to_string(bytes));
    RawClient cut(site.server->port());
    cut.send(request);
    const QByteArray received = cut.receiveAll();
    const auto expected = std::max<qsizetype>(0, bytes - static_cast<qsizetype>(request.size()));
    QCOMPARE(received.size(), std::min(expected, complete.size()));
    QCOMPARE(received, complete.first(received.size()));
}

void WebConnectionsTest::cutsOnlyOnce()
{
    Site site;
    site.fault("drop-after=10");
    QVERIFY(!site.client.Put("/registers/" + variable0, R"({"value":1})", "application/json"));
    QCOMPARE(site.value(variable0), RegisterValue(0.0F));
    const auto second =
        site.client.Put("/registers/" + variable0, R"({"value":1})", "application/json");
    QVERIFY(second);
    QCOMPARE(second->status, 204);
}

void WebConnectionsTest::aHangingClientKeepsNobodyWaiting()
{
    Site site;
    site.fault("no-reply=1");
    RawClient hanging(site.server->port());
    hanging.send(get("/directory"));
    std::vector<std::unique_ptr<RawClient>> idle;
    for (int i = 0; i < 40; ++i) {
        idle.push_back(std::make_unique<RawClient>(site.server->port()));
        idle.back()->send("GET / HTTP/1.1\r\nHost: 127.0"); // and never the rest
    }
    // The fault waits for the first request that is complete.
    QVERIFY(!hanging.socket.waitForReadyRead(50));
    const auto reply = site.client.Get("/directory");
    QVERIFY(reply);
    QCOMPARE(reply->status, 200);
    QCOMPARE(hanging.socket.state(), QAbstractSocket::ConnectedState);
    QCOMPARE(hanging.socket.bytesAvailable(), 0);
}

void WebConnectionsTest::stopsWhateverItsClientsDo()
{
    Site site;
    site.fault("no-reply=1");
    RawClient hanging(site.server->port());
    hanging.send(get("/directory"));
    QVERIFY(!hanging.socket.waitForReadyRead(50));
    site.fault("slow=600000");
    RawClient slow(site.server->port());
    slow.send(get("/directory"));
    RawClient idle(site.server->port());
    RawClient halfway(site.server->port());
    halfway.send("POST /transfer HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 1000\r\n\r\nabc");
    QElapsedTimer timer;
    timer.start();
    site.server.reset();
    QVERIFY(timer.elapsed() < webPatienceMs); // not the keep-alive time, let alone the slow reply
    for (RawClient* client : {&hanging, &slow, &idle, &halfway}) {
        client->receiveAll();
        QCOMPARE(client->socket.state(), QAbstractSocket::UnconnectedState);
    }
}

/// The end wakes the thread that serves the request, which then decides that there is no reply.
void WebConnectionsTest::stopsWhileItDecidesOverAReply()
{
    for (int i = 0; i < 10; ++i) {
        Site site;
        site.fault("slow=600000");
        site.fault("no-reply=1");
        RawClient client(site.server->port());
        client.send("PUT /registers/" + variable0
            + " HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\n"
              "Content-Length: 11\r\n\r\n{\"value\":1}");
        QTRY_COMPARE_WITH_TIMEOUT(site.value(variable0), RegisterValue(1.0F), webPatienceMs);
        site.server.reset();
        client.receiveAll();
        QCOMPARE(client.socket.state(), QAbstractSocket::UnconnectedState);
    }
}

void WebConnectionsTest::garblesOneReply()
{
    Site site;
    const auto good = site.client.Get("/directory");
    site.fault("garble=2");
    const auto bad = site.client.Get("/directory");
    const auto after = site.client.Get("/directory");
    QVERIFY(good && bad && after);
    QVERIFY(bad->body != good->body);
    QCOMPARE(bad->body.size(), good->body.size());
    QVERIFY(after->body == good->body);
    site.fault("garble=4");
    QVERIFY(!site.client.Put("/registers/" + variable0, R"({"value":1})", "application/json"));
    QCOMPARE(site.value(variable0), RegisterValue(1.0F));
}

void WebConnectionsTest::refusesAnAddressInUse()
{
    const Site site;
    VirtualDrive drive(genericProfile(), Site::driveOptions("Other"));
    FaultPlan faults;
    WebServerOptions options;
    options.port = site.server->port();
    const auto second = WebServer::start(drive, genericProfile(), faults, options);
    VERIFY_ERROR(second, ErrorCode::InvalidEndpoint);
    QCOMPARE(second.error().context.english("endpoint"), site.server->url());
    options.host = "not an address";
    VERIFY_ERROR(
        WebServer::start(drive, genericProfile(), faults, options), ErrorCode::InvalidEndpoint);
    options.host = "192.0.2.1";
    VERIFY_ERROR(
        WebServer::start(drive, genericProfile(), faults, options), ErrorCode::InvalidEndpoint);
}

void WebConnectionsTest::refusesACertificateThatIsNone()
{
    VirtualDrive drive(genericProfile(), Site::driveOptions("Secure"));
    FaultPlan faults;
    WebServerOptions options;
    options.certificateFile = "/nonexistent/certificate.pem";
    VERIFY_ERROR(
        WebServer::start(drive, genericProfile(), faults, options), ErrorCode::InvalidEndpoint);
    options.privateKeyFile = "/nonexistent/key.pem";
    const auto server = WebServer::start(drive, genericProfile(), faults, options);
    VERIFY_ERROR(server, ErrorCode::InvalidEndpoint);
    QVERIFY(sentence(server.error()).find("/nonexistent/certificate.pem") != std::string::npos);
}

AXISCOMP_TEST(WebConnectionsTest)

} // namespace tst_webconnections

#include "tst_webconnections.moc"
