// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/request_head.h"
#include "tests/drivecomm/web/web_site.h"
#include "tests/support/test_registry.h"

#include <QTest>

namespace tst_webhostile {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

namespace {

const std::string local = "Host: 127.0.0.1\r\n";
const std::string writeVariable = "PUT /registers/" + variable0 + " HTTP/1.1\r\n" + local
    + "Content-Type: application/json\r\nContent-Length: 11\r\n\r\n{\"value\":1}";

std::string part(const std::string& headers, const std::string& content)
{
    return "--b\r\n" + headers + "\r\n\r\n" + content + "\r\n";
}

std::string namedPart(const std::string& name, const std::string& content)
{
    return part("Content-Disposition: form-data; name=\"" + name + "\"", content);
}

std::string transferOf(const std::string& body, const std::string& type)
{
    return "POST /transfer HTTP/1.1\r\n" + local + "Content-Type: " + type
        + "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
}

} // namespace

class WebHostileTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void refusesAHeadAndCloses_data();
    void refusesAHeadAndCloses();
    void takesAHeadAtTheLimit();
    void takesAHeadInPieces();
    void knowsEveryLineEndThatIsCutInTwo();
    void refusesForms_data();
    void refusesForms();
    void neverLeadsBackToAnotherSite_data();
    void neverLeadsBackToAnotherSite();
};

