// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <functional>
#include <memory>
#include <string>

namespace axiscomp::drivecomm {

struct InstrumentServerOptions {
    std::string link; ///< a symbolic link to the port; empty: none
    std::string unit = "mm"; ///< of the lines
    double unitsPerPosition = 1.0; ///< of that unit in what `reading` gives
    int linesPerSecond = 10;
};

/// A measuring instrument on a pseudo-terminal: lines such as "+517.3000042 mm" at a steady rate,
/// and one more for each line that it gets. What nobody has read is replaced by what is true now,
/// so that the first line that a client reads is never an old one.
class InstrumentServer {
public:
    /// reading is called from the server's own thread. Errors: InvalidEndpoint (endpoint = link).
    [[nodiscard]] static Result<std::unique_ptr<InstrumentServer>> start(
        std::function<double()> reading, const InstrumentServerOptions& options);
    ~InstrumentServer();

    /// "/dev/pts/7"
    [[nodiscard]] const std::string& device() const;

private:
    struct Private;
    explicit InstrumentServer(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::drivecomm
