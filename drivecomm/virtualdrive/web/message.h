// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axiscomp::drivecomm {

/// A field of a form that a browser sent, in the order of the form.
struct FormField {
    std::string name;
    std::string value; ///< of a file its bytes
    std::string fileName;
    bool isFile = false;
};

/// What the pages need to know of an HTTP request. Path, query and fields are percent-decoded,
/// once.
struct WebRequest {
    std::string method; ///< GET for HEAD too
    std::string path;
    std::vector<std::pair<std::string, std::string>> query;
    std::string contentType; ///< lower case, without parameters
    std::string body; ///< empty for a form
    std::vector<FormField> fields;
    bool isTooLarge = false; ///< the body was read and thrown away
    bool isMalformed = false; ///< the body is not what its type says
    std::string accept;
    std::string authorization;
    std::string host;
    std::string origin;
    std::string fetchSite; ///< Sec-Fetch-Site
    std::string referer;
    std::string ifNoneMatch;
};

struct WebReply {
    int status = 200;
    std::string contentType;
    std::string body;
    std::vector<std::pair<std::string, std::string>> headers;
};

/// DriveRejected with this reason.
[[nodiscard]] Error rejected(std::string reason);
/// Path and query of the page on this drive that led here, "/" when there is none.
[[nodiscard]] std::string pageBefore(const WebRequest& request);

[[nodiscard]] WebReply htmlReply(std::string page, int status = 200);
[[nodiscard]] WebReply jsonReply(std::string json, int status = 200);

/// What the client would rather have; otherwise when it likes both alike, or says nothing.
enum class Form { Html, Json };
[[nodiscard]] Form preferredForm(std::string_view accept, Form otherwise);

/// a=b&c=d, with + for a blank.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> parseUrlEncoded(
    std::string_view text);

} // namespace axiscomp::drivecomm
