// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/report_text.h"

#include "core/text/utf8.h"

#include <array>
#include <charconv>

namespace axiscomp::report {

FineUnit fineUnit(bool isAngular)
{
    return isAngular ? FineUnit{3600.0, "″", "°"} : FineUnit{1000.0, "µm", "mm"};
}

std::string fixedDigits(double value, int decimals)
{
    std::array<char, 400> buffer{}; // the largest double has 309 digits
    const auto end = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    std::string digits(buffer.data(), end.ptr);
    if (digits.starts_with('-') && digits.find_first_of("123456789") == std::string::npos)
        digits.erase(0, 1);
    return digits;
}

Text numberText(double value, int decimals)
{
    return quantityText(fixedDigits(value, decimals), "");
}

Text quantityText(const std::string& digits, const char* unit)
{
    return Text({"", "{number}", nullptr}, {{"number", Quantity{digits, unit}}});
}

Text notStated()
{
    return AXISCOMP_TEXT("Report", "not stated");
}

Text statedText(const std::string& text)
{
    constexpr std::size_t mostBytes = 160;
    const std::string shown = shownText(text, mostBytes);
    return shown.find_first_not_of(' ') == std::string::npos ? notStated() : Text(Verbatim{shown});
}

} // namespace axiscomp::report
