// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"
#include "app/cli/table_formats.h"
#include "app/common/text_table.h"

namespace axiscomp::app {

namespace {

std::string holds(const TableFormatInfo& info)
{
    std::string text = info.severalTables ? "several tables" : "one table";
    text += info.holdsNames ? ", names of dimensions" : "";
    text += info.holdsUnits ? ", units" : "";
    text += info.holdsNotes ? ", notes" : "";
    text += info.holdsPersistency ? ", persistency" : "";
    return text;
}

Result<ExitCode> runFormats(Environment& environment)
{
    TextTable table({"name", "extension", "dimensions", "values", "holds", "what it is"});
    Json list = Json::array();
    for (const TableFormatInfo& info : tableFormats()) {
        table.add({std::string(info.name), std::string(info.extension), "1 to 3",
            std::string(info.numbers), holds(info), std::string(info.description)});
        list.push_back({{"name", info.name}, {"extension", info.extension},
            {"description", info.description}, {"reads", true}, {"writes", true},
            {"dimensions", {1, 2, 3}}, {"severalTables", info.severalTables},
            {"names", info.holdsNames}, {"units", info.holdsUnits}, {"notes", info.holdsNotes},
            {"persistency", info.holdsPersistency}, {"values", info.numbers}});
    }
    environment.print(table.text(""));
    environment.document({{"formats", std::move(list)}});
    return ExitCode::Done;
}

} // namespace

void addFormatsCommand(CommandLine& line)
{
    line.add("formats", fileCommands, "List the table formats and what each can hold", runFormats);
}

} // namespace axiscomp::app
