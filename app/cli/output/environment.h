// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "app/common/console.h"
#include "app/common/interrupt.h"
#include "core/base/error.h"
#include "core/text/diagnostic.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axiscomp::app {

/// What a command works with besides its options.
class Environment {
public:
    Environment(Console& console, Interrupt& interrupt, bool json);
    /// Of a program inside of another one, which takes text and document. readings: one after the
    /// other, of a command that goes on until it is stopped.
    using Taker = std::function<void(const Json&)>;
    Environment(Console& console, Interrupt& interrupt, Taker documents, Taker readings);

    [[nodiscard]] Console& console() { return m_console; }
    [[nodiscard]] Interrupt& interrupt() { return m_interrupt; }
    [[nodiscard]] std::stop_token stopToken() const { return m_interrupt.token(); }

    /// Whether --json was given: print() is silent then, and document() speaks.
    [[nodiscard]] bool json() const { return m_json; }
    /// Text for people on standard output.
    void print(std::string_view text);
    /// The same of what was done to a drive: it must be known, whatever becomes of standard output.
    void report(std::string_view text);
    /// Says on standard error what was reported.
    void noteReports();
    /// How files are called that stand for something in memory: such a name is kept in records.
    using Names = std::map<std::string, std::string>;
    void callFiles(Names names) { m_names = std::move(names); }
    [[nodiscard]] std::string nameOf(const std::string& file) const;

    /// The one JSON document of the command.
    void document(const Json& json);
    /// Whether somebody reads it, so that what only it has is worth collecting.
    [[nodiscard]] bool takesDocument() const { return m_json || m_documents != nullptr; }
    /// Whether somebody takes them.
    [[nodiscard]] bool takesReadings() const { return m_readings != nullptr; }
    void reading(const Json& json) { m_readings(json); }

    /// "FILE:LINE:COLUMN: error: ..." on standard error, kept for the JSON document of an error.
    void diagnose(const std::string& file, const std::vector<Diagnostic>& diagnostics);
    /// The same for an error of a file that is no calibration file.
    void diagnose(const std::string& file, std::size_t line, std::size_t column,
        const std::string& code, const std::string& what);
    [[nodiscard]] const Json& diagnostics() const { return m_diagnostics; }

    /// "error: CODE: ..." on standard error, of a command that goes on, and whose document says
    /// what became of the rest. place: in front of the sentence, or empty.
    void tell(const Error& error, const std::string& place = {});
    /// The first one: its code is that of the program.
    [[nodiscard]] const std::optional<Error>& told() const { return m_told; }

    /// "warning: ..." on standard error.
    void warn(const std::string& sentence);

private:
    Console& m_console;
    Interrupt& m_interrupt;
    bool m_json = false;
    Taker m_documents;
    Taker m_readings;
    Names m_names;
    Json m_diagnostics = Json::array();
    std::optional<Error> m_told;
    std::string m_reports;
};

} // namespace axiscomp::app
