// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link_factory.h"
#include "drivecomm/profile_loader.h"
#include "drivecomm/register_json.h"
#include "drivecomm/virtualdrive/web_front.h"
#include "drivecomm/web_drive_link.h"
#include "tests/support/raw_responder.h"
#include "tests/support/verify.h"

#include <QTest>

#include <thread>

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;
using namespace std::chrono_literals;

namespace {

using Answer = std::function<void(RawConnection&)>;

const std::string stateOfX = "Axes[0]/Signals/Compensations/Axis/State";
const std::string stateOfY = "Axes[1]/Signals/Compensations/Axis/State";
const std::vector<std::string> twoStates{stateOfX, stateOfY};
const std::vector<RegisterWrite> oneWrite{{"Application/Variables/Floats[0]", 1.0F}};

std::unique_ptr<DriveLink> linkTo(const std::string& url)
{
    return makeWebDriveLink(parseEndpoint(url).value(), genericProfile());
}

Exchange within(std::chrono::milliseconds timeout)
{
    Exchange exchange;
    exchange.timeout = timeout;
    return exchange;
}

std::string states(const std::string& first, const std::string& second)
{
    return readingsJson(std::vector<RegisterReading>{
        {first, 1, "State", std::string("Disabled")}, {second, 2, "State", std::string("Active")}});
}

/// Answers each request of each connection alike.
Answer always(std::string reply)
{
    return [reply = std::move(reply)](RawConnection& connection) {
        while (!connection.readRequest().empty() && connection.send(reply))
            continue;
    };
}

/// Answers one request and closes.
Answer once(std::string reply)
{
    return [reply = std::move(reply)](RawConnection& connection) {
        connection.readRequest();
        connection.send(reply);
    };
}

Answer json(const std::string& body)
{
    return always(httpReply("200 OK", "application/json", body));
}

/// A drive for tests that need no special answers.
struct ServedDrive {
    explicit ServedDrive(const WebFrontOptions& options = {}, std::vector<FaultSpec> specs = {})
        : faults(std::move(specs))
        , front(WebFront::start(drive, genericProfile(), faults, options).value())
        , link(linkTo(front->url()))
    {
    }

    static VirtualDriveOptions options()
    {
        VirtualDriveOptions options;
        options.name = "Web-1";
        options.serialNumber = 616;
        options.axes = {{.name = "X"}, {.name = "Y"}};
        return options;
    }

    VirtualDrive drive{genericProfile(), options()};
    FaultPlan faults;
    std::unique_ptr<WebFront> front;
    std::unique_ptr<DriveLink> link;
};

} // namespace

Q_DECLARE_METATYPE(Answer)

class WebDriveLinkTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void reportsWhyThereIsNoConnection_data();
    void reportsWhyThereIsNoConnection();
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
    void keepsThePasswordOutOfErrors();
    void sendsThePasswordWithEveryRequest();
    void readsTheDirectoryOfADriveThatOnlyHasThePage();
    void rejectsAnotherDirectoryPage_data();
    void rejectsAnotherDirectoryPage();
    void countsAxesWithFewRequests();
    void countsAxesOfADriveThatDoesNotNameWhatIsMissing();
    void rejectsATransferThatIsNoFile_data();
    void rejectsATransferThatIsNoFile();
    void stopsWhileItWaits();
    void stopsWhileItUploads();
    void worksOnAnyThread();
    void servesSeveralLinksAtOnce();
    void makesLinksFromEndpoints();
    void saysThatSerialIsNotThereYet();
};

void WebDriveLinkTest::reportsWhyThereIsNoConnection_data()
{
    QTest::addColumn<QString>("url");
    QTest::addColumn<QString>("reason");
    QTest::newRow("nothing listens") << "http://127.0.0.1:1"
                                     << "is the drive switched on";
    QTest::newRow("unknown name") << "http://no-such-host.invalid"
                                  << "no-such-host.invalid";
}

void WebDriveLinkTest::reportsWhyThereIsNoConnection()
{
    QFETCH(QString, url);
    QFETCH(QString, reason);
    const auto result = linkTo(url.toStdString())->identify({});
    VERIFY_ERROR(result, ErrorCode::NotConnected);
    QCOMPARE(result.error().context.at("endpoint"), url.toStdString());
    QVERIFY(QString::fromStdString(sentence(result.error())).contains(reason));
}

void WebDriveLinkTest::rejectsNonsenseForRegisters_data()
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

