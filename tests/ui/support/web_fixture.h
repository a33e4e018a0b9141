// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/link_factory.h"
#include "drivecomm/virtualdrive/web/web_server.h"
#include "tests/support/patience.h"
#include "tests/ui/support/controller_fixture.h"

namespace axiscomp::test {

/// A controller that talks to the bench's drive by its web pages, on loopback.
class WebFixture : public ControllerFixture {
public:
    WebFixture()
    {
        options.timeout = std::chrono::seconds(5);
        options.linkFactory = [this](const std::string& endpoint) { return webLink(endpoint); };
        switchOn();
        m_url = QString::fromStdString(m_server->url());
    }
    ~WebFixture() { endController(); }

    [[nodiscard]] const QString& url() const { return m_url; }
    [[nodiscard]] bool connectByWeb()
    {
        controller().setEndpoints({m_url});
        return QTest::qWaitFor([this] { return controller().status().has_value(); }, patienceMs);
    }
    [[nodiscard]] bool isConnected()
    {
        return controller().drives().front().connection == ui::DriveState::Connection::Connected;
    }
    [[nodiscard]] bool connectedAgain()
    {
        return QTest::qWaitFor([this] { return isConnected(); }, patienceMs);
    }

    /// Pulls the plug of the network: connections break, nobody listens.
    void switchOff() { m_server.reset(); }
    /// At the same port as before.
    void switchOn()
    {
        drivecomm::WebServerOptions web;
        web.port = m_port;
        auto server = drivecomm::WebServer::start(
            drive().drive, drivecomm::genericProfile(), m_noFaults, web);
        if (!server)
            qFatal("%s", sentence(server.error()).c_str());
        m_server = std::move(*server);
        m_port = m_server->port();
    }
    /// Another program's link to the same drive.
    [[nodiscard]] std::unique_ptr<DriveLink> secondClient() const
    {
        return drivecomm::linkFactory(drivecomm::genericProfile())(m_url.toStdString()).value();
    }

private:
    Result<std::unique_ptr<DriveLink>> webLink(const std::string& text)
    {
        auto link = drivecomm::linkFactory(drivecomm::genericProfile())(text);
        if (!link)
            return fail(link.error());
        return std::make_unique<GateLink>(std::move(*link), drive().gate);
    }

    drivecomm::FaultPlan m_noFaults;
    std::uint16_t m_port = 0;
    std::unique_ptr<drivecomm::WebServer> m_server;
    QString m_url;
};

} // namespace axiscomp::test
