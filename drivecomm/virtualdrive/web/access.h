// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/web/message.h"

#include <optional>
#include <string>

namespace axiscomp::drivecomm {

/// Who may ask: HTTP Basic authentication, and no page of another site that a browser shows.
class WebAccess {
public:
    /// host is what the server is bound to; user and password both empty: everybody.
    WebAccess(std::string host, const std::string& user, const std::string& password);

    struct Denial {
        int status;
        Error error;
    };
    [[nodiscard]] std::optional<Denial> denial(const WebRequest& request) const;

private:
    [[nodiscard]] bool isKnownHost(const std::string& host) const;
    [[nodiscard]] static bool isFromOtherSite(const WebRequest& request);

    std::string m_host;
    bool m_isLoopback;
    std::string m_authorization; ///< empty: none is asked for
};

} // namespace axiscomp::drivecomm
