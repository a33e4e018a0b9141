// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/report_text.h"

#include "core/metrology/fine_quantity.h"
#include "core/text/number_text.h"
#include "core/text/utf8.h"

namespace axiscomp::report {

const char* positionSymbol(bool isAngular)
{
    return isAngular ? "°" : "mm";
}

Text fineText(double value, bool isAngular)
{
    const std::optional<double> shown[] = {value};
    const FineUnit unit = fineUnit(shown, isAngular);
    return quantityText(unit.digits(value, figureDecimals), unit.symbol);
}

Text numberText(double value, int decimals)
{
    return quantityText(fixedDigits(value, decimals), "");
}

Text quantityText(const std::string& digits, const char* unit)
{
    return Text({"", "{number}", nullptr}, {{"number", Quantity{digits, unit}}});
}

Text deviationUnitText(
    const FineUnit& unit, const std::optional<PlacedDeviation>& datum, bool isAngular)
{
    const Text symbol = Verbatim{unit.symbol};
    return datum ? listText({symbol, datumText(*datum, isAngular)}) : symbol;
}

Text listText(std::vector<Text> items)
{
    return Text({"", "{items}", nullptr}, {{"items", std::move(items)}});
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
