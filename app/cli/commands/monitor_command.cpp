// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/session/command_session.h"
#include "app/common/number_checks.h"
#include "app/common/number_text.h"
#include "core/drive/drive_profile.h"

#include <condition_variable>
#include <mutex>

namespace axiscomp::app {

namespace {

struct MonitorOptions {
    DriveOptions drive;
    double rateHz = 10.0;
    std::uint64_t count = 0; ///< 0: until stopped
};

/// False when the user has stopped.
bool sleepUntil(std::chrono::steady_clock::time_point moment, const std::stop_token& stop)
{
    std::mutex mutex;
    std::condition_variable_any woken;
    std::unique_lock lock(mutex);
    woken.wait_until(lock, stop, moment, [] { return false; });
    return !stop.stop_requested();
}

/// Reads the registers of a running compensation in one request, line by line.
class Monitor {
public:
    /// settings: what decides which table is looked up, and where (axisRegisterPaths), read before
    /// the status, so that whoever changes them is noticed.
    Monitor(Environment& environment, CommandSession& session, const AxisStatus& status,
        std::vector<RegisterReading> settings)
        : m_environment(environment)
        , m_session(session)
        , m_settings(std::move(settings))
        , m_dimensions(status.table ? status.table->grid.dimensions() : status.setup.dimensionality)
    {
        const RegisterPaths& names = session.profile().registers;
        const int axis = status.axis.index;
        add("state", expandPath(names.state, {.axis = axis, .slot = {}, .n = {}}));
        add("output", expandPath(names.output, {.axis = axis, .slot = {}, .n = {}}));
        for (int n = 1; n <= m_dimensions; ++n)
            add("index" + std::to_string(n),
                expandPath(names.index, {.axis = axis, .slot = {}, .n = n}));
        for (std::size_t n = 0; n < status.setup.sources.size(); ++n) {
            if (!status.setup.sources[n].path.empty())
                add("source" + std::to_string(n + 1), status.setup.sources[n].path);
        }
        for (const RegisterReading& setting : m_settings)
            m_paths.push_back(setting.path);
    }

    Result<ExitCode> run(const MonitorOptions& options)
    {
        begin();
        const auto start = std::chrono::steady_clock::now();
        const std::chrono::duration<double> period(1.0 / options.rateHz);
        auto due = start;
        Result<ExitCode> outcome = ExitCode::Done;
        for (std::uint64_t i = 0; options.count == 0 || i < options.count; ++i) {
            if (!sleepUntil(due, m_environment.stopToken()))
                break;
            const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
            const auto readings = m_session.link().readRegisters(m_paths, m_session.exchange());
            if (!readings && readings.error().code == ErrorCode::Cancelled)
                break;
            if (!readings) {
                outcome = fail(readings.error());
                break;
            }
            if (const auto same = checkSettings(*readings); !same) {
                outcome = fail(same.error());
                break;
            }
            show(time.count(), *readings);
            if (!m_environment.console().flush() || m_environment.console().readerGone())
                break;
            // A drive that is slower than the rate sets the pace; nothing is made up for.
            due = std::max(due + std::chrono::duration_cast<std::chrono::nanoseconds>(period),
                std::chrono::steady_clock::now());
        }
        return end(std::move(outcome));
    }

private:
    void add(std::string name, std::string path)
    {
        m_names.push_back(std::move(name));
        m_paths.push_back(std::move(path));
    }

    /// Errors: ChangedMeanwhile: the columns are no longer the sources of the table.
    [[nodiscard]] Result<void> checkSettings(const std::vector<RegisterReading>& readings) const
    {
        for (std::size_t i = 0; i < m_settings.size() && m_names.size() + i < readings.size();
             ++i) {
            const std::string before = toText(m_settings[i].value);
            const std::string now = toText(readings[m_names.size() + i].value);
            if (now != before)
                return fail(ErrorCode::ChangedMeanwhile,
                    {{"what", m_settings[i].path}, {"before", before}, {"now", now}});
        }
        return {};
    }

    void begin()
    {
        std::string header = "time";
        for (const std::string& name : m_names)
            header += "," + name;
        m_environment.print(header + "\n");
        if (m_environment.json())
            m_environment.console().print("[");
    }

    void show(double seconds, const std::vector<RegisterReading>& readings)
    {
        const std::string time = fixedText(seconds, 3);
        std::string line = time;
        Json json = {{"time", seconds}};
        for (std::size_t i = 0; i < readings.size() && i < m_names.size(); ++i) {
            line += "," + toText(readings[i].value);
            const double number = toDouble(readings[i].value);
            const bool isText = std::holds_alternative<std::string>(readings[i].value);
            json[m_names[i]] = isText ? Json(toText(readings[i].value)) : Json(number);
        }
        if (m_environment.takesReadings()) {
            m_environment.reading(json);
            return;
        }
        m_environment.print(line + "\n");
        if (m_environment.json())
            m_environment.console().print((m_isFirst ? "\n  " : ",\n  ")
                + json.dump(-1, ' ', false, Json::error_handler_t::replace));
        m_isFirst = false;
    }

    /// Closes the document; an error inside it would be no JSON, so it only goes to standard error.
    Result<ExitCode> end(Result<ExitCode> outcome)
    {
        if (!m_environment.json())
            return outcome;
        m_environment.console().print("\n]\n");
        if (outcome)
            return outcome;
        const Error& error = outcome.error();
        m_environment.console().note(
            "error: " + std::string(errorName(error.code)) + ": " + sentence(error));
        return exitCode(error.code);
    }

    Environment& m_environment;
    CommandSession& m_session;
    std::vector<RegisterReading> m_settings; ///< at the beginning
    int m_dimensions = 1;
    std::vector<std::string> m_names; ///< of the columns
    std::vector<std::string> m_paths; ///< of the columns, and behind them of the settings
    bool m_isFirst = true;
};

Result<ExitCode> runMonitor(
    Environment& environment, CommandSession& session, int axis, const MonitorOptions& options)
{
    const std::vector<std::string> paths = axisRegisterPaths(session.profile(), axis);
    auto settings = session.link().readRegisters(paths, session.exchange());
    // It says more clearly what is wrong with an axis.
    AXISCOMP_TRY(const auto status, session.compensator().status(axis, session.operation()));
    if (!settings)
        return fail(settings.error());
    return Monitor(environment, session, status, *std::move(settings)).run(options);
}

} // namespace

void addMonitorCommand(CommandLine& line)
{
    auto options = std::make_shared<MonitorOptions>();
    options->drive.command = commandName("monitor");
    CLI::App* command = line.add("monitor", driveCommands,
        AXISCOMP_HELP("Help", "Print output, indices and sources of an axis as CSV until stopped"),
        [options](Environment& environment) {
            return withAxis(environment, options->drive,
                [&](Environment& sameEnvironment, CommandSession& session, int axis) {
                    return runMonitor(sameEnvironment, session, axis, *options);
                });
        });
    addDriveOptions(*command, options->drive);
    addAxisOption(*command, options->drive);
    command
        ->add_option("--rate", options->rateHz,
            AXISCOMP_HELP("Help", "Lines per second, 1 to 100 (10 unless given)"))
        ->option_text("HZ")
        ->check(numberBetween(1.0, 100.0));
    command
        ->add_option("--count", options->count,
            AXISCOMP_HELP("Help", "Number of lines; without end unless given"))
        ->option_text("N")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}));
    command->footer(AXISCOMP_HELP("Help",
        "Example:") "\n  axiscomp monitor --drive http://192.168.1.20 --axis X --rate 50 > x.csv");
}

} // namespace axiscomp::app
