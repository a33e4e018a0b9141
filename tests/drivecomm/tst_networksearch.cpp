// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/drive_candidates.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/web/web_server.h"
#include "tests/support/raw_responder.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <mutex>

namespace tst_networksearch {

using namespace axiscomp;
using namespace axiscomp::drivecomm;

namespace {

/// A drive at an address of loopback; the others of a network have the same port.
class DriveAt {
public:
    DriveAt(const std::string& host, std::uint16_t port, std::int32_t serialNumber)
        : m_drive(genericProfile(), options(serialNumber))
    {
        WebServerOptions served;
        served.host = host;
        served.port = port;
        auto started = WebServer::start(m_drive, genericProfile(), m_faults, served);
        if (!started)
            qFatal("%s", sentence(started.error()).c_str());
        m_server = std::move(*started);
    }
    [[nodiscard]] std::uint16_t port() const { return m_server->port(); }

private:
    static VirtualDriveOptions options(std::int32_t serialNumber)
    {
        VirtualDriveOptions options;
        options.name = "Found-" + std::to_string(serialNumber);
        options.serialNumber = serialNumber;
        return options;
    }

    VirtualDrive m_drive;
    FaultPlan m_faults;
    std::unique_ptr<WebServer> m_server;
};

std::vector<DriveSighting> search(const std::string& range, std::stop_token stop = {})
{
    const auto parsed = parseNetworkRange(range);
    if (!parsed)
        return {};
    DriveSearch search;
    search.linkFactory = linkFactory(genericProfile());
    search.stop = std::move(stop);
    search.mostAtOnce = addressesAtOnce;
    return findDrives(candidatesIn(*parsed, {}), search);
}

} // namespace

/// Drives are found by the addresses of a network; all of it on loopback.
class TestNetworkSearch : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void drivesOfARangeAreFoundAndTheRestIsUnreachable()
    {
        const DriveAt first("127.0.0.2", 0, 4001);
        const DriveAt second("127.0.0.5", first.port(), 4002);
        const auto sightings = search("127.0.0.1-127.0.0.5:" + std::to_string(first.port()));
        QCOMPARE(sightings.size(), std::size_t(5));
        for (std::size_t i = 0; i < sightings.size(); ++i) {
            if (i == 1 || i == 4) {
                VERIFY_RESULT(sightings[i].drive);
                QCOMPARE(sightings[i].drive->serialNumber, i == 1 ? 4001 : 4002);
                QVERIFY2(sightings[i].endpoint.find(i == 1 ? "127.0.0.2" : "127.0.0.5")
                        != std::string::npos,
                    sightings[i].endpoint.c_str());
            } else {
                QVERIFY(!sightings[i].drive && isUnreachable(sightings[i].drive.error().code));
            }
        }
    }

    void whatIsNoDriveGetsOneRequestForTheDirectory()
    {
        std::mutex mutex;
        std::vector<std::string> requests;
        test::RawResponder printer([&](test::RawConnection& connection) {
            for (;;) {
                const std::string request = connection.readRequest();
                if (request.empty())
                    return;
                {
                    const std::lock_guard lock(mutex);
                    requests.push_back(request);
                }
                if (!connection.send(test::httpReply("200 OK", "text/html", "<p>Printer</p>")))
                    return;
            }
        });
        const auto sightings = search("127.0.0.1:" + std::to_string(printer.port()));
        QCOMPARE(sightings.size(), std::size_t(1));
        QVERIFY(!sightings[0].drive);
        const std::lock_guard lock(mutex);
        QCOMPARE(requests.size(), std::size_t(1));
        QVERIFY2(requests[0].starts_with("GET /directory "), requests[0].c_str());
    }
};

AXISCOMP_TEST(TestNetworkSearch)

} // namespace tst_networksearch

#include "tst_networksearch.moc"
