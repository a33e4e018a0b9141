// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/tam_table.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/web/web_server.h"
#include "drivecomm/web/html_table.h"
#include "tests/drivecomm/known_paths.h"
#include "tests/support/verify.h"

#include <QTcpSocket>

#include <httplib.h>

#include <atomic>

namespace axiscomp::test {

using namespace drivecomm;

inline const std::string htmlOnly =
    "text/html,application/xhtml+xml,application/xml;q=0.9,*/*;q=0.8";
inline const std::string formType = "application/x-www-form-urlencoded";
inline constexpr int webPatienceMs = 10'000;

inline std::string tableFile(std::uint32_t points, float scale = 0.001F)
{
    CompensationTable table;
    table.grid.axes.push_back({{}, {}, 0.0, 1.0, points});
    for (std::uint32_t i = 0; i < points; ++i)
        table.values.push_back(scale * static_cast<float>(i));
    const Bytes bytes = encodeTamTable(table, false, genericProfile().layout).value_or(Bytes{});
    return std::string(asText(bytes));
}

inline httplib::MultipartFormDataItems transferForm(
    const std::string& path, const std::string& file)
{
    return {{"filepath", path, "", ""}, {"file", file, "mine.TAMtbl", "application/octet-stream"}};
}

inline std::string registersOf(const std::vector<std::string>& paths)
{
    std::string target = "/registers";
    for (const std::string& path : paths)
        target += (target.size() == 10 ? "?path=" : "&path=") + path;
    return target;
}

/// A drive on the web, and a client.
struct Site {
    explicit Site(const WebServerOptions& theOptions = {}, const std::string& name = "Front-1")
        : options(theOptions)
        , drive(genericProfile(), driveOptions(name))
        , server(WebServer::start(drive, genericProfile(), faults, options).value())
        , client("127.0.0.1", server->port())
    {
        client.set_keep_alive(true);
        client.set_tcp_nodelay(true);
        client.set_read_timeout(60);
    }

    static VirtualDriveOptions driveOptions(const std::string& name)
    {
        VirtualDriveOptions options;
        options.name = name;
        options.serialNumber = 1559;
        options.axes = {{.name = "X"}, {.name = "Y"}};
        return options;
    }

    RegisterValue value(const std::string& path)
    {
        const auto readings = drive.readRegisters({path});
        return readings ? readings->front().value : RegisterValue("no such register");
    }
    void fault(const std::string& text) { faults.add(parseFault(text).value()); }

    WebServerOptions options;
    std::atomic<int> requests = 0; ///< to the drive
    FaultPlan faults{{}, [this](bool) { ++requests; }};
    VirtualDrive drive;
    std::unique_ptr<WebServer> server;
    httplib::Client client;
};

/// What a browser shows of a page.
inline std::string textOf(const httplib::Result& result)
{
    return result ? htmlText(result->body) : httplib::to_string(result.error());
}

/// A client that sends what it likes.
struct RawClient {
    explicit RawClient(std::uint16_t port)
    {
        socket.connectToHost(QStringLiteral("127.0.0.1"), port);
        socket.waitForConnected(webPatienceMs);
    }
    void send(const std::string& bytes)
    {
        socket.write(bytes.data(), static_cast<qint64>(bytes.size()));
        while (socket.bytesToWrite() > 0 && socket.waitForBytesWritten(webPatienceMs))
            continue;
    }
    QByteArray received()
    {
        buffer += socket.readAll();
        return buffer;
    }
    QByteArray take() { return std::exchange(buffer, {}); }
    /// Everything until the connection ends.
    QByteArray receiveAll()
    {
        while (socket.state() == QAbstractSocket::ConnectedState
            && socket.waitForReadyRead(webPatienceMs))
            continue;
        return socket.readAll();
    }
    QTcpSocket socket;
    QByteArray buffer;
};

inline std::string get(const std::string& target, const std::string& more = "")
{
    return "GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\n" + more + "\r\n";
}

} // namespace axiscomp::test
