// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"
#include "app/cli/json_output.h"
#include "app/cli/standard_input.h"
#include "app/cli/table_input.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "core/interpolation.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <map>

namespace axiscomp::app {

namespace {

constexpr std::string_view separators = " \t,;";
constexpr std::size_t longestLine = 64 * 1024;

const std::map<std::string, Outside> outsideNames{{"hold", Outside::Hold}, {"zero", Outside::Zero},
    {"wrap", Outside::Wrap}, {"extrapolate", Outside::Extrapolate}, {"error", Outside::Error}};

struct LookupOptions {
    TableInputOptions input;
    std::vector<std::string> position;
    std::string points;
    std::string outside = "hold";
};

struct Field {
    std::string_view text;
    std::size_t column = 1; ///< of its first character
};

std::vector<Field> splitFields(std::string_view line)
{
    std::vector<Field> fields;
    std::size_t begin = 0;
    while ((begin = line.find_first_not_of(separators, begin)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
        fields.push_back({line.substr(begin, end - begin), begin + 1});
        begin = end;
    }
    return fields;
}

std::string rangeText(const GridAxis& axis)
{
    return shortText(axis.start) + " to " + shortText(axis.last());
}

Result<double> lookUp(const Lookup& lookup, const Grid& grid, const std::vector<double>& position)
{
    const double value = lookup.at(position);
    if (!std::isnan(value))
        return value;
    std::string reason = "the position is outside of the table:";
    for (std::size_t n = 0; n < position.size(); ++n)
        reason += (n == 0 ? " " : ", ") + shortText(position[n]) + " of " + rangeText(grid.axes[n]);
    return fail(ErrorCode::InvalidArgument, {{"reason", reason}});
}

/// Answers the lines of a file of positions, each as soon as it has come.
class PointFile {
public:
    PointFile(Environment& environment, const LookupOptions& options, const Lookup& lookup,
        const Grid& grid)
        : m_environment(environment)
        , m_name(displayName(options.points))
        , m_lookup(lookup)
        , m_grid(grid)
    {
    }

    Result<void> answer(const std::string& file, Json& results)
    {
        const bool isStandardInput = file == standardStream;
        const int descriptor =
            isStandardInput ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
        if (descriptor < 0)
            return fail(
                ErrorCode::FileNotReadable, {{"file", file}, {"reason", std::strerror(errno)}});
        auto answered = answerAll(descriptor, results);
        if (!isStandardInput)
            ::close(descriptor);
        return answered;
    }

private:
    Result<void> answerAll(int descriptor, Json& results)
    {
        std::string text;
        while (true) {
            const auto more = readMore(descriptor, m_environment.interrupt(), text);
            if (!more)
                return fail(more.error());
            if (!*more && !text.empty())
                text.push_back('\n');
            if (auto answered = answerLines(text, results); !answered)
                return answered;
            if (!*more || m_environment.console().readerGone())
                return {};
            if (text.size() > longestLine) {
                ++m_line;
                return wrong(1, "a line with a position", "more than 65536 characters");
            }
        }
    }

    /// Takes the complete lines out of text.
    Result<void> answerLines(std::string& text, Json& results)
    {
        std::size_t begin = 0;
        std::size_t end = 0;
        while ((end = text.find('\n', begin)) != std::string::npos) {
            std::string_view line(text.data() + begin, end - begin);
            if (line.ends_with('\r'))
                line.remove_suffix(1);
            ++m_line;
            if (auto answered = answerLine(line, results); !answered)
                return answered;
            begin = end + 1;
        }
        text.erase(0, begin);
        return m_environment.console().flush();
    }

    Result<void> answerLine(std::string_view line, Json& results)
    {
        const std::vector<Field> fields = splitFields(line);
        if (fields.size() != m_grid.axes.size())
            return wrong(
                1, plural(m_grid.axes.size(), "number", "numbers"), std::to_string(fields.size()));
        std::vector<double> position;
        for (const Field& field : fields) {
            const auto number = numberFromText(field.text);
            if (!number)
                return wrong(field.column, "a number such as 0.5",
                    "\"" + std::string(field.text.substr(0, 40)) + "\"");
            position.push_back(*number);
        }
        const auto value = lookUp(m_lookup, m_grid, position);
        if (!value)
            return wrong(1, "", sentence(value.error()));
        m_environment.print(floatText(*value) + "\n");
        if (m_environment.json())
            results.push_back({{"position", position}, {"value", *value}});
        return {};
    }

    Result<void> wrong(std::size_t column, const std::string& expected, const std::string& found)
    {
        const std::string what =
            expected.empty() ? found : "found " + found + ", expected " + expected;
        m_environment.diagnose(m_name, m_line, column, "InvalidPosition", what);
        return fail(ErrorCode::InvalidCalibration, {{"file", m_name}, {"count", "1"}});
    }

    Environment& m_environment;
    std::string m_name;
    const Lookup& m_lookup;
    const Grid& m_grid;
    std::size_t m_line = 0;
};

Result<std::vector<double>> positionOf(const LookupOptions& options, const Grid& grid)
{
    std::vector<double> position;
    for (const std::string& text : options.position) {
        const auto number = numberFromText(text);
        if (!number)
            return wrongUsage(
                "a position must be a number such as -12.5, not " + text, options.input.command);
        position.push_back(*number);
    }
    if (position.size() != grid.axes.size())
        return wrongUsage("the table has " + plural(grid.axes.size(), "dimension", "dimensions")
                + ", but " + plural(position.size(), "position is", "positions are") + " given",
            options.input.command);
    return position;
}

Result<ExitCode> runLookup(Environment& environment, const LookupOptions& options)
{
    if (options.points.empty() == options.position.empty())
        return wrongUsage(options.points.empty() ? "give a position, or --points FILE"
                                                 : "give a position or --points, not both",
            options.input.command);
    if (options.points == standardStream && options.input.file == standardStream)
        return wrongUsage(
            "the table and the points cannot both come from standard input", options.input.command);
    auto input = readInput(environment, options.input);
    if (!input)
        return fail(input.error());
    const auto index = chooseTable(*input->data, options.input);
    if (!index)
        return fail(index.error());
    const CompensationTable& table = input->data->tables[*index];
    const Lookup lookup(table, outsideNames.at(options.outside));

    Json results = Json::array();
    if (!options.points.empty()) {
        PointFile points(environment, options, lookup, table.grid);
        if (auto answered = points.answer(options.points, results); !answered)
            return fail(answered.error());
    } else {
        const auto position = positionOf(options, table.grid);
        if (!position)
            return fail(position.error());
        const auto value = lookUp(lookup, table.grid, *position);
        if (!value)
            return fail(value.error());
        environment.print(floatText(*value) + "\n");
        results.push_back({{"position", *position}, {"value", *value}});
    }
    environment.document({{"file", options.input.file}, {"table", toJson(table)},
        {"outside", options.outside}, {"results", std::move(results)}});
    return ExitCode::Done;
}

} // namespace

void addLookupCommand(CommandLine& line)
{
    auto options = std::make_shared<LookupOptions>();
    options->input.command = commandName("lookup");
    CLI::App* command = line.add("lookup", fileCommands,
        "Print the interpolated value at a position, as the drive computes it",
        [options](Environment& environment) { return runLookup(environment, *options); });
    command->add_option("FILE", options->input.file, "Calibration file or table")->required();
    command
        ->add_option(
            "POSITION", options->position, "X [Y [Z]], one number per dimension; may be negative")
        ->option_text("[X [Y [Z]]]")
        ->expected(1, 3);
    addDimensionsOption(*command, options->input);
    addTableOption(*command, options->input);
    command
        ->add_option("--points", options->points,
            "File with one position per line (- for standard input): one result line each")
        ->option_text("FILE");
    command
        ->add_option("--outside", options->outside,
            "Outside of the table: hold (as the drive does; the default), zero, wrap, extrapolate "
            "or error")
        ->option_text("RULE")
        ->check(CLI::IsMember(
            std::vector<std::string>{"hold", "zero", "wrap", "extrapolate", "error"}));
    addFromOption(*command, options->input);
    addProfileOption(*command, options->input.profile);
    command->footer("Examples:\n"
                    "  axiscomp lookup x.csv -12.5 --dims 1\n"
                    "  axiscomp lookup plane.TAMtbl --points positions.txt --outside error");
}

} // namespace axiscomp::app
