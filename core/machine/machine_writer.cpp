// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/machine_file.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <string_view>

namespace axiscomp {

namespace {

/// A basic string of TOML: every control character as an escape.
std::string quotedText(std::string_view text)
{
    static constexpr std::string_view digits = "0123456789abcdef";
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            result.append({'\\', c});
        else if (byte < 0x20 || byte == 0x7f)
            result.append("\\u00").append({digits[byte >> 4U], digits[byte & 15U]});
        else
            result += c;
    }
    return result + '"';
}

bool isBareKey(std::string_view key)
{
    return !key.empty() && std::ranges::all_of(key, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')
            || c == '-' || c == '_';
    });
}

class Lines {
public:
    void text(std::string_view key, const std::string& value)
    {
        if (!value.empty())
            raw(key, quotedText(value));
    }
    void flag(std::string_view key, bool value) { raw(key, value ? "true" : "false"); }
    void raw(std::string_view key, const std::string& value)
    {
        m_text.append(key).append(" = ").append(value) += '\n';
    }
    void head(std::string_view section) { m_text.append("\n[[").append(section) += "]]\n"; }
    [[nodiscard]] std::string take() { return std::move(m_text); }

private:
    std::string m_text;
};

std::string listText(const std::vector<std::string>& texts)
{
    std::string list = "[";
    for (const std::string& text : texts)
        list += (list.size() == 1 ? "" : ", ") + quotedText(text);
    return list + "]";
}

std::string settingsText(const FormatSettings& settings)
{
    std::string text;
    for (const auto& [key, value] : settings)
        text += (text.empty() ? "{ " : ", ") + (isBareKey(key) ? key : quotedText(key)) + " = "
            + quotedText(value);
    return text + " }";
}

void writeChoices(Lines& lines, const ImportChoices& choices)
{
    if (choices.format)
        lines.text("format", std::string(choices.format->facts.name));
    if (!choices.settings.empty())
        lines.raw("settings", settingsText(choices.settings));
    lines.text("target", choices.target);
    if (choices.sign)
        lines.text("sign", *choices.sign == SignConvention::Feedback ? "feedback" : "command");
    if (choices.direction)
        lines.text("direction",
            *choices.direction == DirectionChoice::Mean           ? "mean"
                : *choices.direction == DirectionChoice::Positive ? "positive"
                                                                  : "negative");
    if (choices.dropsWrap)
        lines.flag("no-wrap", true);
}

void writeAxis(Lines& lines, const MachineAxis& axis)
{
    lines.head("drive.axis");
    lines.text("axis", axis.axis);
    if (axis.file.empty())
        lines.flag("no-table", true);
    lines.text("file", axis.file);
    lines.text("column", axis.column);
    if (axis.sources)
        lines.raw("sources", listText(*axis.sources));
    writeChoices(lines, axis.choices);
    lines.text("value-unit", axis.choices.units.values);
    lines.text("position-unit", axis.choices.units.positions);
    if (!axis.file.empty())
        lines.flag("persistent", axis.persistency == Persistency::Persistent);
    lines.text("slot", axis.slot);
    if (axis.isActive)
        lines.flag("active", *axis.isActive);
    if (axis.tolerance)
        lines.text("tolerance", toText(axis.tolerance->value) + ' ' + axis.tolerance->unit);
    if (axis.acceptsLarge)
        lines.flag("accept-large", true);
}

} // namespace

std::string writeMachine(const MachineFile& machine)
{
    Lines lines;
    lines.raw("version", "1");
    lines.text("name", machine.name);
    for (const MachineDrive& drive : machine.drives) {
        lines.head("drive");
        lines.text("endpoint", drive.endpoint);
        lines.raw("serial", std::to_string(drive.serialNumber));
        for (const MachineAxis& axis : drive.axes)
            writeAxis(lines, axis);
    }
    return lines.take();
}

} // namespace axiscomp
