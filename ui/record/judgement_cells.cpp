// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/judgement_cells.h"

#include "ui/text/translated_text.h"

namespace axiscomp::ui {

QString noFigure()
{
    return QStringLiteral("–");
}

QString shownOrNothing(const FineUnit& unit, const std::optional<double>& value, int decimals)
{
    return value ? FineScale(unit).text(*value, decimals) : noFigure();
}

QString aloneOrNothing(const std::optional<double>& value, bool isAngular)
{
    return value ? fineText(*value, isAngular) : noFigure();
}

QString directionText(Approach direction)
{
    return (direction == Approach::Up ? QStringLiteral("↑ ") : QStringLiteral("↓ "))
        + translated(approachText(direction));
}

Tone toneOf(VerdictResult result)
{
    switch (result) {
    case VerdictResult::Passed:
        return Tone::Success;
    case VerdictResult::Failed:
        return Tone::Error;
    case VerdictResult::Undecided:
    case VerdictResult::NotDefined:
        break;
    }
    return Tone::Warning;
}

} // namespace axiscomp::ui
