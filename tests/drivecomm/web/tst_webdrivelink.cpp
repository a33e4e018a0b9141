// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link_factory.h"
#include "drivecomm/virtualdrive/web/web_server.h"
#include "tests/drivecomm/web/web_link_fixture.h"
#include "tests/support/test_registry.h"

#include <QHostAddress>
#include <QTcpSocket>
#include <QTest>

#include <mutex>
#include <semaphore>
#include <thread>

namespace tst_webdrivelink {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;
using namespace std::chrono_literals;

namespace {

/// A drive for tests that need no special answers.
struct ServedDrive {
    explicit ServedDrive(const WebServerOptions& options = {}, std::vector<FaultSpec> specs = {})
        : faults(std::move(specs))
        , server(WebServer::start(drive, genericProfile(), faults, options).value())
        , link(webLinkTo(server->url()))
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
    std::unique_ptr<WebServer> server;
    std::unique_ptr<DriveLink> link;
};

} // namespace

class WebDriveLinkTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void reportsWhyThereIsNoConnection_data();
    void reportsWhyThereIsNoConnection();
    void keepsThePasswordOutOfErrors();
    void saysOfAWrongPasswordThatItIsWrong();
    void sendsThePasswordWithEveryRequest();
    void asksForWhatTheDriveSaysItself();
    void countsAxesWithFewRequests();
    void countsAxesOfADriveThatDoesNotNameWhatIsMissing();
    void stopsWhileItWaits();
    void stopsWhileItUploads();
    void worksOnAnyThread();
    void servesSeveralLinksAtOnce();
    void makesLinksFromEndpoints();
    void writesNothingToAnotherDrive();
    void asksOnceForEachConnectionWhoAnswers();
    void theResponderEndsWithAConnectionOpen();
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
    const auto result = webLinkTo(url.toStdString())->identify({});
    VERIFY_ERROR(result, ErrorCode::NotConnected);
    QCOMPARE(result.error().context.english("endpoint"), url.toStdString());
    QVERIFY(QString::fromStdString(sentence(result.error())).contains(reason));
}

void WebDriveLinkTest::keepsThePasswordOutOfErrors()
{
    WebServerOptions options;
    options.user = "anna";
    options.password = "right";
    const ServedDrive served(options);
    const std::string wrong =
        "http://anna:s3cret@127.0.0.1:" + std::to_string(served.server->port());
    const auto result = webLinkTo(wrong)->identify({});
    VERIFY_ERROR(result, ErrorCode::Unauthorized);
    for (const auto& [key, value] : result.error().context.all())
        QVERIFY(value.english().find("s3cret") == std::string::npos);
    QVERIFY(describe(result.error()).find("s3cret") == std::string::npos);
    VERIFY_ERROR(served.link->identify({}), ErrorCode::Unauthorized);
}

void WebDriveLinkTest::saysOfAWrongPasswordThatItIsWrong()
{
    WebServerOptions options;
    options.user = "anna";
    options.password = "right";
    const ServedDrive served(options);
    const std::string address = "127.0.0.1:" + std::to_string(served.server->port());
    for (const char* const given : {"anna:wrong@", "anna@"}) {
        const auto refused = webLinkTo("http://" + (given + address))->identify({});
        VERIFY_ERROR(refused, ErrorCode::Unauthorized);
        const std::string said = sentence(refused.error());
        QVERIFY2(said.starts_with("http://" + address + " refuses the user name or the password "),
            said.c_str());
    }
    const auto missing = served.link->identify({});
    VERIFY_ERROR(missing, ErrorCode::Unauthorized);
    QVERIFY(sentence(missing.error()).ends_with("give them as http://user:password@host"));
}

void WebDriveLinkTest::sendsThePasswordWithEveryRequest()
{
    WebServerOptions options;
    options.user = "anna";
    options.password = "pa:ss wörd";
    ServedDrive served(options);
    const auto link = webLinkTo(
        "http://anna:pa%3Ass%20w%C3%B6rd@127.0.0.1:" + std::to_string(served.server->port()));
    VERIFY_RESULT(link->identify({}));
    VERIFY_RESULT(link->writeRegisters(oneWrite, {}));
    VERIFY_RESULT(link->listFiles({}));
    VERIFY_RESULT(link->download("tables/small1.TAMtbl", {}));
    QVERIFY(link->endpoint().find("anna") == std::string::npos);
}

void WebDriveLinkTest::asksForWhatTheDriveSaysItself()
{
    std::mutex mutex;
    std::string asked;
    const RawResponder responder([&](RawConnection& c) {
        const std::string request = c.readRequest();
        const std::scoped_lock lock(mutex);
        asked = request;
        c.send(httpReply("200 OK", "application/json", states(stateOfX, stateOfY)));
    });
    VERIFY_RESULT(webLinkTo(responder.url())->readRegisters(twoStates, {}));
    const std::scoped_lock lock(mutex);
    QVERIFY(asked.find("\r\nCache-Control: no-cache\r\n") != std::string::npos);
    QVERIFY(asked.find("\r\nPragma: no-cache\r\n") != std::string::npos);
    QVERIFY(asked.find("\r\nAccept-Encoding: identity\r\n") != std::string::npos);
}

