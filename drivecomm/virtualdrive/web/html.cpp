// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/html.h"

namespace axiscomp::drivecomm {

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --line: #8886; --soft: #8881; --accent: #0b5fad; }
@media (prefers-color-scheme: dark) { :root { --accent: #7ab8f5; } }
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 64rem; margin: 0 auto; padding: 0 1rem 3rem; }
header { display: flex; flex-wrap: wrap; gap: .25rem 1.5rem; align-items: baseline;
  border-bottom: 1px solid var(--line); padding: .75rem 0; }
header strong { font-size: 1.1rem; }
header nav { display: flex; flex-wrap: wrap; gap: 1rem; margin-left: auto; }
a { color: var(--accent); }
h1 { font-size: 1.5rem; margin: 1.25rem 0 .75rem; }
h2 { font-size: 1.15rem; margin: 1.5rem 0 .5rem; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: baseline; padding: .3rem .75rem .3rem 0;
  border-bottom: 1px solid var(--line); overflow-wrap: break-word; }
th.number, td.number { text-align: right; font-variant-numeric: tabular-nums; }
td.value { font-family: ui-monospace, monospace; }
label { display: block; margin: .75rem 0 .25rem; }
input, select, button { font: inherit; padding: .35rem .5rem; box-sizing: border-box;
  max-width: 100%; }
td input, td select { width: 100%; min-width: 9rem; }
label + input { width: 24rem; }
button { margin-top: 1rem; padding: .4rem 1.5rem; cursor: pointer; }
td form { display: flex; gap: .5rem; }
td button { margin: 0; white-space: nowrap; }
main nav { margin-bottom: .75rem; }
:focus-visible { outline: 3px solid var(--accent); outline-offset: 1px; }
.note { opacity: .8; }
.error { border-left: .3rem solid #c62828; padding: .5rem 1rem; background: var(--soft); }
)";

} // namespace

std::string escaped(std::string_view text)
{
    std::string result;
    result.reserve(text.size());
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        case '\'':
            result += "&#39;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

std::string breakable(std::string_view path)
{
    std::string result;
    for (std::size_t slash = path.find('/'); slash != std::string_view::npos;
         slash = path.find('/')) {
        result += escaped(path.substr(0, slash + 1)) + "<wbr>";
        path.remove_prefix(slash + 1);
    }
    return result + escaped(path);
}

std::string link(std::string_view target, std::string_view text)
{
    return "<a href=\"" + escaped(target) + "\">" + escaped(text) + "</a>";
}

std::string page(const PageFrame& frame, std::string_view heading, std::string_view content)
{
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    html += "<title>" + escaped(heading) + " - " + escaped(frame.driveName) + "</title>\n";
    html.append("<style>").append(style).append("</style>\n</head>\n<body>\n");
    html += "<header><strong>" + link("/", frame.driveName) + "</strong>\n<span>serial number "
        + escaped(frame.serialNumber) + "</span>\n<nav aria-label=\"Pages\">"
        + link(frame.directoryLink, "Directory") + ' ' + link(frame.transferLink, "Transfer") + ' '
        + link(frame.registersLink, "Registers") + "</nav></header>\n";
    html += "<main>\n<h1>" + escaped(heading) + "</h1>\n";
    return html.append(content).append("</main>\n</body>\n</html>\n");
}

} // namespace axiscomp::drivecomm
