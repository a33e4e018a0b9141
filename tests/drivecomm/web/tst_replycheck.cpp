// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivecomm/web/web_link_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

namespace tst_replycheck {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;
using namespace std::chrono_literals;

class WebAnswersTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void rejectsNonsenseForRegisters_data();
    void rejectsNonsenseForRegisters();
    void acceptsTheAnswerThatItRejectsVariantsOf();
    void endsAtTheDeadline_data();
    void endsAtTheDeadline();
    void limitsWhatItTakes_data();
    void limitsWhatItTakes();
    void readsAgainAfterALostConnection();
    void givesUpReadingAfterTwoRepeats();
    void neverRepeatsAWrite_data();
    void neverRepeatsAWrite();
    void mapsAStatusWithoutJson_data();
    void mapsAStatusWithoutJson();
    void readsTheDirectoryOfADriveThatOnlyHasThePage();
    void takesADirectoryPageToItsEnd_data();
    void takesADirectoryPageToItsEnd();
    void rejectsAnotherDirectoryPage_data();
    void rejectsAnotherDirectoryPage();
    void rejectsATransferThatIsNoFile_data();
    void rejectsATransferThatIsNoFile();
};

void WebAnswersTest::rejectsNonsenseForRegisters_data()
{
    QTest::addColumn<Answer>("answer");
    QTest::addColumn<QString>("quote");
    const std::string good = states(stateOfX, stateOfY);
    const auto row = [](const char* name) -> QTestData& { return QTest::newRow(name); };
    row("a page for JSON") << always(httpReply("200 OK", "text/html", "<html>Login</html>"))
                           << "<html>Login";
    row("JSON that ends too early") << json(good.substr(0, good.size() / 2)) << "path";
    row("another order") << json(states(stateOfY, stateOfX)) << "Axes[1]";
    row("other registers") << json(states(stateOfX, "Axes[7]/Nix")) << "Axes[0]";
    row("one register too few") << json(
        readingsJson(std::vector<RegisterReading>{{stateOfX, 1, "State", std::string("Disabled")}}))
                                << "Axes[0]";
    row("nothing") << json("") << "nothing";
    row("an object for an array") << json("{}") << "{}";
    row("a number for the path") << json(R"([{"path":1,"address":1,"type":"A","value":1}])") << "1";
    row("a text for a number") << json(
        R"([{"path":"a","address":1,"type":"Int32","value":"1"},{}])")
                               << "Int32";
    row("an address that is none")
        << json(R"([{"path":"a","address":-1,"type":"Int32","value":1},{}])") << "-1";
    row("deeply nested") << json(std::string(50'000, '[')) << "[[[[";
    row("control characters") << json("\x01\x02\xff\n\tabc") << "... abc";
    row("success without an answer") << always("HTTP/1.1 204 No Content\r\n\r\n") << "nothing";
    row("something that is no HTTP") << once("SSH-2.0-OpenSSH_9.2p1 Debian-2\r\n") << "";
    row("a broken status line") << once("HTTP/1.1 abc OK\r\n\r\n") << "";
    row("a redirect") << always("HTTP/1.1 302 Found\r\nLocation: https://drive.example/\r\n"
                                "Content-Length: 0\r\n\r\n")
                      << "https://drive.example/";
    row("a server's own error") << always(
        httpReply("500 Internal Server Error", "text/html", "<h1>Oops &amp; sorry</h1>"))
                                << "Oops & sorry";
    row("overloaded without a time")
        << always(httpReply("503 Service Unavailable", "text/html", "Busy")) << "Busy";
}

void WebAnswersTest::rejectsNonsenseForRegisters()
{
    QFETCH(Answer, answer);
    QFETCH(QString, quote);
    const RawResponder responder(answer);
    const auto result = webLinkTo(responder.url())->readRegisters(twoStates, {});
    VERIFY_ERROR(result, ErrorCode::Protocol);
    QCOMPARE(result.error().context.english("endpoint"), responder.url());
    QVERIFY(!result.error().context.english("expected").empty());
    const QString shown = QString::fromStdString(result.error().context.english("quote"));
    QVERIFY2(shown.contains(quote), qPrintable(shown));
    QVERIFY(!shown.isEmpty() && shown.size() < 200);
}

void WebAnswersTest::acceptsTheAnswerThatItRejectsVariantsOf()
{
    const RawResponder responder(json(states(stateOfX, stateOfY)));
    const auto result = webLinkTo(responder.url())->readRegisters(twoStates, {});
    VERIFY_RESULT(result);
    QCOMPARE(result->at(1).value, RegisterValue("Active"));
}

void WebAnswersTest::endsAtTheDeadline_data()
{
    QTest::addColumn<Answer>("answer");
    QTest::newRow("no answer") << Answer([](RawConnection& c) {
        c.readRequest();
        c.waitUntilGone();
    });
    QTest::newRow("the request is not even read") << Answer([](RawConnection& c) {
        while (c.isStillThereAfter(10ms))
            continue;
        c.waitUntilGone();
    });
    QTest::newRow("a slow trickle") << Answer([](RawConnection& c) {
        c.readRequest();
        c.send(
            "HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nContent-Length: 100000\r\n\r\n");
        while (c.isStillThereAfter(5ms) && c.send("["))
            continue;
    });
    QTest::newRow("a slow head") << Answer([](RawConnection& c) {
        c.readRequest();
        c.send("HTTP/1.1 200 OK\r\n");
        while (c.isStillThereAfter(5ms) && c.send("X-A: b\r\n"))
            continue;
    });
    QTest::newRow("less than announced") << Answer([](RawConnection& c) {
        c.readRequest();
        c.send("HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nContent-Length: 50\r\n\r\n[]");
        c.waitUntilGone();
    });
    QTest::newRow("endless interim answers") << Answer([](RawConnection& c) {
        c.readRequest();
        while (c.isStillThereAfter(1ms) && c.send("HTTP/1.1 100 Continue\r\n\r\n"))
            continue;
    });
    QTest::newRow("cut again and again") << Answer([](RawConnection& c) {
        c.readRequest();
        c.isStillThereAfter(150ms);
    });
}

void WebAnswersTest::endsAtTheDeadline()
{
    QFETCH(Answer, answer);
    const RawResponder responder(answer);
    const auto result = webLinkTo(responder.url())->readRegisters(twoStates, within(250ms));
    VERIFY_ERROR(result, ErrorCode::Timeout);
    QCOMPARE(result.error().context.english("seconds"), std::string("0.25"));
}

void WebAnswersTest::limitsWhatItTakes_data()
{
    QTest::addColumn<Answer>("answer");
    QTest::newRow("endless chunks") << Answer([](RawConnection& c) {
        c.readRequest();
        c.send("HTTP/1.1 200 OK\r\nContent-Type: application/json\r\n"
               "Transfer-Encoding: chunked\r\n\r\n");
        while (c.send("1000\r\n" + std::string(0x1000, ' ') + "\r\n"))
            continue;
    });
    QTest::newRow("endless until it closes") << Answer([](RawConnection& c) {
        c.readRequest();
        c.send("HTTP/1.1 200 OK\r\nContent-Type: application/json\r\n\r\n");
        while (c.send(std::string(0x10000, ' ')))
            continue;
    });
    QTest::newRow("a length of terabytes") << Answer([](RawConnection& c) {
        c.readRequest();
        c.send("HTTP/1.1 200 OK\r\nContent-Type: application/json\r\n"
               "Content-Length: 9000000000000\r\n\r\n");
        while (c.send(std::string(0x10000, ' ')))
            continue;
    });
}

void WebAnswersTest::limitsWhatItTakes()
{
    QFETCH(Answer, answer);
    const RawResponder responder(answer);
    const auto link = webLinkTo(responder.url());
    const auto registers = link->readRegisters(twoStates, within(60s));
    VERIFY_ERROR(registers, ErrorCode::Protocol);
    const auto file = link->download("tables/small1.TAMtbl", within(60s));
    VERIFY_ERROR(file, ErrorCode::Protocol);
    QCOMPARE(file.error().context.english("expected"), std::string("at most 63360 bytes"));
}

void WebAnswersTest::readsAgainAfterALostConnection()
{
    int connections = 0;
    const std::string good = httpReply("200 OK", "application/json", states(stateOfX, stateOfY));
    const RawResponder responder([&](RawConnection& c) {
        c.readRequest();
        c.send(++connections < 3 ? good.substr(0, good.size() - 9) : good);
    });
    VERIFY_RESULT(webLinkTo(responder.url())->readRegisters(twoStates, {}));
    QCOMPARE(responder.requests(), 3);
}

void WebAnswersTest::givesUpReadingAfterTwoRepeats()
{
    const std::string good = httpReply("200 OK", "application/json", states(stateOfX, stateOfY));
    const RawResponder responder(once(good.substr(0, good.size() - 9)));
    const auto result = webLinkTo(responder.url())->readRegisters(twoStates, {});
    VERIFY_ERROR(result, ErrorCode::ConnectionLost);
    QCOMPARE(responder.requests(), 3);
}

void WebAnswersTest::neverRepeatsAWrite_data()
{
    QTest::addColumn<Answer>("answer");
    QTest::newRow("closed before the answer") << once("");
    QTest::newRow("reset before the answer") << Answer([](RawConnection& c) {
        c.readRequest();
        c.reset();
    });
    QTest::newRow("closed within the answer") << once("HTTP/1.1 204 No Con");
    QTest::newRow("closed within the body")
        << once("HTTP/1.1 409 Conflict\r\nContent-Length: 100\r\n\r\n{");
    QTest::newRow("closed at the second request") << Answer([](RawConnection& c) {
        c.readRequest();
        c.send("HTTP/1.1 204 No Content\r\n\r\n");
        c.readRequest();
    });
}

void WebAnswersTest::neverRepeatsAWrite()
{
    QFETCH(Answer, answer);
    const RawResponder responder(answer);
    const auto link = webLinkTo(responder.url());
    const bool secondFails = qstrcmp(QTest::currentDataTag(), "closed at the second request") == 0;
    if (secondFails)
        VERIFY_RESULT(link->writeRegisters(oneWrite, {}));
    const int before = responder.requests();
    VERIFY_ERROR(link->writeRegisters(oneWrite, {}), ErrorCode::ConnectionLost);
    QCOMPARE(responder.requests(), before + 1);
    if (secondFails)
        return;
    const Bytes file(100'000);
    VERIFY_ERROR(link->upload("tables/large1.TAMtbl", file, {}), ErrorCode::ConnectionLost);
    QCOMPARE(responder.requests(), before + 2);
}

void WebAnswersTest::mapsAStatusWithoutJson_data()
{
    QTest::addColumn<QString>("status");
    QTest::addColumn<QString>("headers");
    QTest::addColumn<ErrorCode>("code");
    QTest::newRow("400") << "400 Bad Request"
                         << "" << ErrorCode::DriveRejected;
    QTest::newRow("401") << "401 Unauthorized"
                         << "WWW-Authenticate: Basic realm=\"x\"\r\n"
                         << ErrorCode::Unauthorized;
    QTest::newRow("403") << "403 Forbidden"
                         << "" << ErrorCode::DriveRejected;
    QTest::newRow("404") << "404 Not Found"
                         << "" << ErrorCode::UnknownFile;
    QTest::newRow("409") << "409 Conflict"
                         << "" << ErrorCode::NotAllowedNow;
    QTest::newRow("413") << "413 Too Large"
                         << "" << ErrorCode::TooLargeForSlot;
    QTest::newRow("415") << "415 Unsupported"
                         << "" << ErrorCode::DriveRejected;
    QTest::newRow("422") << "422 Unprocessable"
                         << "" << ErrorCode::TableRefused;
    QTest::newRow("503") << "503 Unavailable"
                         << "Retry-After: 90\r\n"
                         << ErrorCode::FlashWear;
    QTest::newRow("503 with a date") << "503 Unavailable"
                                     << "Retry-After: Fri, 31 Dec 1999\r\n"
                                     << ErrorCode::Protocol;
    QTest::newRow("502") << "502 Bad Gateway"
                         << "" << ErrorCode::Protocol;
    QTest::newRow("999") << "999 What"
                         << "" << ErrorCode::Protocol;
}

void WebAnswersTest::mapsAStatusWithoutJson()
{
    QFETCH(QString, status);
    QFETCH(QString, headers);
    QFETCH(ErrorCode, code);
    const std::string page = "<html><body><h1>The drive says no</h1></body></html>";
    const RawResponder responder(always("HTTP/1.1 " + status.toStdString() + "\r\n"
        + headers.toStdString() + "Content-Type: text/html\r\nContent-Length: "
        + std::to_string(page.size()) + "\r\n\r\n" + page));
    const Bytes file(300);
    const auto result = webLinkTo(responder.url())->upload("tables/small1.TAMtbl", file, {});
    VERIFY_ERROR(result, code);
    const QString text = QString::fromStdString(sentence(result.error()));
    const bool saysAll = text.contains(QStringLiteral("The drive says no"))
        || text.contains(QStringLiteral("90 s")) || code == ErrorCode::UnknownFile
        || code == ErrorCode::Unauthorized;
    QVERIFY2(saysAll, qPrintable(text));
}

void WebAnswersTest::readsTheDirectoryOfADriveThatOnlyHasThePage()
{
    const RawResponder responder(always(httpReply("200 OK", "text/html; charset=utf-8",
        "<html><body><table><tr><th>maximum size</th><th>File</th><th>Actual size</th></tr>"
        "<tr><td>63&nbsp;360</td><td><a href='/x'>tables/small1.TAMtbl</a></td><td>304</td></tr>"
        "</table></body></html>")));
    const auto files = webLinkTo(responder.url())->listFiles({});
    VERIFY_RESULT(files);
    QCOMPARE(files->size(), std::size_t{1});
    QCOMPARE(files->front(), (DriveFile{"tables/small1.TAMtbl", 304, 63360}));
}

void WebAnswersTest::takesADirectoryPageToItsEnd_data()
{
    QTest::addColumn<QString>("end");
    QTest::addColumn<bool>("isComplete");
    QTest::newRow("complete") << "</table></body></HTML>" << true;
    QTest::newRow("cut between two rows") << "" << false;
    QTest::newRow("cut after a table") << "</table>" << false;
}

/// Nothing but the connection tells where these pages end.
void WebAnswersTest::takesADirectoryPageToItsEnd()
{
    QFETCH(QString, end);
    QFETCH(bool, isComplete);
    const RawResponder responder(once("HTTP/1.1 200 OK\r\nContent-Type: text/html\r\n\r\n"
                                      "<html><body><table><tr><th>File</th><th>Actual size</th>"
                                      "<th>Maximum size</th></tr><tr><td>tables/small1.TAMtbl</td>"
                                      "<td>304</td><td>63360</td></tr>"
        + end.toStdString()));
    const auto files = webLinkTo(responder.url())->listFiles({});
    QCOMPARE(files.has_value(), isComplete);
    if (!isComplete)
        VERIFY_ERROR(files, ErrorCode::Protocol);
}

void WebAnswersTest::rejectsAnotherDirectoryPage_data()
{
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("body");
    QTest::newRow("other columns") << "text/html"
                                   << "<table><tr><th>Name</th><th>Size</th></tr></table>";
    QTest::newRow("no table") << "text/html"
                              << "<h1>It works!</h1>";
    QTest::newRow("JSON of another kind") << "application/json"
                                          << "{\"files\":[]}";
    QTest::newRow("sizes as texts") << "application/json"
                                    << R"([{"path":"a","size":"1","maximumSize":"2"}])";
    QTest::newRow("plain text") << "text/plain"
                                << "small1.TAMtbl 304";
}

void WebAnswersTest::rejectsAnotherDirectoryPage()
{
    QFETCH(QString, type);
    QFETCH(QString, body);
    const RawResponder responder(
        always(httpReply("200 OK", type.toStdString(), body.toStdString())));
    const auto files = webLinkTo(responder.url())->listFiles({});
    VERIFY_ERROR(files, ErrorCode::Protocol);
    QCOMPARE(files.error().context.english("endpoint"), responder.url());
    QVERIFY(files.error().context.english("quote").size() > 2);
}

void WebAnswersTest::rejectsATransferThatIsNoFile_data()
{
    QTest::addColumn<QString>("reply");
    QTest::newRow("a login page") << QString::fromStdString(
        httpReply("200 OK", "text/html", "<form>Password</form>"));
    QTest::newRow("JSON") << QString::fromStdString(httpReply("200 OK", "application/json", "{}"));
    QTest::newRow("an end that only the connection tells")
        << "HTTP/1.1 200 OK\r\nContent-Type: application/octet-stream\r\n\r\nTAMT";
    QTest::newRow("compressed") << "HTTP/1.1 200 OK\r\nContent-Type: application/octet-stream\r\n"
                                   "Content-Encoding: gzip\r\nContent-Length: 4\r\n\r\nTAMT";
    QTest::newRow("more than announced")
        << "HTTP/1.1 200 OK\r\nContent-Type: application/octet-stream\r\n"
           "Content-Length: 2\r\n\r\nTAMT";
}

void WebAnswersTest::rejectsATransferThatIsNoFile()
{
    QFETCH(QString, reply);
    const RawResponder responder(once(reply.toStdString()));
    const auto result = webLinkTo(responder.url())->download("tables/small1.TAMtbl", {});
    VERIFY_ERROR(result, ErrorCode::Protocol);
}

AXISCOMP_TEST(WebAnswersTest)

} // namespace tst_replycheck

#include "tst_replycheck.moc"
