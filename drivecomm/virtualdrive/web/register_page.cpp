// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/register_page.h"

#include "core/drive/drive_link.h"
#include "drivecomm/virtualdrive/web/html.h"
#include "drivecomm/virtualdrive/web/pages.h"

#include <algorithm>

namespace axiscomp::drivecomm {

namespace {

constexpr std::string_view sourceList = "sources";

std::string shownValue(const RegisterRow& row)
{
    const std::string value = escaped(toText(row.reading.value));
    return row.sourcePath.empty() ? value : value + " = " + breakable(row.sourcePath);
}

std::string option(const std::string& value, const std::string& text)
{
    return "<option value=\"" + escaped(value) + "\">" + escaped(text) + "</option>";
}

/// Left as it is, a field changes nothing.
std::string entryField(const RegisterRow& row)
{
    const std::string attributes = " name=\"" + escaped(row.reading.path)
        + "\" aria-label=\"New value of " + escaped(row.reading.path) + "\"";
    const std::vector<std::string> booleans{"true", "false"};
    const auto& names = row.reading.type == "Boolean" ? booleans : row.names;
    if (!names.empty()) {
        std::string html = "<select" + attributes + ">" + option("", "unchanged");
        for (const std::string& name : names)
            html += option(name, name);
        return html + "</select>";
    }
    const std::string suggestions =
        row.isSource ? " list=\"" + std::string(sourceList) + "\"" : std::string();
    return "<input" + attributes + suggestions + " autocomplete=\"off\" spellcheck=\"false\">";
}

std::string formStart(const DriveProfile& profile)
{
    return "<form method=\"post\" action=\"" + escaped(profile.web.registers) + "\">\n";
}

/// shownFrom: how much of the path the heading says already.
std::string registerTable(const DriveProfile& profile, std::span<const RegisterRow> rows,
    std::span<const std::string> sources, std::size_t shownFrom)
{
    if (rows.empty())
        return {};
    const auto writable = std::ranges::count(rows, true, &RegisterRow::isWritable);
    const bool oneForm = writable <= static_cast<std::ptrdiff_t>(DriveLink::maximumWrites);
    std::string html;
    if (writable > 0 && oneForm)
        html += formStart(profile);
    html += "<table>\n<thead><tr><th scope=\"col\">Register</th><th scope=\"col\">Type</th>"
            "<th scope=\"col\">Value</th>";
    html += writable > 0 ? "<th scope=\"col\">New value</th></tr></thead>\n<tbody>\n"
                         : "</tr></thead>\n<tbody>\n";
    for (const RegisterRow& row : rows) {
        const std::string path = row.reading.path;
        html += "<tr><td title=\"address " + std::to_string(row.reading.address) + "\">"
            + breakable(path.substr(std::min(shownFrom, path.size()))) + "</td><td>"
            + escaped(row.reading.type) + "</td><td class=\"value\">" + shownValue(row) + "</td>";
        if (row.isWritable && oneForm)
            html += "<td>" + entryField(row) + "</td>";
        else if (row.isWritable)
            html += "<td>" + formStart(profile) + entryField(row)
                + "<button type=\"submit\">Set</button></form></td>";
        else if (writable > 0)
            html += "<td></td>";
        html += "</tr>\n";
    }
    html += "</tbody>\n</table>\n";
    if (std::ranges::any_of(rows, &RegisterRow::isSource)) {
        html += "<datalist id=\"" + std::string(sourceList) + "\">" + option("0", "no source");
        for (const std::string& source : sources)
            html += option(source, source);
        html += "</datalist>\n";
    }
    if (writable > 0 && oneForm)
        html +=
            "<button type=\"submit\">Set</button>\n<p class=\"note\">All values that are filled "
            "in are set at one instant, or none of them.</p>\n</form>\n";
    return html;
}

/// "Axes[0]": what all paths have in common.
std::string commonFolder(std::span<const RegisterRow> rows)
{
    std::string_view common = rows.empty() ? std::string_view() : rows.front().reading.path;
    common = common.substr(0, common.rfind('/'));
    for (const RegisterRow& row : rows)
        while (!common.empty() && !row.reading.path.starts_with(std::string(common) + '/'))
            common = common.substr(
                0, common.rfind('/') == std::string_view::npos ? 0 : common.rfind('/'));
    return std::string(common);
}

/// Links to the folders above prefix.
std::string crumbs(const DriveProfile& profile, std::string_view prefix)
{
    std::string html =
        "<nav aria-label=\"Folders above\">" + link(treeLink(profile, ""), "Registers");
    for (std::size_t slash = prefix.find('/'), begin = 0; !prefix.empty();
         begin = slash + 1, slash = prefix.find('/', begin)) {
        html += " / "
            + link(treeLink(profile, prefix.substr(0, slash)), prefix.substr(begin, slash - begin));
        if (slash == std::string_view::npos)
            break;
    }
    return html + "</nav>\n";
}

} // namespace

std::string registerListPage(const PageFrame& frame, const DriveProfile& profile,
    std::span<const RegisterRow> rows, std::span<const std::string> sources)
{
    const std::string folder = commonFolder(rows);
    const std::string heading = folder.empty() ? "Registers" : "Registers of " + folder;
    return page(frame, heading, registerTable(profile, rows, sources, 0));
}

std::string registerTreePage(const PageFrame& frame, const DriveProfile& profile,
    std::string_view prefix, std::span<const std::string> folders,
    std::span<const RegisterRow> rows, std::span<const std::string> sources)
{
    std::string html = crumbs(profile, prefix);
    const std::size_t shownFrom = prefix.empty() ? 0 : prefix.size() + 1;
    if (!folders.empty()) {
        html += "<ul>\n";
        for (const std::string& folder : folders)
            html += "<li>" + link(treeLink(profile, folder), folder.substr(shownFrom)) + "\n";
        html += "</ul>\n";
    }
    // A register that is asked for by its full path keeps its name.
    const bool isLeaf = rows.size() == 1 && rows.front().reading.path == prefix;
    html += registerTable(profile, rows, sources, isLeaf ? 0 : shownFrom);
    return page(frame, prefix.empty() ? "Registers" : prefix, html);
}

std::string registersSetPage(
    const PageFrame& frame, std::span<const RegisterRow> rows, std::string_view backLink)
{
    std::string html = "<p role=\"status\">The drive has taken the values. They read back as:</p>\n"
                       "<table>\n<thead><tr><th scope=\"col\">Register</th>"
                       "<th scope=\"col\">Value</th></tr></thead>\n<tbody>\n";
    for (const RegisterRow& row : rows)
        html += "<tr><td>" + breakable(row.reading.path) + "</td><td class=\"value\">"
            + shownValue(row) + "</td></tr>\n";
    html += "</tbody>\n</table>\n<p>" + link(backLink, "Back") + "</p>\n";
    return page(frame, "Set", html);
}

} // namespace axiscomp::drivecomm
