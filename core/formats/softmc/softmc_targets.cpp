// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/softmc/softmc_targets.h"

#include "core/table/target_axis.h"

namespace axiscomp::softmc {

void remarkTargets(const NeutralTable& table, std::vector<Text>& remarks)
{
    std::vector<Text> targets;
    bool isInOrder = true;
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        const CompensationColumn& column = table.columns[n];
        const auto target = targetOf(table, column);
        if (!target)
            return;
        isInOrder = isInOrder && target->source == n;
        if (target->source)
            targets.push_back(axisText(table, *target->source));
        else if (column.target == otherAxis)
            targets.push_back(AXISCOMP_TEXT("Error", "another axis"));
        else
            targets.push_back(Text(Verbatim{column.target}));
    }
    if (!isInOrder)
        remarks.push_back(AXISCOMP_TEXT("Error",
            "the program must define the target axes of the table in the order of the corrections: "
            "{axes}")
                              .with("axes", std::move(targets)));
}

} // namespace axiscomp::softmc
