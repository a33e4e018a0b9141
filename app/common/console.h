// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>

namespace axiscomp::app {

/// Text on one line that cannot command the terminal: what comes from files and drives may hold
/// line ends and escape sequences.
[[nodiscard]] std::string singleLine(std::string_view text);
/// Addresses in it lose user name and password: a mistyped command line is quoted in errors.
[[nodiscard]] std::string withoutPasswords(std::string_view text);

/// The two output streams of a program. Results go to standard output, errors and notes to standard
/// error, progress to standard error when a person looks at it. May be used from several threads.
class Console {
public:
    Console();
    /// Of a program inside of another one, which takes what is said. output: of print(), in pieces.
    /// notes: one line, without its end. Both may be called on any thread; no progress is shown.
    using Taker = std::function<void(std::string_view text)>;
    Console(Taker output, Taker notes);
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;
    ~Console();

    /// Standard output; kept until flush(), note() or a full buffer.
    void print(std::string_view text);
    /// One line on standard error.
    void note(std::string_view line);

    /// Rewrites one line, at most ten times a second; nothing unless standard error is a terminal.
    void progress(std::string_view step, double fraction);
    void clearProgress();

    /// Sends what print() kept. Errors: FileNotWritable, the first that ever happened. A reader
    /// that has gone away is not an error (see readerGone).
    [[nodiscard]] Result<void> flush();
    /// Nobody reads standard output any more: work whose only result goes there may end.
    [[nodiscard]] bool readerGone() const;
    [[nodiscard]] bool outputIsTerminal() const { return m_outputIsTerminal; }

private:
    void send();
    void hideProgress();

    mutable std::mutex m_mutex;
    Taker m_output; ///< empty: standard output
    Taker m_notes; ///< empty: standard error
    std::string m_kept;
    std::error_code m_outputError; ///< the first
    bool m_outputIsTerminal = false;
    bool m_showsProgress = false;
    bool m_progressVisible = false;
    std::size_t m_width = 80;
    std::chrono::steady_clock::time_point m_progressDue{};
};

} // namespace axiscomp::app
