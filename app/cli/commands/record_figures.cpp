// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/record_figures.h"

#include "core/metrology/record/kept_figures.h"
#include "core/store/drive_store.h"

namespace axiscomp::app {

void keepFiguresOrWarn(Environment& environment, DriveStore& store, const CalibrationRecord& record,
    Measuring measuring)
{
    const auto kept = keepFigures(store, record, std::chrono::system_clock::now(), measuring);
    if (!kept)
        environment.warn("axiscomp status will not know the figures of the record: "
            + textOf(kept.error()).english());
}

void keepFiguresOrWarn(Environment& environment, const CalibrationRecord& record)
{
    DriveStore store(DriveStore::defaultRoot());
    keepFiguresOrWarn(environment, store, record, Measuring::New);
}

} // namespace axiscomp::app