void WebDriveLinkTest::countsAxesWithFewRequests()
{
    for (const auto& [axes, requests] :
        {std::pair(1, 2), std::pair(2, 2), std::pair(63, 2), std::pair(64, 3), std::pair(100, 3)}) {
        const RawResponder responder(driveWithAxes(axes, Missing::Named));
        const auto identity = webLinkTo(responder.url())->identify({});
        VERIFY_RESULT(identity);
        QCOMPARE(identity->axes, axes);
        QCOMPARE(responder.requests(), requests);
    }
}

void WebDriveLinkTest::countsAxesOfADriveThatDoesNotNameWhatIsMissing()
{
    for (const int axes : {0, 1, 2, 31, 63, 64, 65, 100}) {
        const RawResponder responder(driveWithAxes(axes, Missing::Unnamed));
        const auto identity = webLinkTo(responder.url())->identify({});
        VERIFY_RESULT(identity);
        QCOMPARE(identity->axes, axes);
        QVERIFY(responder.requests() <= 10);
    }
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
    VERIFY_ERROR(
        webLinkTo(responder.url())->readRegisters(twoStates, exchange), ErrorCode::Cancelled);
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
    VERIFY_ERROR(webLinkTo(responder.url())->upload("tables/large1.TAMtbl", file, exchange),
        ErrorCode::Cancelled);
}

void WebDriveLinkTest::worksOnAnyThread()
{
    const ServedDrive served;
    Result<DriveIdentity> identity = fail(ErrorCode::Cancelled);
    std::thread plain([&] { // no QThread, no event loop
        const auto link = webLinkTo(served.server->url());
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
            const auto link = webLinkTo(served.server->url());
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
    const auto web = makeLink(parseEndpoint(served.server->url()).value(), genericProfile());
    VERIFY_RESULT(web);
    QCOMPARE((*web)->endpoint(), served.server->url());
    VERIFY_RESULT((*web)->identify({}));
    const auto demo = makeLink(parseEndpoint("demo:").value(), genericProfile());
    VERIFY_RESULT(demo);
    QCOMPARE((*demo)->endpoint(), std::string("demo:"));
    const auto identity = (*demo)->identify({});
    VERIFY_RESULT(identity);
    QCOMPARE(identity->axes, 2);
    VERIFY_RESULT((*demo)->listFiles({}));
}

void WebDriveLinkTest::writesNothingToAnotherDrive()
{
    ServedDrive served;
    VERIFY_RESULT(served.link->identify({}));
    WebServerOptions options;
    options.port = served.server->port();
    served.server.reset();
    VirtualDriveOptions exchanged = ServedDrive::options();
    exchanged.serialNumber = 617;
    VirtualDrive other(genericProfile(), exchanged);
    FaultPlan faults;
    const auto server = WebServer::start(other, genericProfile(), faults, options).value();
    const Bytes file(100);
    for (int i = 0; i < 2; ++i) { // being refused is no introduction
        const auto refused = served.link->writeRegisters(oneWrite, {});
        VERIFY_ERROR(refused, ErrorCode::OtherDrive);
        QCOMPARE(refused.error().context.english("expected"), std::string("616"));
        QCOMPARE(refused.error().context.english("found"), std::string("617"));
        VERIFY_ERROR(served.link->readRegisters(twoStates, {}), ErrorCode::OtherDrive);
        VERIFY_ERROR(served.link->upload("tables/small1.TAMtbl", file, {}), ErrorCode::OtherDrive);
    }
    const std::vector<std::string> path{oneWrite.front().path};
    QCOMPARE(other.readRegisters(path)->front().value, RegisterValue(0.0F));
    VERIFY_RESULT(served.link->identify({})); // whoever asks who it is knows
    VERIFY_RESULT(served.link->writeRegisters(oneWrite, {}));
    QCOMPARE(other.readRegisters(path)->front().value, RegisterValue(1.0F));
}

void WebDriveLinkTest::asksOnceForEachConnectionWhoAnswers()
{
    const RawResponder responder(driveWithAxes(2, Missing::Named));
    const auto link = webLinkTo(responder.url());
    VERIFY_RESULT(link->identify({}));
    QCOMPARE(responder.requests(), 2);
    for (int i = 0; i < 3; ++i)
        VERIFY_RESULT(link->readRegisters(twoStates, {}));
    QCOMPARE(responder.requests(), 5);
    std::this_thread::sleep_for(1100ms); // a write does not trust a connection that was idle
    (void)link->writeRegisters(oneWrite, {}); // asks on a new one, then goes out
    QCOMPARE(responder.requests(), 7);
    (void)link->writeRegisters(oneWrite, {});
    QCOMPARE(responder.requests(), 8);
}

/// What these tests stand on: a responder that waited on would keep its test from ending.
void WebDriveLinkTest::theResponderEndsWithAConnectionOpen()
{
    std::binary_semaphore isServing{0};
    QTcpSocket client;
    {
        const RawResponder responder([&isServing](RawConnection& c) {
            isServing.release();
            while (c.isStillThereAfter(1ms))
                continue;
        });
        client.connectToHost(QHostAddress::LocalHost, responder.port());
        QVERIFY(client.waitForConnected(patienceMs));
        isServing.acquire();
    }
    QVERIFY(client.waitForDisconnected(patienceMs));
}

AXISCOMP_TEST(WebDriveLinkTest)

} // namespace tst_webdrivelink

#include "tst_webdrivelink.moc"
