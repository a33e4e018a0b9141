// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/codec/error_json.h"
#include "drivecomm/codec/register_json.h"
#include "drivecomm/http/percent_encoding.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/web/web_drive_link.h"
#include "tests/drivecomm/known_paths.h"
#include "tests/support/raw_responder.h"
#include "tests/support/verify.h"

namespace axiscomp::test {

using namespace drivecomm;

using Answer = std::function<void(RawConnection&)>;

inline const std::vector<std::string> twoStates{stateOfX, stateOfY};
inline const std::vector<RegisterWrite> oneWrite{{"Application/Variables/Floats[0]", 1.0F}};

inline std::unique_ptr<DriveLink> webLinkTo(const std::string& url)
{
    return makeWebDriveLink(parseEndpoint(url).value(), genericProfile());
}

inline std::string states(const std::string& first, const std::string& second)
{
    return readingsJson(std::vector<RegisterReading>{
        {first, 1, "State", std::string("Disabled")}, {second, 2, "State", std::string("Active")}});
}

/// Answers each request of each connection alike.
inline Answer always(std::string reply)
{
    return [reply = std::move(reply)](RawConnection& connection) {
        while (!connection.readRequest().empty() && connection.send(reply))
            continue;
    };
}

/// Answers one request and closes.
inline Answer once(std::string reply)
{
    return [reply = std::move(reply)](RawConnection& connection) {
        connection.readRequest();
        connection.send(reply);
    };
}

inline Answer json(const std::string& body)
{
    return always(httpReply("200 OK", "application/json", body));
}

/// Answers register requests as a drive with so many axes. Does the error for an unknown register
/// say which, or is it a bare page?
enum class Missing { Named, Unnamed };
inline Answer driveWithAxes(int axes, Missing missing)
{
    return [axes, missing](RawConnection& c) {
        while (true) {
            const std::string request = c.readRequest();
            if (request.empty())
                return;
            std::vector<RegisterReading> readings;
            std::string unknown;
            const std::string target = request.substr(0, request.find(" HTTP"));
            for (std::size_t at = target.find("path="); at != std::string::npos;
                 at = target.find("path=", at + 1)) {
                const std::string encoded = target.substr(at + 5, target.find('&', at) - at - 5);
                const std::string path = formDecoded(encoded);
                readings.push_back({path, 1, "Int32", std::int32_t{0}});
                if (unknown.empty() && path.starts_with("Axes[")
                    && std::stoi(path.substr(5)) >= axes)
                    unknown = path;
            }
            if (unknown.empty())
                c.send(httpReply("200 OK", "application/json", readingsJson(readings)));
            else if (missing == Missing::Named)
                c.send(httpReply("404 Not Found", "application/json",
                    errorJson({ErrorCode::UnknownRegister, {{"path", unknown}}, {}})));
            else
                c.send(httpReply("404 Not Found", "text/html", "<p>no such register</p>"));
        }
    };
}

} // namespace axiscomp::test
