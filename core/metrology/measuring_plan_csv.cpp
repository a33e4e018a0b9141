// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/measuring_plan.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <charconv>
#include <cmath>
#include <set>
#include <tuple>

namespace axiscomp {

namespace {

std::string_view planUnit(const MeasuringPlan& plan)
{
    return plan.isAngular ? "deg" : "mm";
}

std::string planColumns(std::string_view unit)
{
    const std::string inUnit = " [" + std::string(unit) + "]";
    return "step,run,direction,target" + inUnit + ",approach" + inUnit;
}

class PlanReader {
public:
    PlanReader(std::string_view text, const std::string& fileName)
        : m_lines(text)
        , m_fileName(fileName)
    {
    }

    Result<MeasuringPlan> read()
    {
        bool hasHeader = false;
        while (const auto line = m_lines.next()) {
            const Token content = trimmedToken(*line);
            if (!content)
                continue;
            if (content.text.starts_with("//"))
                takeComment(content);
            else if (!hasHeader)
                hasHeader = takeHeader(content);
            else
                takeStep(content);
            if (!m_problem.isEmpty())
                return problem();
        }
        if (m_plan.steps.empty())
            complain(0, AXISCOMP_TEXT("Error", "there is no step in it"),
                AXISCOMP_TEXT("Error", "a plan as axiscomp targets writes it"));
        if (!m_problem.isEmpty())
            return problem();
        return std::move(m_plan);
    }

private:
    tl::unexpected<Error> problem()
    {
        return fail(
            ErrorCode::FileNotReadable, {{"file", m_fileName}, {"reason", std::move(m_problem)}});
    }
    void complain(std::size_t line, Text found, Text expected)
    {
        if (!m_problem.isEmpty())
            return;
        m_problem =
            (line == 0 ? AXISCOMP_TEXT("Error", "{found}; expected: {expected}")
                       : AXISCOMP_TEXT("Error", "line {line}: {found}; expected: {expected}"))
                .with("line", line)
                .with("found", std::move(found))
                .with("expected", std::move(expected));
    }
    void complain(const Token& token, Text expected)
    {
        constexpr std::size_t mostShown = 40;
        complain(token.line, Verbatim{'"' + shownText(token.text, mostShown) + '"'},
            std::move(expected));
    }

    void takeComment(const Token& comment)
    {
        const std::string_view text = comment.text.substr(2);
        const std::size_t colon = text.find(':');
        if (colon == std::string_view::npos)
            return;
        const Token key = trimmedToken({text.substr(0, colon), comment.line, 1});
        const Token value = trimmedToken({text.substr(colon + 1), comment.line, 1});
        if (key.text == "axiscomp plan" && value.text != "1")
            complain(value,
                AXISCOMP_TEXT(
                    "Error", "version 1; a newer version of this program may have written it"));
        else if (key.text == "axis")
            m_plan.axis = value.text;
        else if (key.text == "overrun")
            m_plan.overrun = amount(value);
        else if (key.text == "feed")
            m_plan.feedPerMinute = amount(value);
        else if (key.text == "dwell")
            m_plan.dwellSeconds = amount(value);
        else if (key.text == "period")
            m_plan.period = amount(value);
        else if (key.text == "seed")
            takeSeed(value);
    }
    /// "5 s": the number; the unit is the only one that a plan has.
    double amount(const Token& value)
    {
        const auto number = numberOf(value.text.substr(0, value.text.find(' ')));
        if (!number || !(*number > 0.0 && *number <= largestPlanPosition)) {
            complain(value, AXISCOMP_TEXT("Error", "a number above 0 with its unit"));
            return 0.0;
        }
        return *number;
    }
    void takeSeed(const Token& value)
    {
        const char* const last = value.text.data() + value.text.size();
        const auto [end, error] = std::from_chars(value.text.data(), last, m_plan.seed);
        if (error != std::errc{} || end != last)
            complain(value, AXISCOMP_TEXT("Error", "a whole number"));
    }

