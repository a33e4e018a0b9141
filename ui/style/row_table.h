// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QAbstractItemModel;
class QTableView;

namespace axiscomp::ui {

/// A view of whole rows, read row by row. name: of the widget.
[[nodiscard]] QTableView* newRowTable(const char* name, QAbstractItemModel& model);

} // namespace axiscomp::ui
