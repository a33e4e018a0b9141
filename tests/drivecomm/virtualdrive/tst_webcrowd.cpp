// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/connection_relay.h"
#include "tests/drivecomm/web/web_site.h"
#include "tests/support/test_certificate.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QSslSocket>
#include <QTest>

#include <sys/socket.h>

#include <filesystem>

namespace tst_webcrowd {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

namespace {

WebServerOptions impatient()
{
    WebServerOptions options;
    options.patience = std::chrono::milliseconds(300);
    return options;
}

/// Sends a byte of request now and then, never its end, until the server closes.
/// False when the server does not.
bool isCutWhileDripping(QTcpSocket& socket, const QByteArray& request)
{
    for (qsizetype i = 0; i < 3000; ++i) {
        socket.write(request.constData() + std::min(i, request.size() - 1), 1);
        socket.flush();
        if (socket.state() != QAbstractSocket::ConnectedState || socket.waitForDisconnected(10))
            return true;
    }
    return false;
}

std::size_t openDescriptors()
{
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

/// Of this process, from /proc: "VmRSS" in KiB, "Threads".
long long processFigure(const QByteArray& name)
{
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return -1;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith(name + ':'))
            return line.mid(name.size() + 1).simplified().split(' ').first().toLongLong();
    return -1;
}

} // namespace

class WebCrowdTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void cutsAClientThatNeverFinishes_data();
    void cutsAClientThatNeverFinishes();
    void cutsAClientThatNeverFinishesOverTls();
    void cutsAClientThatNeverGreets();
    void cutsAClientThatDoesNotTakeItsReply();
    void waitsForItsOwnSlowAnswers();
    void answersAmongAThousandConnections_data();
    void answersAmongAThousandConnections();
    void keepsTheConnectionWhoseRequestItHas();
};

void WebCrowdTest::cutsAClientThatNeverFinishes_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::newRow("head") << QByteArray("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: aaaa");
    QTest::newRow("body") << QByteArray("PUT /registers HTTP/1.1\r\nHost: 127.0.0.1\r\n"
                                        "Content-Length: 100000\r\n\r\n ");
    QTest::newRow("chunks") << QByteArray("PUT /registers HTTP/1.1\r\nHost: 127.0.0.1\r\n"
                                          "Transfer-Encoding: chunked\r\n\r\nfffff\r\n ");
}

void WebCrowdTest::cutsAClientThatNeverFinishes()
{
    QFETCH(QByteArray, request);
    Site site(impatient());
    RawClient client(site.server->port());
    client.send(request.chopped(4).toStdString());
    QVERIFY(isCutWhileDripping(client.socket, request.last(4)));
    QVERIFY(site.client.Get("/directory"));
}

void WebCrowdTest::cutsAClientThatNeverFinishesOverTls()
{
    const TestCertificate certificate(QStringLiteral("IP:127.0.0.1"));
    WebServerOptions options = impatient();
    options.certificateFile = certificate.certificateFile().toStdString();
    options.privateKeyFile = certificate.keyFile().toStdString();
    Site site(options);
    QSslSocket socket;
    socket.setPeerVerifyMode(QSslSocket::VerifyNone);
    socket.connectToHostEncrypted(QStringLiteral("127.0.0.1"), site.server->port());
    QVERIFY(socket.waitForEncrypted(webPatienceMs));
    QVERIFY(isCutWhileDripping(socket, "GET / HTTP/1.1\r\nX: a"));
}

void WebCrowdTest::cutsAClientThatNeverGreets()
{
    const TestCertificate certificate(QStringLiteral("IP:127.0.0.1"));
    WebServerOptions options = impatient();
    options.certificateFile = certificate.certificateFile().toStdString();
    options.privateKeyFile = certificate.keyFile().toStdString();
    Site site(options);
    RawClient silent(site.server->port());
    QVERIFY(silent.socket.waitForDisconnected(webPatienceMs));
}

