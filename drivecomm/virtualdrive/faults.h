// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::drivecomm {

/// A named fault (docs/protocol.md, "Faults on purpose"). N counts requests from 1, over all
/// clients.
struct FaultSpec {
    enum class Kind {
        DropAfter, ///< drop-after=BYTES: the connection is cut once, after so many bytes in either
                   ///< direction
        NoReply, ///< no-reply=N: the N-th request is carried out, its reply never comes
        Garble, ///< garble=N: bytes of the N-th reply are flipped
        StoresWrong, ///< stores-wrong=N: the N-th write or upload stores something else
        Slow, ///< slow=MS: every reply comes so much later
        RebootAfter, ///< reboot-after=N: the drive reboots after the N-th request, instead of
                     ///< replying
        Reject, ///< reject=CODE: every write and upload is refused with this error code
    };
    Kind kind = Kind::Slow;
    std::uint64_t number = 0;
    std::string code;
};

/// Errors: InvalidArgument with the known names.
[[nodiscard]] Result<FaultSpec> parseFault(std::string_view text);

/// What a drive answers for reject=CODE.
[[nodiscard]] Error errorAskedFor(const std::string& code);

/// What a server must do with one request. Thread-safe; shared by all servers of a drive.
class FaultPlan {
public:
    /// Told of every request before it is carried out, on the thread that serves it; may change
    /// the plan.
    using Observer = std::function<void(bool isWrite)>;
    explicit FaultPlan(std::vector<FaultSpec> faults = {}, Observer observer = {});

    struct Decision {
        bool noReply = false;
        bool garble = false;
        bool storeWrong = false;
        bool reboot = false;
        std::optional<std::string> rejectCode;
        std::chrono::milliseconds delay{0};
    };
    /// Called once per request, before it is carried out.
    [[nodiscard]] Decision next(bool isWrite);
    /// How many more bytes a connection may carry before it must be cut (1 or more); none: no such
    /// fault is left.
    [[nodiscard]] std::optional<std::uint64_t> bytesUntilDrop() const;
    /// Counting the last of them spends the fault: whoever counts it cuts the connection.
    void countBytes(std::uint64_t bytes);
    struct Carried {
        std::ptrdiff_t bytes; ///< what send said; below 0: it failed
        bool isCut; ///< the last byte before a cut was among them
    };
    /// Sends at most this many bytes (1 or more), at most those until a cut, and counts what was
    /// sent: whoever receives them and asks then finds them counted. send must not wait, nor use
    /// this plan.
    Carried carry(std::size_t bytes, const std::function<std::ptrdiff_t(std::size_t)>& send);
    /// Requests and writes are counted from the beginning or the last clear(), bytes from here.
    void add(FaultSpec fault);
    /// No more faults; counting starts again.
    void clear();

private:
    [[nodiscard]] std::optional<std::uint64_t> untilDrop() const;
    void count(std::uint64_t bytes);

    const Observer m_observer;
    mutable std::mutex m_mutex;
    std::vector<FaultSpec> m_faults;
    std::uint64_t m_requests = 0;
    std::uint64_t m_writes = 0;
};

} // namespace axiscomp::drivecomm
