// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/faults.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <memory>
#include <string>

namespace axiscomp::drivecomm {

struct SerialServerOptions {
    std::string link; ///< a symbolic link to the port, kept up to date; empty: none
    int baud = 0; ///< each direction carries a tenth of it in bytes per second; 0: no limit
};

/// The virtual drive's serial link of docs/protocol.md, on a pseudo-terminal, from a thread of its
/// own, until it is destroyed. A connection that is cut (drop-after) is a port that disappears; a
/// new one takes its place, under the same link.
class SerialServer {
public:
    /// drive and faults must outlive the server. Errors: InvalidEndpoint (endpoint = link).
    [[nodiscard]] static Result<std::unique_ptr<SerialServer>> start(
        VirtualDrive& drive, FaultPlan& faults, const SerialServerOptions& options = {});
    ~SerialServer();

    /// "/dev/pts/7"
    [[nodiscard]] std::string device() const;
    /// "serial:/dev/pts/7?baud=921600", by its link where it has one
    [[nodiscard]] std::string url() const;

private:
    struct Private;
    explicit SerialServer(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::drivecomm