void WebDriveLinkTest::rejectsNonsenseForRegisters()
{
    QFETCH(Answer, answer);
    QFETCH(QString, quote);
    const RawResponder responder(answer);
    const auto result = linkTo(responder.url())->readRegisters(twoStates, {});
    VERIFY_ERROR(result, ErrorCode::Protocol);
    QCOMPARE(result.error().context.at("endpoint"), responder.url());
    QVERIFY(!result.error().context.at("expected").empty());
    const QString shown = QString::fromStdString(result.error().context.at("quote"));
    QVERIFY2(shown.contains(quote), qPrintable(shown));
    QVERIFY(!shown.isEmpty() && shown.size() < 200);
}

void WebDriveLinkTest::acceptsTheAnswerThatItRejectsVariantsOf()
{
    const RawResponder responder(json(states(stateOfX, stateOfY)));
    const auto result = linkTo(responder.url())->readRegisters(twoStates, {});
    VERIFY_RESULT(result);
    QCOMPARE(result->at(1).value, RegisterValue("Active"));
}

void WebDriveLinkTest::endsAtTheDeadline_data()
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

void WebDriveLinkTest::endsAtTheDeadline()
{
    QFETCH(Answer, answer);
    const RawResponder responder(answer);
    const auto result = linkTo(responder.url())->readRegisters(twoStates, within(250ms));
    VERIFY_ERROR(result, ErrorCode::Timeout);
    QCOMPARE(result.error().context.at("seconds"), std::string("0.25"));
}

void WebDriveLinkTest::limitsWhatItTakes_data()
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

void WebDriveLinkTest::limitsWhatItTakes()
{
    QFETCH(Answer, answer);
    const RawResponder responder(answer);
    const auto link = linkTo(responder.url());
    const auto registers = link->readRegisters(twoStates, within(60s));
    VERIFY_ERROR(registers, ErrorCode::Protocol);
    const auto file = link->download("tables/small1.TAMtbl", within(60s));
    VERIFY_ERROR(file, ErrorCode::Protocol);
    QCOMPARE(file.error().context.at("expected"), std::string("at most 63360 bytes"));
}

void WebDriveLinkTest::readsAgainAfterALostConnection()
{
    int connections = 0;
    const std::string good = httpReply("200 OK", "application/json", states(stateOfX, stateOfY));
    const RawResponder responder([&](RawConnection& c) {
        c.readRequest();
        c.send(++connections < 3 ? good.substr(0, good.size() - 9) : good);
    });
    VERIFY_RESULT(linkTo(responder.url())->readRegisters(twoStates, {}));
    QCOMPARE(responder.requests(), 3);
}

void WebDriveLinkTest::givesUpReadingAfterTwoRepeats()
{
    const std::string good = httpReply("200 OK", "application/json", states(stateOfX, stateOfY));
    const RawResponder responder(once(good.substr(0, good.size() - 9)));
    const auto result = linkTo(responder.url())->readRegisters(twoStates, {});
    VERIFY_ERROR(result, ErrorCode::ConnectionLost);
    QCOMPARE(responder.requests(), 3);
}

void WebDriveLinkTest::neverRepeatsAWrite_data()
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

