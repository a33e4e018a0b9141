// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"

#include <atomic>
#include <functional>
#include <string>

namespace axiscomp::test {

/// Answers as the test says and counts what it is asked beside identify.
class ScriptedLink final : public DriveLink {
public:
    using Answer = std::function<Result<DriveIdentity>(const Exchange&)>;
    ScriptedLink(std::string endpoint, Answer answer, std::atomic<int>& otherRequests)
        : m_endpoint(std::move(endpoint))
        , m_answer(std::move(answer))
        , m_otherRequests(otherRequests)
    {
    }

    std::string endpoint() const override { return m_endpoint; }
    Result<DriveIdentity> identify(const Exchange& exchange) override { return m_answer(exchange); }
    Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string>, const Exchange&) override
    {
        return refused();
    }
    Result<std::vector<RegisterReading>> readTree(const std::string&, const Exchange&) override
    {
        return refused();
    }
    Result<void> writeRegisters(std::span<const RegisterWrite>, const Exchange&) override
    {
        return refused();
    }
    Result<std::vector<DriveFile>> listFiles(const Exchange&) override { return refused(); }
    Result<Bytes> download(const std::string&, const Exchange&) override { return refused(); }
    Result<void> upload(const std::string&, ByteView, const Exchange&) override
    {
        return refused();
    }

private:
    tl::unexpected<Error> refused()
    {
        ++m_otherRequests;
        return fail(ErrorCode::DriveRejected, {{"reason", Verbatim{"not now"}}});
    }

    std::string m_endpoint;
    Answer m_answer;
    std::atomic<int>& m_otherRequests;
};

} // namespace axiscomp::test