void WebHostileTest::refusesAHeadAndCloses_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<int>("status");
    const auto row = [](const char* name, const std::string& request, int status) {
        QTest::newRow(name) << QByteArray::fromStdString(request) << status;
    };
    const std::string begin = "GET /directory HTTP/1.1\r\n" + local;
    const std::string put = "PUT /registers/" + variable0 + " HTTP/1.1\r\n" + local
        + "Content-Type: application/json\r\n";
    const std::string body = "\r\n{\"value\":1}";
    row("long address", "GET /" + std::string(40'000, 'a'), 414);
    row("long field", begin + "X: " + std::string(40'000, 'a'), 431);
    row(
        "many fields",
        [&] {
            std::string many = begin;
            for (std::size_t i = 0; i < mostHeadFields; ++i)
                many += "X" + std::to_string(i) + ": 1\r\n";
            return many + "\r\n";
        }(),
        431);
    row(
        "endless fields",
        [&] {
            std::string many = begin;
            while (many.size() < mostHeadBytes)
                many += "X: 1\r\n";
            return many;
        }(),
        431);
    row("NUL in a field", begin + std::string("X: a\0b\r\n\r\n", 10), 400);
    row("NUL in the address", std::string("GET /\0 HTTP/1.1\r\n", 17) + local + "\r\n", 400);
    row("lines that end in LF", "GET / HTTP/1.1\nHost: 127.0.0.1\n\n", 400);
    row("a lone CR", begin + "X: a\rY: b\r\n\r\n", 400);
    row("two CRs", begin + "X: a\r\r\n\r\n", 400);
    row("TLS", "\x16\x03\x01\x02", 400);
    row("a folded line", begin + "X: a\r\n b\r\n\r\n", 400);
    row("a blank ahead of the colon", put + "Content-Length : 11\r\n" + body, 400);
    row("no colon", begin + "hello\r\n\r\n", 400);
    row("no name", begin + ": x\r\n\r\n", 400);
    row("two hosts", begin + "Host: evil.example\r\n\r\n", 400);
    row("no request line", "\r\n\r\n", 400);
    row("no HTTP", "GET /directory\r\n\r\n", 400);
    row("another version", "GET / HTTP/7.0\r\n" + local + "\r\n", 505);
    row("an address of another site", "GET http://evil.example/ HTTP/1.1\r\n" + local + "\r\n",
        400);
    row("blanks in the address", "GET /a b HTTP/1.1\r\n" + local + "\r\n", 400);
    row("length: negative", put + "Content-Length: -1\r\n" + body, 400);
    row("length: signed", put + "Content-Length: +11\r\n" + body, 400);
    row("length: hexadecimal", put + "Content-Length: 0xB\r\n" + body, 400);
    row("length: empty", put + "Content-Length:\r\n" + body, 400);
    row("length: a list", put + "Content-Length: 11, 11\r\n" + body, 400);
    row("length: beyond 64 bits", put + "Content-Length: 18446744073709551627\r\n" + body, 413);
    row("length: twice", put + "Content-Length: 11\r\nContent-Length: 11\r\n" + body, 400);
    row("length: two", put + "Content-Length: 11\r\ncontent-length: 0\r\n" + body, 400);
    row("length and chunks",
        put + "Content-Length: 4\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n", 400);
    row("two codings", put + "Transfer-Encoding: gzip, chunked\r\n\r\n0\r\n\r\n", 501);
    row("a coding that looks like chunked", put + "Transfer-Encoding: xchunked\r\n\r\n0\r\n\r\n",
        501);
    row("codings in two fields",
        put + "Transfer-Encoding: chunked\r\nTransfer-Encoding: identity\r\n\r\n0\r\n\r\n", 501);
    row("a request in the body of a GET",
        begin + "Content-Length: " + std::to_string(writeVariable.size()) + "\r\n\r\n"
            + writeVariable,
        400);
    row("a request in the chunks of a GET",
        begin + "Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n" + writeVariable, 400);
}

void WebHostileTest::refusesAHeadAndCloses()
{
    QFETCH(QByteArray, request);
    QFETCH(int, status);
    Site site;
    RawClient client(site.server->port());
    client.send(request.toStdString() + writeVariable); // what follows must not be understood
    const QByteArray reply = client.receiveAll();
    const QByteArray expected = "HTTP/1.1 " + QByteArray::number(status) + ' ';
    QVERIFY2(reply.startsWith(expected), reply.left(300).constData());
    QCOMPARE(reply.count("HTTP/1.1 "), 1);
    QCOMPARE(client.socket.state(), QAbstractSocket::UnconnectedState);
    QCOMPARE(site.value(variable0), RegisterValue(0.0F));
    QVERIFY(site.client.Get("/directory"));
}

void WebHostileTest::takesAHeadAtTheLimit()
{
    Site site;
    std::string request = "GET /directory HTTP/1.1\r\n" + local;
    for (std::size_t i = 1; i < mostHeadFields; ++i)
        request += "X" + std::to_string(i) + ": " + std::string(200, 'x') + "\r\n";
    RawClient client(site.server->port());
    client.send(request + "Connection: close\r\n\r\n"); // one too many
    QVERIFY(client.receiveAll().startsWith("HTTP/1.1 431 "));
    RawClient next(site.server->port());
    next.send(request + "\r\n");
    QVERIFY(next.socket.waitForReadyRead(webPatienceMs));
    QVERIFY(next.received().startsWith("HTTP/1.1 200 "));
}

void WebHostileTest::takesAHeadInPieces()
{
    Site site;
    RawClient client(site.server->port());
    for (const char c : get("/directory", "Connection: close\r\n"))
        client.send(std::string(1, c));
    QVERIFY(client.receiveAll().startsWith("HTTP/1.1 200 "));
}

void WebHostileTest::knowsEveryLineEndThatIsCutInTwo()
{
    Site site;
    const std::string request = get(registersOf({stateOfX}), "Connection: close\r\n");
    for (std::size_t cut = 1; cut < request.size(); ++cut) {
        if (request[cut - 1] != '\r' && request[cut - 1] != '\n')
            continue;
        RawClient client(site.server->port());
        client.send(request.substr(0, cut));
        client.send(request.substr(cut));
        QVERIFY(client.receiveAll().startsWith("HTTP/1.1 200 "));
    }
}

void WebHostileTest::refusesForms_data()
{
    QTest::addColumn<QByteArray>("request");
    QTest::addColumn<int>("status");
    const auto row = [](const char* name, const std::string& body, const std::string& type,
                         int status) {
        QTest::newRow(name) << QByteArray::fromStdString(transferOf(body, type)) << status;
    };
    const std::string form = "multipart/form-data; boundary=b";
    const std::string path = namedPart("filepath", small1);
    const std::string end = "--b--\r\n";
    row("no boundary", path + end, "multipart/form-data", 400);
    row("empty boundary", path + end, "multipart/form-data; boundary=", 400);
    row("another boundary", path + end, "multipart/form-data; boundary=c", 400);
    row("no end", path, form, 400);
    row("cut in a header", "--b\r\nContent-Disp", form, 400);
    row("a part without a name", path + part("Content-Type: text/plain", "x") + end, form, 400);
    row(
        "many parts",
        [&] {
            std::string many;
            for (int i = 0; i < 100; ++i)
                many += namedPart("x", "y");
            return many + end;
        }(),
        form, 400);
    row("a form in a form",
        path
            + part("Content-Disposition: form-data; name=\"file\"; filename=\"a\"\r\n"
                   "Content-Type: multipart/mixed; boundary=c",
                "--c\r\nContent-Disposition: file; filename=\"b\"\r\n\r\n" + tableFile(50)
                    + "\r\n--c--")
            + end,
        form, 422);
    row("a path in the name of the file",
        path
            + part("Content-Disposition: form-data; name=\"file\"; filename=\"../../x\"\r\n"
                   "Content-Type: application/octet-stream",
                "no table")
            + end,
        form, 422);
}

void WebHostileTest::refusesForms()
{
    QFETCH(QByteArray, request);
    QFETCH(int, status);
    Site site;
    RawClient client(site.server->port());
    client.send(request.toStdString());
    QVERIFY(client.socket.waitForReadyRead(webPatienceMs));
    const QByteArray expected = "HTTP/1.1 " + QByteArray::number(status) + ' ';
    QVERIFY2(client.received().startsWith(expected), client.received().left(300).constData());
    QVERIFY(site.drive.download(small1)->empty());
    QVERIFY(site.client.Get("/directory"));
}

void WebHostileTest::neverLeadsBackToAnotherSite_data()
{
    QTest::addColumn<QByteArray>("referer");
    QTest::addColumn<QByteArray>("link");
    QTest::newRow("a page here") << QByteArray("http://127.0.0.1/transfer")
                                 << QByteArray("\"/transfer\"");
    QTest::newRow("two slashes") << QByteArray("http://127.0.0.1//evil.example/")
                                 << QByteArray("\"/evil.example/\"");
    QTest::newRow("another site") << QByteArray("http://evil.example/") << QByteArray("\"/\"");
    QTest::newRow("a script") << QByteArray("http://127.0.0.1/\"><script>alert(1)</script>")
                              << QByteArray("&quot;&gt;&lt;script&gt;");
}

void WebHostileTest::neverLeadsBackToAnotherSite()
{
    QFETCH(QByteArray, referer);
    QFETCH(QByteArray, link);
    Site site;
    RawClient client(site.server->port());
    client.send(get("/nix", "Connection: close\r\nReferer: " + referer.toStdString() + "\r\n"));
    const QByteArray reply = client.receiveAll();
    QVERIFY(reply.startsWith("HTTP/1.1 404 "));
    QVERIFY2(reply.contains(link), reply.constData());
    QVERIFY(!reply.contains("//evil.example"));
    QVERIFY(!reply.contains("<script>"));
}

AXISCOMP_TEST(WebHostileTest)

} // namespace tst_webhostile

#include "tst_webhostile.moc"
