// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QTableView;
class QToolButton;

namespace axiscomp::ui {

class ContentBox;
class ShownTable;
class SliceRow;
class ValuesModel;

/// The numbers of the table, beside its picture: the same choice, the same slice, and the cell that
/// is current is the picture's cross-hair. Cells are copied for spreadsheets.
class ValuesView : public QWidget {
    Q_OBJECT

public:
    /// shown must outlive the view.
    explicit ValuesView(ShownTable& shown, QWidget* parent = nullptr);
    void retranslate();

private:
    void build();
    void connectView();
    void showTable();
    void showCurrent();
    void showReadout();
    void copy(bool withPositions);

    ShownTable& m_shown;
    ValuesModel* m_model;
    ContentBox* m_contentBox;
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
