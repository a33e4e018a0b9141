// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/interrupt.h"
#include "core/base/result.h"

#include <chrono>
#include <memory>
#include <string>

namespace axiscomp::app {

enum class Input { None, Some, Ended };

/// What is read as it comes: standard input, or a file of any kind, such as a pipe.
class InputStream {
public:
    /// All objects of it read on where the others have stopped.
    [[nodiscard]] static InputStream standardInput();
    /// Errors: FileNotReadable.
    [[nodiscard]] static Result<InputStream> open(const std::string& file);

    InputStream(InputStream&& other) noexcept;
    InputStream& operator=(InputStream&& other) noexcept;
    ~InputStream();

    /// Appends what has come, waiting for it; false at the end. Errors: Cancelled, FileNotReadable.
    [[nodiscard]] Result<bool> readMore(Interrupt& interrupt, std::string& text);
    /// Waits until a moment for something, which is appended, or just so long when it is not read.
    /// None: the moment has come. Errors: Cancelled, FileNotReadable.
    [[nodiscard]] Result<Input> waitForInput(Interrupt& interrupt, bool reads,
        std::chrono::steady_clock::time_point until, std::string& text);

private:
    struct Source; ///< input_stream_posix.cpp, input_stream_windows.cpp
    InputStream(std::string name, std::shared_ptr<Source> source);
    [[nodiscard]] tl::unexpected<Error> notReadable(const std::error_code& error) const;

    std::string m_name; ///< for errors
    std::shared_ptr<Source> m_source;
};

} // namespace axiscomp::app
