// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTableView;

namespace axiscomp::ui {

class JudgementTableModel;

/// A view of whole rows, read row by row. name: of the widget.
[[nodiscard]] QTableView* newJudgementTable(const char* name, JudgementTableModel& model);

} // namespace axiscomp::ui
