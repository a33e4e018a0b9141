// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/http/http_client.h"

#include <string>

namespace axiscomp::drivecomm {

/// What a request was about, for the errors that name it.
struct AskedFor {
    ErrorCode unknown = ErrorCode::DriveRejected; ///< a plain 404: UnknownRegister or UnknownFile
    Argument path = Verbatim{}; ///< the register or file, empty when there are several
};

/// The error that a reply stands for; nothing to say for 2xx. Takes the drive's JSON where there is
/// some, and the bare status where the drive only has pages (docs/protocol.md, "Web server"). The
/// endpoint is added by addEndpoint.
[[nodiscard]] Result<void> checkStatus(const HttpReply& reply, const AskedFor& asked);

/// Protocol unless the reply is JSON by its type.
[[nodiscard]] Result<void> checkJson(const HttpReply& reply, const Text& expected);

[[nodiscard]] Error addEndpoint(Error error, const std::string& endpoint);

} // namespace axiscomp::drivecomm