void WebCrowdTest::cutsAClientThatDoesNotTakeItsReply()
{
    Site site(impatient());
    VERIFY_RESULT(site.drive.upload("tables/large1.TAMtbl", asBytes(tableFile(500'000))));
    RawClient client(site.server->port());
    const auto descriptor = static_cast<int>(client.socket.socketDescriptor());
    const int small = 4096;
    ::setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
    client.socket.setReadBufferSize(1);
    for (int i = 0; i < 20; ++i) // more than all buffers on the way hold
        client.send(get("/files/tables/large1.TAMtbl"));
    // The socket is not read, so only its other side shows that the server has closed.
    QTRY_VERIFY_WITH_TIMEOUT(([&] {
        QByteArray more = "GET / HTTP/1.1\r\n";
        return ::send(descriptor, more.constData(), static_cast<std::size_t>(more.size()),
                   MSG_NOSIGNAL | MSG_DONTWAIT)
            < 0
            && errno != EAGAIN;
    }()),
        webPatienceMs);
    QVERIFY(site.client.Get("/directory"));
}

void WebCrowdTest::waitsForItsOwnSlowAnswers()
{
    Site site(impatient());
    site.fault("slow=900"); // three times what a client may take
    const auto reply = site.client.Get("/directory");
    QVERIFY(reply);
    QCOMPARE(reply->status, 200);
}

void WebCrowdTest::answersAmongAThousandConnections_data()
{
    QTest::addColumn<QByteArray>("begin");
    QTest::newRow("that say nothing") << QByteArray();
    QTest::newRow("that never finish") << QByteArray("GET / HTTP/1.1\r\nHost: 127.");
    QTest::newRow("that send half a file")
        << QByteArray("POST /transfer HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 60000\r\n\r\n")
            + QByteArray(30'000, 'x');
    QTest::newRow("that leave without an answer") << QByteArray::fromStdString(get("/directory"));
}

void WebCrowdTest::answersAmongAThousandConnections()
{
    QFETCH(QByteArray, begin);
    Site site;
    const std::size_t before = openDescriptors();
    const long long memoryBefore = processFigure("VmRSS");
    constexpr int crowd = 1000;
    // Not httplib's client, which cannot have more than 1024 descriptors beside it.
    RawClient kept(site.server->port());
    std::vector<std::unique_ptr<QTcpSocket>> clients;
    for (int i = 0; i < crowd; ++i) {
        clients.push_back(std::make_unique<QTcpSocket>());
        clients.back()->connectToHost(QStringLiteral("127.0.0.1"), site.server->port());
        QVERIFY(clients.back()->waitForConnected(webPatienceMs));
        clients.back()->write(begin);
        clients.back()->flush();
        if (i % 50 != 0)
            continue;
        // Who has a connection keeps it, and who comes anew gets one.
        kept.send(get(registersOf({stateOfX})));
        while (!kept.received().endsWith("]\n"))
            QVERIFY(kept.socket.waitForReadyRead(webPatienceMs));
        QVERIFY(kept.take().startsWith("HTTP/1.1 200 "));
        RawClient fresh(site.server->port());
        fresh.send(get("/directory", "Connection: close\r\n"));
        QVERIFY(fresh.receiveAll().startsWith("HTTP/1.1 200 "));
    }
    // Two in the relay and one in the server for each connection.
    const std::size_t most = before + crowd + 3 * ConnectionRelay::mostConnections + 50;
    QVERIFY2(openDescriptors() < most, std::to_string(openDescriptors()).c_str());
    QVERIFY(processFigure("Threads") < 300);
    const long long grown = processFigure("VmRSS") - memoryBefore;
    QVERIFY2(grown < 200'000, std::to_string(grown).c_str()); // KiB
    clients.clear();
    QTRY_VERIFY_WITH_TIMEOUT(openDescriptors() < before + 20, webPatienceMs);
}

void WebCrowdTest::keepsTheConnectionWhoseRequestItHas()
{
    Site site;
    site.fault("slow=2000");
    RawClient first(site.server->port());
    first.send(get(registersOf({stateOfX}), "Connection: close\r\n"));
    QTRY_COMPARE_WITH_TIMEOUT(site.requests.load(), 1, webPatienceMs);
    std::vector<std::unique_ptr<RawClient>> clients;
    for (std::size_t i = 0; i < 2 * ConnectionRelay::mostConnections; ++i)
        clients.push_back(std::make_unique<RawClient>(site.server->port()));
    QVERIFY(first.receiveAll().startsWith("HTTP/1.1 200 "));
}

AXISCOMP_TEST(WebCrowdTest)

} // namespace tst_webcrowd

#include "tst_webcrowd.moc"
