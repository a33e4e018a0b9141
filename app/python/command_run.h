// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"
#include "app/cli/program.h"
#include "core/base/result.h"

#include <pybind11/pybind11.h>

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace axiscomp::app {

/// A command of axiscomp on a thread of its own. Its functions are called with the interpreter's
/// lock, which is released while they wait.
class CommandRun {
public:
    /// names: of files that stand for objects of Python.
    explicit CommandRun(std::vector<std::string> arguments, Environment::Names names = {});
    CommandRun(const CommandRun&) = delete;
    CommandRun& operator=(const CommandRun&) = delete;
    ~CommandRun();

    /// Until the command has ended. echo: is called with each line of notes and each piece of text;
    /// may be None. Ctrl-C stops the command as on the command line, where what was changed is put
    /// back first, and is raised afterwards. Returns (exit code's name, document, output, notes,
    /// error or None); the error is one beside which there is a document.
    [[nodiscard]] pybind11::tuple end(const pybind11::object& echo);

    /// The next reading, or None when the command has ended. Raises its error.
    [[nodiscard]] pybind11::object nextReading();
    /// Of readings that nobody has fetched in time: the oldest are dropped.
    [[nodiscard]] std::size_t missed();

    void stop();

private:
    void work(const std::vector<std::string>& arguments, const Environment::Names& names);
    [[nodiscard]] EmbeddedTakers takers();
    /// Waits without the interpreter's lock until there is something new; takes what was said.
    [[nodiscard]] std::vector<std::string> waitForNews(bool forReading);
    void raiseFailure();

    Interrupt m_interrupt;
    std::mutex m_mutex;
    std::condition_variable m_news;
    std::string m_output;
    std::vector<std::string> m_notes;
    std::vector<std::string> m_said; ///< for echo
    std::optional<Json> m_document;
    std::deque<Json> m_readings;
    std::size_t m_missed = 0;
    std::optional<EmbeddedEnd> m_end;
    std::exception_ptr m_exception;
    bool m_isDone = false;
    std::mutex m_joinMutex; ///< two threads of Python may stop it
    std::thread m_thread;
};

/// Raises axiscomp.Error, of the class that suits the error.
[[noreturn]] void raiseError(
    const Error& error, const Json& diagnostics = {}, const std::vector<std::string>& notes = {});

/// The value, or its error raised.
template <typename T> [[nodiscard]] T valueOf(Result<T> result)
{
    if (!result)
        raiseError(result.error());
    return *std::move(result);
}

/// "Done", "ToleranceNotMet", ...
[[nodiscard]] std::string_view exitCodeName(ExitCode code);

} // namespace axiscomp::app