    bool takeHeader(const Token& line)
    {
        for (const bool isAngular : {false, true}) {
            if (line.text != planColumns(isAngular ? "deg" : "mm"))
                continue;
            m_plan.isAngular = isAngular;
            return true;
        }
        complain(line,
            AXISCOMP_TEXT("Error", "the header {header}")
                .with("header", Verbatim{planColumns("mm")}));
        return false;
    }

    void takeStep(const Token& line)
    {
        constexpr std::size_t columns = 5;
        std::vector<Token> cells;
        splitCells(line, ',', cells);
        if (cells.size() != columns) {
            complain(line, AXISCOMP_TEXT("Error", "five cells, as the header has"));
            return;
        }
        if (m_plan.steps.size() == mostPlanSteps) {
            complain(
                line, AXISCOMP_TEXT("Error", "at most {count} steps").with("count", mostPlanSteps));
            return;
        }
        MeasuringStep step;
        const int next = static_cast<int>(m_plan.steps.size()) + 1;
        if (wholeNumberOf(cells[0].text) != next)
            complain(cells[0], AXISCOMP_TEXT("Error", "step {step}").with("step", next));
        const auto run = wholeNumberOf(cells[1].text);
        if (!run || *run < 1 || *run > static_cast<std::int64_t>(mostPlanSteps))
            complain(cells[1], AXISCOMP_TEXT("Error", "the number of a run, from 1"));
        if (cells[2].text != "+" && cells[2].text != "-")
            complain(cells[2], AXISCOMP_TEXT("Error", "the direction + or -"));
        step.step = next;
        step.run = static_cast<int>(run.value_or(1));
        step.direction = cells[2].text == "-" ? Approach::Down : Approach::Up;
        step.target = position(cells[3]);
        step.approach = position(cells[4]);
        checkStep(step, cells);
        m_plan.steps.push_back(step);
    }
    double position(const Token& cell)
    {
        const auto number = numberOf(cell.text);
        if (!number || std::abs(*number) > largestPlanPosition) {
            complain(cell, AXISCOMP_TEXT("Error", "a position"));
            return 0.0;
        }
        return *number;
    }
    void checkStep(const MeasuringStep& step, const std::vector<Token>& cells)
    {
        const bool comesFromBelow = step.approach < step.target;
        if (step.approach == step.target || comesFromBelow != (step.direction == Approach::Up))
            complain(cells[4],
                step.direction == Approach::Up
                    ? AXISCOMP_TEXT("Error", "a position below the target, since the axis moves up")
                    : AXISCOMP_TEXT(
                        "Error", "a position above the target, since the axis moves down"));
        if (!m_seen.emplace(step.direction, step.run, step.target).second)
            complain(cells[3],
                AXISCOMP_TEXT("Error", "each target once in a run; it has this one already"));
    }

    TextLines m_lines;
    const std::string& m_fileName;
    MeasuringPlan m_plan;
    std::set<std::tuple<Approach, int, double>> m_seen;
    Text m_problem;
};

} // namespace

std::string measuringPlanCsv(const MeasuringPlan& plan)
{
    const std::string unit(planUnit(plan));
    std::string text = "// axiscomp plan: 1\n";
    text += "// axis: " + plan.axis + "\n";
    text += "// overrun: " + planPosition(plan.overrun) + " " + unit + "\n";
    text += "// feed: " + toText(plan.feedPerMinute) + " " + unit + "/min\n";
    text += "// dwell: " + toText(plan.dwellSeconds) + " s\n";
    if (plan.period)
        text += "// period: " + toText(*plan.period) + " " + unit + "\n";
    text += "// seed: " + std::to_string(plan.seed) + "\n";
    text += planColumns(unit) + "\n";
    for (const MeasuringStep& step : plan.steps) {
        text += std::to_string(step.step) + "," + std::to_string(step.run);
        text += step.direction == Approach::Up ? ",+," : ",-,";
        text += planPosition(step.target) + "," + planPosition(step.approach) + "\n";
    }
    return text;
}

Result<MeasuringPlan> readMeasuringPlan(std::string_view text, const std::string& fileName)
{
    return PlanReader(text, fileName).read();
}

} // namespace axiscomp
