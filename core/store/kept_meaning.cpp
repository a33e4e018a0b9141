// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/kept_meaning.h"

#include "core/table/target_axis.h"

namespace axiscomp {

MeaningChange changedMeaning(const KeptMeaning& kept, const KeptMeaning& now)
{
    return {areDifferentAxes(kept.axisName, now.axisName), changedUnit(kept.units, now.units)};
}

bool isMeantAsKept(const KeptMeaning& kept, const KeptMeaning& now)
{
    const MeaningChange change = changedMeaning(kept, now);
    return !change.isOtherAxis && !change.unit;
}

} // namespace axiscomp
