// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/page/page_tabs.h"
#include "ui/style/contrast.h"

#include <QString>

namespace axiscomp::ui {

class RecordModel;

/// How a judgement stands: the mark of its tab, and the sentence that matters most.
struct JudgeOutlook {
    PageTabs::Mark mark = PageTabs::Mark::Empty;
    Tone tone = Tone::Information;
    QString nextStep;
};
[[nodiscard]] JudgeOutlook judgeOutlook(const RecordModel& record);

} // namespace axiscomp::ui
