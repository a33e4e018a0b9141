// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/softmc/softmc_targets.h"

namespace axiscomp::softmc {

void remarkTargets(const NeutralTable& table, std::vector<Text>& remarks)
{
    std::vector<Text> targets;
    bool isInOrder = true;
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        const CompensationColumn& column = table.columns[n];
        auto target = targetText(table, column);
        if (!target)
            return;
        isInOrder = isInOrder && ownAxis(table, column) == n;
        targets.push_back(*std::move(target));
    }
    if (!isInOrder)
        remarks.push_back(AXISCOMP_TEXT("Error",
            "the program must define the target axes of the table in the order of the corrections: "
            "{axes}")
                              .with("axes", std::move(targets)));
}

} // namespace axiscomp::softmc
