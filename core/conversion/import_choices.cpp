// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/import_choices.h"

#include "core/conversion/resampling/resampling_errors.h"

#include <cmath>

namespace axiscomp {

namespace {

/// One request for each source axis.
Result<ResamplingRequest> gridRequest(const ResamplingChoice& choice, std::size_t dimensions)
{
    ResamplingRequest request;
    request.method = choice.method;
    request.holdsEnds = choice.holdsEnds;
    request.axes.resize(dimensions);
    for (std::size_t n = 0; n < dimensions; ++n) {
        const double number = choice.numbers[choice.numbers.size() == 1 ? 0 : n];
        constexpr double mostPoints = 4e6; // of a table; resample() looks at the product
        if (choice.kind == ResamplingChoice::Kind::Distance)
            request.axes[n].distance = number;
        else if (number < 2.0 || number > mostPoints || number != std::floor(number))
            return invalidArgument(
                AXISCOMP_TEXT("Error", "a number of points is a whole number, at least 2"));
        else
            request.axes[n].points = static_cast<std::size_t>(number);
    }
    return request;
}

} // namespace

std::vector<std::string> ImportChoices::targetsFor(const NeutralTable& table) const
{
    if (!target.empty())
        return {target};
    if (place.target.empty() || checkTargets(table))
        return {};
    return {place.target};
}

bool ImportChoices::isConversion() const
{
    return !target.empty() || sign || direction || dropsWrap
        || resampling.kind != ResamplingChoice::Kind::None;
}

Result<decltype(ConversionRequest::resampling)> resamplingRequest(
    const ResamplingChoice& choice, std::size_t dimensions)
{
    using Answer = decltype(ConversionRequest::resampling);
    if (choice.kind == ResamplingChoice::Kind::None)
        return Answer{};
    if (choice.numbers.empty())
        return invalidArgument(AXISCOMP_TEXT("Error", "the number for the even grid is missing"));
    if (choice.kind == ResamplingChoice::Kind::Within)
        return Answer{WantedDeviation{choice.numbers.front(), choice.method}};
    if (choice.numbers.size() != 1 && choice.numbers.size() != dimensions)
        return invalidArgument(AXISCOMP_TEXT(
            "Error", "the even grid needs one number, or one for each of the {count} source axes")
                                   .with("count", dimensions));
    AXISCOMP_TRY(auto request, gridRequest(choice, dimensions));
    return Answer{std::move(request)};
}

} // namespace axiscomp
