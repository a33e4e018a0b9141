// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;

namespace axiscomp::ui {

class TableViewModel;

/// Which slice of a 3D table is shown: the dimension that is cut, and where. Hidden otherwise. All
/// rows of one TableViewModel show the same slice.
class SliceRow : public QWidget {
    Q_OBJECT

public:
    /// shown must outlive the row.
    explicit SliceRow(TableViewModel& shown, QWidget* parent = nullptr);
    void retranslate();

private:
    void follow();

    TableViewModel& m_shown;
    QLabel* m_label;
    QComboBox* m_dimension;
    QSlider* m_index;
    QLabel* m_position;
};

} // namespace axiscomp::ui
