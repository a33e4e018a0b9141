// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/pages.h"

#include "drivecomm/http/percent_encoding.h"
#include "drivecomm/virtualdrive/web/html.h"

namespace axiscomp::drivecomm {

namespace {

std::string fileLink(const DriveProfile& profile, const std::string& file)
{
    return link(profile.web.files + percentEncoded(file), file);
}

std::string numberCell(std::uint32_t number)
{
    return "<td class=\"number\">" + std::to_string(number) + "</td>";
}

/// What one looks at and sets to compensate an axis, in the order of the work.
std::string compensationLink(const DriveProfile& profile, int axis, const std::string& text)
{
    const RegisterPaths& registers = profile.registers;
    std::vector<std::string> paths;
    const auto add = [&](const std::string& pattern, std::optional<int> n = {}) {
        if (!pattern.empty())
            paths.push_back(expandPath(pattern, {axis, {}, n}));
    };
    add(registers.table);
    for (int n = 1; n <= 3; ++n)
        add(registers.source, n);
    add(registers.activation);
    add(registers.state);
    add(registers.error);
    add(registers.output);
    for (int n = 1; n <= 3; ++n)
        add(registers.index, n);
    add(registers.homingState);
    add(registers.positionUnit);
    add(registers.coggingTable);
    return link(registersLink(profile, paths), text);
}

/// "Application/Tables/Small1"
std::string slotFolder(const DriveProfile& profile, const std::string& slot)
{
    const std::string command = expandPath(profile.registers.tableCommand, {{}, slot, {}});
    return command.substr(0, command.rfind('/'));
}

} // namespace

std::string registersLink(const DriveProfile& profile, std::span<const std::string> paths)
{
    std::string target = profile.web.registers;
    for (const std::string& path : paths) {
        target += target.size() == profile.web.registers.size() ? "?path=" : "&path=";
        target += percentEncoded(path);
    }
    return target;
}

std::string treeLink(const DriveProfile& profile, std::string_view prefix)
{
    return profile.web.registers + "?prefix=" + percentEncoded(prefix);
}

std::string startPage(const PageFrame& frame, const DriveProfile& profile, const StartPage& start)
{
    std::string html = "<p>Serial number " + escaped(frame.serialNumber) + ", drive error "
        + escaped(start.driveError) + ".</p>\n<h2>Files</h2>\n<ul>\n";
    html += "<li>" + link(profile.web.directory, "Directory") + ": the table files\n";
    html +=
        "<li>" + link(profile.web.transfer, "Transfer") + ": put a file into the drive\n</ul>\n";
    html += "<h2>Axes</h2>\n<ul>\n";
    for (std::size_t i = 0; i < start.axisNames.size(); ++i) {
        const std::string name = start.axisNames[i].empty() ? "" : " (" + start.axisNames[i] + ")";
        html += "<li>"
            + compensationLink(
                profile, static_cast<int>(i), "Compensation of axis " + std::to_string(i) + name)
            + ": table, sources, activation, output\n";
    }
    html += "</ul>\n<h2>Tables</h2>\n<ul>\n";
    for (const TableSlot& slot : profile.tableSlots)
        html += "<li>" + link(treeLink(profile, slotFolder(profile, slot.name)), slot.name)
            + ": make persistent, commit, delete\n";
    html += "</ul>\n<h2>Drive</h2>\n<ul>\n";
    const std::vector<std::string> commands{
        profile.registers.saveParameters, profile.registers.reboot, profile.registers.driveError};
    html += "<li>" + link(registersLink(profile, commands), "Save parameters, reboot") + "\n";
    html += "<li>" + link(treeLink(profile, ""), "All registers") + "\n</ul>\n";
    return page(frame, frame.driveName, html);
}

std::string directoryPage(
    const PageFrame& frame, const DriveProfile& profile, std::span<const DriveFile> files)
{
    std::string html =
        "<table>\n<thead><tr><th scope=\"col\">File</th>"
        "<th scope=\"col\" class=\"number\">actual size</th>"
        "<th scope=\"col\" class=\"number\">maximum size</th></tr></thead>\n<tbody>\n";
    for (const DriveFile& file : files)
        html += "<tr><td>" + fileLink(profile, file.path) + "</td>" + numberCell(file.size)
            + numberCell(file.maximumSize) + "</tr>\n";
    html += "</tbody>\n</table>\n<p class=\"note\">Sizes in bytes; 0 is an empty file.</p>\n";
    return page(frame, "Directory", html);
}

std::string transferPage(
    const PageFrame& frame, const DriveProfile& profile, std::span<const DriveFile> files)
{
    std::string html = "<form method=\"post\" action=\"" + escaped(profile.web.transfer)
        + "\" enctype=\"multipart/form-data\">\n";
    html += "<label for=\"filepath\">Filepath in drive</label>\n<input id=\"filepath\" name=\""
        + escaped(profile.web.transferPathField)
        + "\" list=\"files\" required autocomplete=\"off\" spellcheck=\"false\">\n"
          "<datalist id=\"files\">\n";
    for (const DriveFile& file : files)
        html += "<option value=\"" + escaped(file.path) + "\">up to "
            + std::to_string(file.maximumSize) + " bytes</option>\n";
    html += "</datalist>\n<label for=\"file\">Select from PC</label>\n"
            "<input id=\"file\" type=\"file\" name=\""
        + escaped(profile.web.transferFileField)
        + "\" required>\n<div><button type=\"submit\">Start</button></div>\n</form>\n";
    return page(frame, "Transfer", html);
}

std::string transferDonePage(
    const PageFrame& frame, const DriveProfile& profile, const DriveFile& file)
{
    const std::string html = "<p role=\"status\">" + fileLink(profile, file.path) + " now has "
        + std::to_string(file.size) + " bytes.</p>\n<p>" + link(profile.web.directory, "Directory")
        + " &middot; " + link(profile.web.transfer, "Transfer another file") + "</p>\n";
    return page(frame, "Transfer done", html);
}

std::string errorPage(const PageFrame& frame, std::string_view message, std::string_view backLink)
{
    const std::string html = "<p class=\"error\" role=\"alert\">" + escaped(message) + "</p>\n<p>"
        + link(backLink, "Back") + "</p>\n";
    return page(frame, "The drive did not do this", html);
}

} // namespace axiscomp::drivecomm
