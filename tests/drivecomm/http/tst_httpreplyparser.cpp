// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http/http_reply_parser.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_httpreplyparser {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;
using State = HttpReplyParser::State;

class HttpReplyParserTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void readsReplies_data();
    void readsReplies();
    void waitsForTheRest_data();
    void waitsForTheRest();
    void rejects_data();
    void rejects();
    void knowsWhetherTheConnectionCanBeKept_data();
    void knowsWhetherTheConnectionCanBeKept();
};

namespace {

HttpReplyParser fed(const QByteArray& bytes, qsizetype piece)
{
    HttpReplyParser parser(100);
    for (qsizetype i = 0; i < bytes.size(); i += piece)
        parser.feed(bytes.mid(i, piece).toStdString());
    return parser;
}

} // namespace

void HttpReplyParserTest::readsReplies_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("body");
    const auto row = [](const char* name, const char* bytes, int status, const char* body) {
        QTest::newRow(name) << QByteArray(bytes) << status << QByteArray(body);
    };
    row("with a length", "HTTP/1.1 200 OK\r\nContent-Length: 5\r\n\r\nhello", 200, "hello");
    row("names in any case", "HTTP/1.1 200 OK\r\ncOnTeNt-LeNgTh:5\r\n\r\nhello", 200, "hello");
    row("without a reason", "HTTP/1.1 404\r\nContent-Length: 2\r\n\r\nno", 404, "no");
    row("bare line ends", "HTTP/1.1 200 OK\nContent-Length: 2\n\nok", 200, "ok");
    row("in chunks",
        "HTTP/1.1 200 OK\r\nTransfer-Encoding: "
        "chunked\r\n\r\n3\r\nabc\r\nA;x=y\r\n0123456789\r\n0\r\n\r\n",
        200, "abc0123456789");
    row("chunks and a trailer",
        "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n1\r\na\r\n0\r\nX: y\r\n\r\n", 200,
        "a");
    row("chunks win over a length",
        "HTTP/1.1 200 OK\r\nContent-Length: 99\r\nTransfer-Encoding: "
        "Chunked\r\n\r\n1\r\na\r\n0\r\n\r\n",
        200, "a");
    row("no content", "HTTP/1.1 204 No Content\r\nContent-Length: 7\r\n\r\n", 204, "");
    row("not modified", "HTTP/1.1 304 Not Modified\r\nContent-Length: 700\r\n\r\n", 304, "");
    row("empty", "HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n", 200, "");
    row("interim replies first",
        "HTTP/1.1 100 Continue\r\n\r\nHTTP/1.1 102 Processing\r\nContent-Length: 9\r\n\r\n"
        "HTTP/1.1 201 Created\r\nContent-Length: 1\r\n\r\nx",
        201, "x");
    row("not compressed",
        "HTTP/1.1 200 OK\r\nContent-Encoding: Identity\r\nContent-Length: 1\r\n\r\nx", 200, "x");
    row("of no age", "HTTP/1.1 200 OK\r\nAge: 0\r\nContent-Length: 1\r\n\r\nx", 200, "x");
    row("the same length twice",
        "HTTP/1.1 200 OK\r\nContent-Length: 1\r\nContent-Length: 1\r\n\r\nx", 200, "x");
}

void HttpReplyParserTest::readsReplies()
{
    QFETCH(QByteArray, bytes);
    QFETCH(int, status);
    QFETCH(QByteArray, body);
    for (const qsizetype piece : {qsizetype{1}, qsizetype{2}, qsizetype{7}, bytes.size()}) {
        HttpReplyParser parser = fed(bytes, piece);
        QCOMPARE(parser.state(), State::Complete);
        const HttpReply reply = parser.take();
        QCOMPARE(reply.status, status);
        QCOMPARE(QByteArray::fromStdString(reply.body), body);
        QVERIFY(reply.hasEnd);
    }
}

void HttpReplyParserTest::waitsForTheRest_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("endsWithConnection");
    QTest::newRow("nothing") << QByteArray() << false;
    QTest::newRow("the version") << QByteArray("HTTP/1.") << false;
    QTest::newRow("a head") << QByteArray("HTTP/1.1 200 OK\r\nContent-Length: 5\r\n") << false;
    QTest::newRow("a part") << QByteArray("HTTP/1.1 200 OK\r\nContent-Length: 5\r\n\r\nhell")
                            << false;
    QTest::newRow("a chunk") << QByteArray(
        "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n3\r\nabc\r\n")
                             << false;
    QTest::newRow("no length") << QByteArray("HTTP/1.1 200 OK\r\n\r\nhello") << true;
}

void HttpReplyParserTest::waitsForTheRest()
{
    QFETCH(QByteArray, bytes);
    QFETCH(bool, endsWithConnection);
    HttpReplyParser parser = fed(bytes, 3);
    QCOMPARE(parser.state(), State::Incomplete);
    parser.end();
    QCOMPARE(parser.state(), endsWithConnection ? State::Complete : State::Incomplete);
    if (endsWithConnection) {
        const HttpReply reply = parser.take();
        QCOMPARE(reply.body, std::string("hello"));
        QVERIFY(!reply.hasEnd);
    }
}

