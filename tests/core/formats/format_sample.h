// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/formats/format_checks.h"

#include <utility>
#include <vector>

namespace axiscomp::test {

/// What the contract of all formats has to know of one: a file of it, tables that it holds, and
/// what is said of files and tables that it refuses. Where a row has settings, they count instead
/// of the sample's.
struct FormatSample {
    using Settings = std::optional<FormatSettings>;
    using Lines = std::vector<std::string>; ///< beginnings or parts of lines

    struct Problem { ///< a file without a table
        std::string name;
        std::string text;
        std::string line; ///< the beginning of the first one in problemLines()
        std::string controllerError;
        Settings settings;
    };
    struct Warning { ///< a file that is read all the same
        std::string name;
        std::string text;
        Lines lines; ///< the beginning of each one in problemLines(), without "warning "
        Settings settings;
    };
    struct Applied {
        std::vector<double> position;
        double value;
        std::size_t column = 0;
        std::string text = {}; ///< empty: the sample's
    };
    struct Written {
        std::string name;
        std::vector<NeutralTable> tables;
        double allowance = 0.0; ///< of values; above 1e-9 they must be rounded
        double allowanceOfPositions = 0.0;
        Settings writing = {};
        Settings reading = {};
        std::string bytes = {}; ///< the whole file
        Lines parts = {}; ///< of the file
        Lines remarks = {}; ///< parts of the remarks
        std::vector<NeutralTable> becomes = {}; ///< what is held, where it is not `tables`

        Written& within(double values, double positions)
        {
            return allowance = values, allowanceOfPositions = positions, *this;
        }
        Written& within(double difference) { return within(difference, difference); }
        Written& with(FormatSettings settings) { return writing = std::move(settings), *this; }
        Written& readWith(FormatSettings settings) { return reading = std::move(settings), *this; }
        Written& as(std::string file) { return bytes = std::move(file), *this; }
        Written& containing(Lines lines) { return parts = std::move(lines), *this; }
        Written& remarking(Lines lines) { return remarks = std::move(lines), *this; }
        Written& becoming(NeutralTable table) { return becomes = {std::move(table)}, *this; }
    };
    struct Refused { ///< tables that are not written
        std::string name;
        std::vector<NeutralTable> tables;
        ErrorCode code;
        std::string reason; ///< a part of the sentence
        Settings settings;
    };

    const TableFormat* format = nullptr;
    std::string facts; ///< factsText() of it
    TableReadOptions reading = {};
    TableWriteOptions writing = {};
    std::string text = {}; ///< a file with nothing to complain of; empty: the format cannot be read
    std::string comment = {}; ///< how a line begins that says nothing; empty: there is none
    std::size_t spareBytes = 0; ///< at the end of the text, which nobody misses
    std::size_t warnedBytes = 0; ///< before these, whose lack may be a warning and no error
    bool isOnlyNamed = false; ///< no content is taken for it: a person names the format
    std::vector<std::pair<std::string, Recognition>> recognised = {};
    std::vector<Applied> applied = {};
    std::vector<Problem> problems = {};
    std::vector<Warning> warnings = {};
    std::vector<Problem> refusedSettings = {}; ///< of reading; line: a part of the sentence
    std::vector<Written> written = {}; ///< empty: the format cannot be written
    std::vector<Refused> refused = {};

    void recognises(Recognition recognition, const std::vector<std::string>& files)
    {
        for (const std::string& file : files)
            recognised.emplace_back(file, recognition);
    }
    /// Of the first table of the file: what the controller makes of it at these positions.
    void applies(std::vector<Applied> values, const std::string& file = {})
    {
        for (Applied& value : values) {
            value.text = file;
            applied.push_back(std::move(value));
        }
    }
    void problem(std::string name, std::string file, std::string line,
        std::string controllerError = {}, Settings settings = {})
    {
        problems.push_back({std::move(name), std::move(file), std::move(line),
            std::move(controllerError), std::move(settings)});
    }
    /// problem() for a list of rows.
    auto problemRow()
    {
        return [this](auto... cells) { problem(std::move(cells)...); };
    }
    void warning(std::string name, std::string file, Lines lines, Settings settings = {})
    {
        warnings.push_back(
            {std::move(name), std::move(file), std::move(lines), std::move(settings)});
    }
    void refusesReading(std::string name, FormatSettings settings, std::string reason)
    {
        refusedSettings.push_back(
            {std::move(name), text, std::move(reason), {}, std::move(settings)});
    }
    Written& writes(std::string name, std::vector<NeutralTable> tables)
    {
        return written.emplace_back(Written{std::move(name), std::move(tables)});
    }
    void refuses(std::string name, std::vector<NeutralTable> tables, ErrorCode code,
        std::string reason = {}, Settings settings = {})
    {
        refused.push_back(
            {std::move(name), std::move(tables), code, std::move(reason), std::move(settings)});
    }
};

using DescribeFormat = void (*)(FormatSample&);
inline std::vector<std::pair<const TableFormat*, DescribeFormat>>& describedFormats()
{
    static std::vector<std::pair<const TableFormat*, DescribeFormat>> formats;
    return formats;
}
inline bool addFormat(const TableFormat& format, DescribeFormat describe)
{
    describedFormats().emplace_back(&format, describe);
    return true;
}

} // namespace axiscomp::test

/// Has the contract of all formats run over this one; describe: a function that fills its sample.
#define AXISCOMP_FORMAT(format, describe)                                                          \
    [[maybe_unused]] const bool isAddedBy_##describe = axiscomp::test::addFormat(format, describe);
