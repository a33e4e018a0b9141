// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/command_run.h"

#include "app/cli/output/json_output.h"
#include "app/python/json_object.h"

#include <QCoreApplication>

#include <unistd.h>

#include <chrono>
#include <clocale>
#include <future>
#include <utility>

namespace axiscomp::app {

namespace py = pybind11;

namespace {

constexpr std::size_t mostReadings = 100'000;
/// How soon Ctrl-C is seen.
constexpr std::chrono::milliseconds signalInterval{50};

/// Qt's application object must be there as long as any thread talks to a drive. It is made on a
/// thread that never ends, since the first thread that asks for it may; another library of the
/// process may have made one already.
void makeQtApplication()
{
    static std::once_flag once;
    std::call_once(once, [] {
        if (QCoreApplication::instance())
            return;
        std::promise<void> made;
        std::thread([&made] {
            static int count = 1;
            static char name[] = "axiscomp";
            static char* arguments[] = {name, nullptr};
            // It takes over the locale of the user, with which C functions of other modules would
            // read and write numbers with a decimal comma.
            const std::string locale = std::setlocale(LC_ALL, nullptr);
            new QCoreApplication(count, arguments);
            std::setlocale(LC_ALL, locale.c_str());
            made.set_value();
            while (true)
                ::pause();
        }).detach();
        made.get_future().wait();
    });
}

std::string_view className(ErrorClass errorClass)
{
    switch (errorClass) {
    case ErrorClass::NothingToDo:
        return "NothingToDoError";
    case ErrorClass::Stopped:
        return "StoppedError";
    case ErrorClass::Local:
        return "LocalError";
    case ErrorClass::Request:
        return "RequestError";
    case ErrorClass::InputFile:
        return "InputFileError";
    case ErrorClass::Address:
        return "AddressError";
    case ErrorClass::Unauthorized:
        return "UnauthorizedError";
    case ErrorClass::Untrusted:
        return "UntrustedError";
    case ErrorClass::NotConnected:
        return "NotConnectedError";
    case ErrorClass::Lost:
        return "LostError";
    case ErrorClass::Refused:
        return "RefusedError";
    case ErrorClass::FlashWear:
        return "FlashWearError";
    case ErrorClass::Difference:
        return "DifferenceError";
    case ErrorClass::OutcomeUnknown:
        return "OutcomeUnknownError";
    }
    return "Error";
}

/// Nothing that is done with a drive ends because a line cannot be shown. Returns what is no error
/// but asks for an end, such as Ctrl-C while a line is being shown.
std::optional<py::error_already_set> tell(
    const py::object& echo, const std::vector<std::string>& said)
{
    std::optional<py::error_already_set> stopped;
    if (echo.is_none())
        return stopped;
    for (const std::string& text : said) {
        try {
            echo(pythonText(text));
        } catch (py::error_already_set& error) {
            if (error.matches(PyExc_Exception))
                error.discard_as_unraisable("axiscomp: echo");
            else
                stopped.emplace(error);
        }
    }
    return stopped;
}

} // namespace

std::string_view exitCodeName(ExitCode code)
{
    switch (code) {
    case ExitCode::Done:
        return "Done";
    case ExitCode::OtherFailure:
        return "OtherFailure";
    case ExitCode::Usage:
        return "Usage";
    case ExitCode::InputFile:
        return "InputFile";
    case ExitCode::DriveRefused:
        return "DriveRefused";
    case ExitCode::NoConnection:
        return "NoConnection";
    case ExitCode::ReadBackDiffers:
        return "ReadBackDiffers";
    case ExitCode::FlashWear:
        return "FlashWear";
    case ExitCode::ToleranceNotMet:
        return "ToleranceNotMet";
    case ExitCode::Differs:
        return "Differs";
    case ExitCode::ProblemsFound:
        return "ProblemsFound";
    case ExitCode::Stopped:
        return "Stopped";
    }
    return "OtherFailure";
}

namespace {

py::object errorObject(
    const Error& error, const Json& diagnostics, const std::vector<std::string>& notes)
{
    const Json json = toJson(error, diagnostics.is_null() ? Json::array() : diagnostics);
    py::dict context;
    for (const auto& [key, value] : json["context"].items()) {
        const auto whole = error.context.integer(key);
        context[pythonText(key)] = whole ? py::object(py::int_(*whole)) : pythonObject(value);
    }
    const py::module_ errors = py::module_::import("axiscomp.errors");
    const py::object type = errors.attr(std::string(className(errorClass(error.code))).c_str());
    return type(pythonObject(json["code"]), pythonObject(json["message"]), context,
        pythonObject(json["diagnostics"]), pythonTexts(notes));
}

} // namespace

void raiseError(const Error& error, const Json& diagnostics, const std::vector<std::string>& notes)
{
    const py::object exception = errorObject(error, diagnostics, notes);
    PyErr_SetObject(py::type::of(exception).ptr(), exception.ptr());
    throw py::error_already_set();
}

CommandRun::CommandRun(std::vector<std::string> arguments, Environment::Names names)
    : m_interrupt(Interrupt::Signals::AreLeftAlone)
{
    const py::gil_scoped_release released;
    m_thread = std::thread([this, arguments = std::move(arguments), names = std::move(names)] {
        work(arguments, names);
    });
}

CommandRun::~CommandRun()
{
    if (!m_thread.joinable())
        return;
    const py::gil_scoped_release released;
    m_interrupt.request();
    m_thread.join();
}

EmbeddedTakers CommandRun::takers()
{
    return {[this](std::string_view text) {
                const std::lock_guard lock(m_mutex);
                m_output.append(text);
                m_said.emplace_back(text);
                m_news.notify_all();
            },
        [this](std::string_view note) {
            const std::lock_guard lock(m_mutex);
            m_notes.emplace_back(note);
            m_said.push_back(std::string(note) + "\n");
            m_news.notify_all();
        },
        [this](const Json& document) {
            const std::lock_guard lock(m_mutex);
            m_document = document;
        },
        [this](const Json& reading) {
            const std::lock_guard lock(m_mutex);
            m_readings.push_back(reading);
            if (m_readings.size() > mostReadings) {
                m_readings.pop_front();
                ++m_missed;
            }
            m_news.notify_all();
        }};
}

void CommandRun::work(const std::vector<std::string>& arguments, const Environment::Names& names)
{
    try {
        makeQtApplication();
        EmbeddedEnd end = runEmbedded(arguments, m_interrupt, takers(), names);
        const std::lock_guard lock(m_mutex);
        m_end = std::move(end);
    } catch (...) {
        const std::lock_guard lock(m_mutex);
        m_exception = std::current_exception();
    }
    const std::lock_guard lock(m_mutex);
    m_isDone = true;
    m_news.notify_all();
}

std::vector<std::string> CommandRun::waitForNews(bool forReading)
{
    const py::gil_scoped_release released;
    std::unique_lock lock(m_mutex);
    m_news.wait_for(lock, signalInterval, [this, forReading] {
        return m_isDone || (forReading ? !m_readings.empty() : !m_said.empty());
    });
    return std::exchange(m_said, {});
}

void CommandRun::raiseFailure()
{
    if (m_exception)
        std::rethrow_exception(std::exchange(m_exception, nullptr));
    if (m_end && m_end->error)
        raiseError(*m_end->error, m_end->diagnostics, m_notes);
}

py::tuple CommandRun::end(const py::object& echo)
{
    std::optional<py::error_already_set> stopped;
    for (bool isDone = false; !isDone;) {
        auto asked = tell(echo, waitForNews(false));
        if (PyErr_CheckSignals() != 0)
            asked.emplace();
        if (asked) {
            stopped.emplace(*asked);
            m_interrupt.request();
        }
        const std::lock_guard lock(m_mutex);
        isDone = m_isDone && m_said.empty();
    }
    if (stopped) {
        if (m_end && m_end->error && m_end->error->code != ErrorCode::Cancelled) {
            try {
                raiseFailure();
            } catch (py::error_already_set& failure) {
                PyException_SetCause(stopped->value().ptr(), failure.value().inc_ref().ptr());
            }
        }
        throw *stopped;
    }
    raiseFailure();
    const py::object document = m_document ? pythonObject(*m_document) : py::none();
    const py::object told =
        m_end->told ? errorObject(*m_end->told, m_end->diagnostics, m_notes) : py::none();
    return py::make_tuple(pythonText(exitCodeName(m_end->code)), document, py::bytes(m_output),
        pythonTexts(m_notes), told);
}

py::object CommandRun::nextReading()
{
    while (true) {
        static_cast<void>(waitForNews(true));
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        std::optional<Json> reading;
        bool isDone = false;
        {
            // Only here: Python may hand its lock to another thread, which waits for this one.
            const std::lock_guard lock(m_mutex);
            isDone = m_isDone;
            if (!m_readings.empty()) {
                reading = std::move(m_readings.front());
                m_readings.pop_front();
            }
        }
        if (reading)
            return pythonObject(*reading);
        if (isDone) {
            raiseFailure();
            return py::none();
        }
    }
}

std::size_t CommandRun::missed()
{
    const std::lock_guard lock(m_mutex);
    return m_missed;
}

void CommandRun::stop()
{
    const py::gil_scoped_release released;
    m_interrupt.request();
    const std::lock_guard lock(m_joinMutex);
    if (m_thread.joinable())
        m_thread.join();
}

} // namespace axiscomp::app