void WebDriveLinkTest::neverRepeatsAWrite()
{
    QFETCH(Answer, answer);
    const RawResponder responder(answer);
    const auto link = linkTo(responder.url());
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

void WebDriveLinkTest::mapsAStatusWithoutJson_data()
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

void WebDriveLinkTest::mapsAStatusWithoutJson()
{
    QFETCH(QString, status);
    QFETCH(QString, headers);
    QFETCH(ErrorCode, code);
    const std::string page = "<html><body><h1>The drive says no</h1></body></html>";
    const RawResponder responder(always("HTTP/1.1 " + status.toStdString() + "\r\n"
        + headers.toStdString() + "Content-Type: text/html\r\nContent-Length: "
        + std::to_string(page.size()) + "\r\n\r\n" + page));
    const Bytes file(300);
    const auto result = linkTo(responder.url())->upload("tables/small1.TAMtbl", file, {});
    VERIFY_ERROR(result, code);
    const QString text = QString::fromStdString(sentence(result.error()));
    const bool saysAll = text.contains(QStringLiteral("The drive says no"))
        || text.contains(QStringLiteral("90 s")) || code == ErrorCode::UnknownFile
        || code == ErrorCode::Unauthorized;
    QVERIFY2(saysAll, qPrintable(text));
}

void WebDriveLinkTest::keepsThePasswordOutOfErrors()
{
    WebFrontOptions options;
    options.user = "anna";
    options.password = "right";
    const ServedDrive served(options);
    const std::string wrong =
        "http://anna:s3cret@127.0.0.1:" + std::to_string(served.front->port());
    const auto result = linkTo(wrong)->identify({});
    VERIFY_ERROR(result, ErrorCode::Unauthorized);
    for (const auto& [key, value] : result.error().context)
        QVERIFY(value.find("s3cret") == std::string::npos);
    QVERIFY(describe(result.error()).find("s3cret") == std::string::npos);
    VERIFY_ERROR(served.link->identify({}), ErrorCode::Unauthorized);
}

void WebDriveLinkTest::sendsThePasswordWithEveryRequest()
{
    WebFrontOptions options;
    options.user = "anna";
    options.password = "pa:ss wörd";
    ServedDrive served(options);
    const auto link =
        linkTo("http://anna:pa%3Ass%20w%C3%B6rd@127.0.0.1:" + std::to_string(served.front->port()));
    VERIFY_RESULT(link->identify({}));
    VERIFY_RESULT(link->writeRegisters(oneWrite, {}));
    VERIFY_RESULT(link->listFiles({}));
    VERIFY_RESULT(link->download("tables/small1.TAMtbl", {}));
    QVERIFY(link->endpoint().find("anna") == std::string::npos);
}

void WebDriveLinkTest::readsTheDirectoryOfADriveThatOnlyHasThePage()
{
    const RawResponder responder(always(httpReply("200 OK", "text/html; charset=utf-8",
        "<html><body><table><tr><th>maximum size</th><th>File</th><th>Actual size</th></tr>"
        "<tr><td>63&nbsp;360</td><td><a href='/x'>tables/small1.TAMtbl</a></td><td>304</td></tr>"
        "</table></body></html>")));
    const auto files = linkTo(responder.url())->listFiles({});
    VERIFY_RESULT(files);
    QCOMPARE(files->size(), std::size_t{1});
    QCOMPARE(files->front(), (DriveFile{"tables/small1.TAMtbl", 304, 63360}));
}

void WebDriveLinkTest::rejectsAnotherDirectoryPage_data()
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

void WebDriveLinkTest::rejectsAnotherDirectoryPage()
{
    QFETCH(QString, type);
    QFETCH(QString, body);
    const RawResponder responder(
        always(httpReply("200 OK", type.toStdString(), body.toStdString())));
    const auto files = linkTo(responder.url())->listFiles({});
    VERIFY_ERROR(files, ErrorCode::Protocol);
    QCOMPARE(files.error().context.at("endpoint"), responder.url());
    QVERIFY(files.error().context.at("quote").size() > 2);
}

namespace {

/// Answers register requests for a drive with so many axes; an unknown one with a bare page.
Answer driveWithAxes(int axes)
{
    return [axes](RawConnection& c) {
        while (true) {
            const std::string request = c.readRequest();
            if (request.empty())
                return;
            std::vector<RegisterReading> readings;
            bool isKnown = true;
            const std::string target = request.substr(0, request.find(" HTTP"));
            for (std::size_t at = target.find("path="); at != std::string::npos;
                 at = target.find("path=", at + 1)) {
                const std::string encoded = target.substr(at + 5, target.find('&', at) - at - 5);
                const std::string path =
                    QByteArray::fromPercentEncoding(QByteArray::fromStdString(encoded))
                        .toStdString();
                readings.push_back({path, 1, "Int32", std::int32_t{0}});
                if (path.starts_with("Axes["))
                    isKnown = isKnown && std::stoi(path.substr(5)) < axes;
            }
            c.send(isKnown ? httpReply("200 OK", "application/json", readingsJson(readings))
                           : httpReply("404 Not Found", "text/html", "<p>no such register</p>"));
        }
    };
}

} // namespace

void WebDriveLinkTest::countsAxesWithFewRequests()
{
    const ServedDrive served;
    int requests = 0;
    const RawResponder relay([&](RawConnection& c) {
        while (true) {
            const std::string request = c.readRequest();
            if (request.empty())
                return;
            ++requests;
            const bool asksForAxes = request.find("AxisName") != std::string::npos;
            if (asksForAxes)
                c.send(httpReply("404 Not Found", "application/json",
                    R"({"error":{"code":"UnknownRegister","message":"no",)"
                    R"("path":"Axes[2]/Information/AxisName[0]"}})"));
            else
                c.send(httpReply("404 Not Found", "application/json",
                    R"({"error":{"code":"UnknownRegister","message":"no","path":"x"}})"));
        }
    });
    VERIFY_ERROR(linkTo(relay.url())->identify({}), ErrorCode::UnknownRegister);
    QCOMPARE(requests, 1);
}

void WebDriveLinkTest::countsAxesOfADriveThatDoesNotNameWhatIsMissing()
{
    for (const int axes : {0, 1, 2, 31, 64, 65, 100}) {
        const RawResponder responder(driveWithAxes(axes));
        const auto identity = linkTo(responder.url())->identify({});
        VERIFY_RESULT(identity);
        QCOMPARE(identity->axes, axes);
        QVERIFY(responder.requests() <= 10);
    }
}

void WebDriveLinkTest::rejectsATransferThatIsNoFile_data()
{
    QTest::addColumn<QString>("reply");
    QTest::newRow("a login page") << QString::fromStdString(
        httpReply("200 OK", "text/html", "<form>Password</form>"));
    QTest::newRow("JSON") << QString::fromStdString(httpReply("200 OK", "application/json", "{}"));
    QTest::newRow("an end that only the connection tells")
        << "HTTP/1.1 200 OK\r\nContent-Type: application/octet-stream\r\n\r\nTAMT";
}

void WebDriveLinkTest::rejectsATransferThatIsNoFile()
{
    QFETCH(QString, reply);
    const RawResponder responder(once(reply.toStdString()));
    const auto result = linkTo(responder.url())->download("tables/small1.TAMtbl", {});
    VERIFY_ERROR(result, ErrorCode::Protocol);
}

void WebDriveLinkTest::stopsWhileItWaits()
{
    std::stop_source source;
    const RawResponder responder([&source](RawConnection& c) {
        c.readRequest();
        source.request_stop(); // from another thread, with the request on its way
        c.waitUntilGone();
    });
    Exchange exchange = within(60s);
    exchange.stop = source.get_token();
    VERIFY_ERROR(linkTo(responder.url())->readRegisters(twoStates, exchange), ErrorCode::Cancelled);
}

void WebDriveLinkTest::stopsWhileItUploads()
{
    std::stop_source source;
    const RawResponder responder([](RawConnection& c) {
        while (c.isStillThereAfter(1ms))
            continue;
        c.waitUntilGone();
    });
    Exchange exchange = within(60s);
    exchange.stop = source.get_token();
    exchange.progress = [&source](auto, auto) { source.request_stop(); };
    const Bytes file(std::size_t{15} << 20);
    VERIFY_ERROR(linkTo(responder.url())->upload("tables/large1.TAMtbl", file, exchange),
        ErrorCode::Cancelled);
}

void WebDriveLinkTest::worksOnAnyThread()
{
    const ServedDrive served;
    Result<DriveIdentity> identity = fail(ErrorCode::Cancelled);
    std::thread plain([&] { // no QThread, no event loop
        const auto link = linkTo(served.front->url());
        identity = link->identify({});
    });
    plain.join();
    VERIFY_RESULT(identity);
    QCOMPARE(identity->axes, 2);
}

void WebDriveLinkTest::servesSeveralLinksAtOnce()
{
    const ServedDrive served({}, {parseFault("no-reply=1").value()});
    VERIFY_ERROR(served.link->listFiles(within(100ms)), ErrorCode::Timeout);
    std::atomic<int> good = 0;
    std::vector<std::jthread> clients;
    for (int n = 0; n < 12; ++n) {
        clients.emplace_back([&served, &good, n] {
            const auto link = linkTo(served.front->url());
            const std::string path = "Application/Variables/Floats[" + std::to_string(n) + "]";
            for (int i = 0; i < 20; ++i) {
                const std::vector<RegisterWrite> writes{{path, static_cast<float>(i)}};
                const std::vector<std::string> paths{path};
                if (!link->writeRegisters(writes, within(60s)))
                    return;
                const auto readings = link->readRegisters(paths, within(60s));
                if (!readings || readings->front().value != writes.front().value)
                    return;
            }
            ++good;
        });
    }
    clients.clear();
    QCOMPARE(good.load(), 12);
}

void WebDriveLinkTest::makesLinksFromEndpoints()
{
    const ServedDrive served;
    const auto web = makeLink(parseEndpoint(served.front->url()).value(), genericProfile());
    VERIFY_RESULT(web);
    QCOMPARE((*web)->endpoint(), served.front->url());
    VERIFY_RESULT((*web)->identify({}));
    const auto demo = makeLink(parseEndpoint("demo:").value(), genericProfile());
    VERIFY_RESULT(demo);
    QCOMPARE((*demo)->endpoint(), std::string("demo:"));
    const auto identity = (*demo)->identify({});
    VERIFY_RESULT(identity);
    QCOMPARE(identity->axes, 2);
    VERIFY_RESULT((*demo)->listFiles({}));
}

void WebDriveLinkTest::saysThatSerialIsNotThereYet()
{
    const auto link = makeLink(parseEndpoint("serial:/dev/ttyUSB0").value(), genericProfile());
    VERIFY_ERROR(link, ErrorCode::InvalidEndpoint);
    QCOMPARE(link.error().context.at("endpoint"), std::string("serial:/dev/ttyUSB0"));
}

QTEST_GUILESS_MAIN(WebDriveLinkTest)
#include "tst_webdrivelink.moc"
