// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"
#include "ui/text/value_scale.h"

#include <QString>
#include <QStringList>
#include <QWidget>

#include <vector>

class QAction;
class QLabel;
class QTableView;
class QToolButton;

namespace axiscomp::ui {

class TableContentCombo;
class TableViewModel;
class SliceRow;
class ValuesModel;

/// A rectangle of cells as ValuesModel lays them out, both ends included.
struct CellRange {
    int top = 0;
    int left = 0;
    int bottom = 0;
    int right = 0;
};

/// What goes with the values: the names of 1D's columns, or of a map's dimensions.
struct CopyHeaders {
    QString first; ///< 1D: the position; 2D: dimension 1
    QString second; ///< 1D: the value; 2D: dimension 2
    QStringList more = {}; ///< 1D: of the columns behind the value
};

/// What is copied of.
struct CopiedTable {
    const CompensationTable& drawn; ///< 1 or 2 dimensions
    ValueScale scale = {}; ///< values are in the unit that is seen
    const CompensationTable* onDrive = nullptr; ///< 1D: of the columns behind the value
};

/// Cells as tab-separated lines for spreadsheets: decimal point, every digit the value has, an
/// empty cell where a row or column is only partly chosen. headers null: the cells alone; otherwise
/// with a line of names or positions above and the positions on the left.
/// Takes a tenth of a second for the largest tables: not for the window's thread.
[[nodiscard]] QString copiedText(
    const CopiedTable& table, const std::vector<CellRange>& ranges, const CopyHeaders* headers);

/// The numbers of the table, beside its picture: the same choice, the same slice, and the cell that
/// is current is the picture's cross-hair. Cells are copied for spreadsheets.
class ValuesView : public QWidget {
    Q_OBJECT

public:
    /// shown must outlive the view.
    explicit ValuesView(TableViewModel& shown, QWidget* parent = nullptr);
    void retranslate();

private:
    void build();
    void connectView();
    void showTable();
    void showCurrent();
    void showReadout();
    void copy(bool withPositions);

    TableViewModel& m_shown;
    ValuesModel* m_model;
    TableContentCombo* m_contentBox;
    QLabel* m_layoutNote;
    QToolButton* m_copyButton;
    QTableView* m_table;
    SliceRow* m_slice;
    QLabel* m_readout;
    QAction* m_copy;
    QAction* m_copyWithPositions;
    QAction* m_selectAll;
};

} // namespace axiscomp::ui
