// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input/point_file.h"

#include "app/cli/input/table_input.h"
#include "app/common/number_text.h"
#include "app/common/standard_streams.h"
#include "core/text/text_file.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

constexpr std::string_view separators = " \t,;";
constexpr std::size_t longestLine = 64 * 1024;

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

/// Answers the lines of a file of positions, each as soon as it has come.
class PointFile {
public:
    PointFile(Environment& environment, const TableEvaluation& evaluation, const std::string& file)
        : m_environment(environment)
        , m_name(displayName(file))
        , m_evaluation(evaluation)
    {
    }

    Result<void> answer(const std::string& file, Json& results)
    {
        if (file == standardStream)
            return answerAll(InputStream::standardInput(), results);
        AXISCOMP_TRY(auto input, InputStream::open(file));
        return answerAll(std::move(input), results);
    }

private:
    Result<void> answerAll(InputStream input, Json& results)
    {
        std::string text;
        while (true) {
            AXISCOMP_TRY(const auto more, input.readMore(m_environment.interrupt(), text));
            if (!more && !text.empty())
                text.push_back('\n');
            if (auto answered = answerLines(text, results); !answered)
                return answered;
            if (!more || m_environment.console().readerGone())
                return {};
            if (text.size() > longestLine) {
                ++m_line;
                return wrong(1, "a line with a position", "more than 65536 characters");
            }
        }
    }

    /// Takes the complete lines out of text. They end with LF, CRLF or CR.
    Result<void> answerLines(std::string& text, Json& results)
    {
        std::size_t begin = 0;
        std::size_t end = 0;
        while ((end = text.find_first_of("\r\n", begin)) != std::string::npos) {
            const bool isRestOfCrlf = m_endedByCr && end == begin && text[end] == '\n';
            m_endedByCr = text[end] == '\r';
            if (!isRestOfCrlf) {
                ++m_line;
                AXISCOMP_CHECK(answerLine(
                    withoutMark(std::string_view(text).substr(begin, end - begin)), results));
            }
            begin = end + 1;
        }
        text.erase(0, begin);
        return m_environment.console().flush();
    }

    /// A byte-order mark may stand before the first line.
    [[nodiscard]] std::string_view withoutMark(std::string_view line) const
    {
        constexpr std::string_view mark = "\xEF\xBB\xBF";
        return m_line == 1 && line.starts_with(mark) ? line.substr(mark.size()) : line;
    }

    Result<void> answerLine(std::string_view line, Json& results)
    {
        if (m_line == 1 && isUtf16(line))
            return wrong(1, "UTF-8 text", "UTF-16 text");
        const std::vector<Field> fields = splitFields(line);
        if (fields.size() != m_evaluation.dimensions)
            return wrong(1, plural(m_evaluation.dimensions, "number", "numbers"),
                std::to_string(fields.size()));
        std::vector<double> position;
        for (const Field& field : fields) {
            const auto number = numberFromText(field.text);
            if (!number)
                return wrong(field.column, "a number such as 0.5",
                    "\"" + std::string(field.text.substr(0, 40)) + "\"");
            position.push_back(*number);
        }
        const auto value = m_evaluation.at(position);
        if (!value)
            return wrong(1, "", sentence(value.error()));
        m_environment.print(floatText(*value) + "\n");
        if (m_environment.takesDocument())
            results.push_back({{"position", position}, {"value", *value}});
        return {};
    }

    Result<void> wrong(std::size_t column, const std::string& expected, const std::string& found)
    {
        const std::string what =
            expected.empty() ? found : "found " + found + ", expected " + expected;
        m_environment.diagnose(m_name, m_line, column, "InvalidPosition", what);
        return fail(ErrorCode::InvalidCalibration,
            {{"file", m_name}, {"count", 1}, {"positions", Verbatim{"yes"}}});
    }

    Environment& m_environment;
    std::string m_name;
    const TableEvaluation& m_evaluation;
    std::size_t m_line = 0;
    bool m_endedByCr = false;
};

} // namespace

Result<void> answerPointFile(Environment& environment, const TableEvaluation& evaluation,
    const std::string& file, Json& results)
{
    return PointFile(environment, evaluation, file).answer(file, results);
}

} // namespace axiscomp::app
