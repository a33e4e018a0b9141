// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/profile/generic_profile.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/verify.h"

#include <QTest>

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace axiscomp::drivecomm::test {

using nlohmann::json;

using Change = std::function<void(json&)>;

inline json genericJson()
{
    return json::parse(genericProfileJson);
}

inline Result<DriveProfile> changedProfile(const Change& change)
{
    json document = genericJson();
    change(document);
    return parseProfile(document.dump(), "own.json");
}

/// A change of the member at a JSON pointer: "/slots/2/maximumSize".
inline Change put(const char* pointer, const json& value)
{
    return
        [place = json::json_pointer(pointer), value](json& document) { document[place] = value; };
}

inline Change without(const char* parent, const char* key)
{
    return [place = json::json_pointer(parent), key = std::string(key)](
               json& document) { document[place].erase(key); };
}

inline void verifyInvalid(const Result<DriveProfile>& profile, const std::string& path,
    const std::string& reason, const std::string& file = "own.json")
{
    VERIFY_ERROR(profile, ErrorCode::InvalidProfile);
    const ErrorContext& context = profile.error().context;
    QCOMPARE(context.english("file"), file);
    QCOMPARE(context.english("path"), path);
    const std::string found = context.english("reason");
    QVERIFY2(found.find(reason) != std::string::npos, found.c_str());
}

} // namespace axiscomp::drivecomm::test

Q_DECLARE_METATYPE(axiscomp::drivecomm::test::Change)
