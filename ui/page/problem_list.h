// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/data/data_file_state.h"
#include "ui/data/file_lines_model.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;
class QTreeView;

namespace axiscomp::ui {

class ProblemModel;

/// What is wrong with a file, or odd about it: line, column, sentence. A click or Enter opens the
/// file there.
class ProblemList : public QWidget {
    Q_OBJECT

public:
    enum class About { Table, Measurement };

    explicit ProblemList(QWidget* parent = nullptr, About about = About::Table);

    /// Those of the file. Whether they are new ones.
    bool setProblems(const DataFile& file);
    void retranslate();

    /// Opens the next (1) or the previous (-1) problem, round the ends.
    void step(int step);

Q_SIGNALS:
    void opened(const QString& path, const axiscomp::ui::ProblemPlace& place);
    /// The file is to be read as the grid that it is.
    void dimensionsChosen(const QString& path, int dimensions);

private:
    void build();
    void showSummary();
    void open();

    About m_about;
    QLabel* m_title;
    QPushButton* m_useDimensions;
    ProblemModel* m_model;
    QTreeView* m_list;
    QString m_path;
    std::size_t m_suppressed = 0;
    std::optional<FullGrid> m_fullGrid;
};

} // namespace axiscomp::ui
