// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/capture/number_pattern.h"

#include "core/text/utf8.h"

#include <QRegularExpression>

namespace axiscomp::drivecomm {

Result<NumberFinder> numberPattern(const std::string& pattern)
{
    if (pattern.empty())
        return NumberFinder();
    const QRegularExpression expression(QString::fromStdString(pattern));
    if (!expression.isValid()) {
        constexpr std::size_t mostShown = 60;
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the pattern {pattern} is no regular expression: {problem} at character "
                    "{place}")
                    .with("pattern", '"' + shownText(pattern, mostShown) + '"')
                    .with("problem", expression.errorString().toStdString())
                    .with(
                        "place", static_cast<std::int64_t>(expression.patternErrorOffset() + 1))}});
    }
    return NumberFinder([expression](std::string_view line) {
        const auto match =
            expression.match(QString::fromUtf8(line.data(), static_cast<qsizetype>(line.size())));
        if (!match.hasMatch())
            return std::string();
        return match.captured(expression.captureCount() > 0 ? 1 : 0).trimmed().toStdString();
    });
}

} // namespace axiscomp::drivecomm