void HttpReplyParserTest::rejects_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("expected");
    QTest::addColumn<QString>("found");
    const auto row = [](const char* name, const QByteArray& bytes, const char* expected,
                         const char* found) { QTest::newRow(name) << bytes << expected << found; };
    const QByteArray ok = "HTTP/1.1 200 OK\r\n";
    row("another protocol", "SSH-2.0-OpenSSH\r\n", "an HTTP reply", "SSH-2.0-OpenSSH");
    row("something binary", QByteArray("\x15\x03\x01\x00\x02\x02\x46", 7), "an HTTP reply", "\x15");
    row("HTTP 2", "HTTP/2 200\r\n", "an HTTP reply", "HTTP/2");
    row("no status", "HTTP/1.1 OK\r\n", "status line", "HTTP/1.1 OK");
    row("a status below 100", "HTTP/1.1 099 OK\r\n", "status line", "099");
    row("a field without a name", ok + ": x\r\n", "header field", ": x");
    row("a field without a colon", ok + "hello\r\n", "header field", "hello");
    row("a negative length", ok + "Content-Length: -1\r\n", "Content-Length", "-1");
    row("two lengths", ok + "Content-Length: 1\r\nContent-Length: 2\r\n", "Content-Length", "2");
    row("a list of lengths", ok + "Content-Length: 1, 1\r\n", "Content-Length", "1, 1");
    row("another encoding", ok + "Transfer-Encoding: gzip\r\n", "chunked", "gzip");
    row("compressed", ok + "Content-Encoding: gzip\r\n", "no Content-Encoding", "gzip");
    row("more than announced", ok + "Content-Length: 1\r\n\r\nab", "Content-Length announces", "b");
    row("more than nothing", ok + "Content-Length: 0\r\n\r\nab", "Content-Length announces", "ab");
    row("kept by a cache", ok + "Age: 30\r\n", "cache or proxy", "Age: 30");
    row("a chunk without a size", ok + "Transfer-Encoding: chunked\r\n\r\nx\r\n", "size", "x");
    row("a chunk without an end", ok + "Transfer-Encoding: chunked\r\n\r\n1\r\nab\r\n", "end", "b");
    row("more than the limit", ok + "Content-Length: 101\r\n\r\n", "at most 100 bytes", "101");
    row("chunks beyond the limit",
        ok + "Transfer-Encoding: chunked\r\n\r\nff\r\n" + QByteArray(255, 'a'), "at most 100 bytes",
        "aaa");
    row("endless until the end", ok + "\r\n" + QByteArray(101, 'a'), "at most 100 bytes", "aaa");
    row("an endless line", ok + QByteArray(70'000, 'a'), "at most 64 KiB", "aaa");
    row("endless fields", ok + QByteArray("a: b\r\n").repeated(20'000), "at most 64 KiB", "a: b");
    row("an endless trailer",
        ok + "Transfer-Encoding: chunked\r\n\r\n0\r\n" + QByteArray("a: b\r\n").repeated(20'000),
        "at most 64 KiB", "a: b");
}

void HttpReplyParserTest::rejects()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, expected);
    QFETCH(QString, found);
    for (const qsizetype piece : {qsizetype{1}, bytes.size()}) {
        const HttpReplyParser parser = fed(bytes, piece);
        QCOMPARE(parser.state(), State::Failed);
        const QString said = QString::fromStdString(parser.expected().english());
        QVERIFY2(said.contains(expected), qPrintable(said));
        if (piece > 1)
            QVERIFY(
                QByteArray::fromStdString(std::string(parser.found())).contains(found.toLatin1()));
    }
}

void HttpReplyParserTest::knowsWhetherTheConnectionCanBeKept_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("keeps");
    QTest::newRow("1.1") << QByteArray("HTTP/1.1 204 x\r\n\r\n") << true;
    QTest::newRow("1.0") << QByteArray("HTTP/1.0 204 x\r\n\r\n") << false;
    QTest::newRow("close") << QByteArray("HTTP/1.1 204 x\r\nConnection: Close\r\n\r\n") << false;
    QTest::newRow("more than a reply") << QByteArray("HTTP/1.1 204 x\r\n\r\nx") << false;
}

void HttpReplyParserTest::knowsWhetherTheConnectionCanBeKept()
{
    QFETCH(QByteArray, bytes);
    QFETCH(bool, keeps);
    for (const qsizetype piece : {qsizetype{1}, bytes.size()})
        QCOMPARE(fed(bytes, piece).keepsConnection(), keeps);
}

AXISCOMP_TEST(HttpReplyParserTest)

} // namespace tst_httpreplyparser

#include "tst_httpreplyparser.moc"
