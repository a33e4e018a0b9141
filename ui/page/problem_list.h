// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/diagnostic.h"
#include "ui/data/file_lines_model.h"

#include <QWidget>

#include <vector>

class QLabel;
class QTreeWidget;

namespace axiscomp::ui {

/// What is wrong with a file, or odd about it: line, column, sentence. A click or Enter opens the
/// file there.
class ProblemList : public QWidget {
    Q_OBJECT

public:
    explicit ProblemList(QWidget* parent = nullptr);

    /// suppressed: how many more errors there are than the list has. Whether these are new ones.
    bool setProblems(
        const QString& path, const std::vector<Diagnostic>& problems, std::size_t suppressed);
    void retranslate();

    /// Opens the next (1) or the previous (-1) problem, round the ends.
    void step(int step);

Q_SIGNALS:
    void opened(const QString& path, const axiscomp::ui::ProblemPlace& place);

private:
    void build();
    void fill();
    void open();

    QLabel* m_title;
    QTreeWidget* m_list;
    QString m_path;
    std::vector<Diagnostic> m_problems;
    std::size_t m_suppressed = 0;
};

} // namespace axiscomp::ui
