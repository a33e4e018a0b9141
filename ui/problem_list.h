// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/diagnostic.h"

#include <QWidget>

#include <vector>

class QLabel;
class QTreeWidget;

namespace axiscomp::ui {

/// What is wrong with a file, or odd about it: line, column, sentence.
class ProblemList : public QWidget {
    Q_OBJECT

public:
    explicit ProblemList(QWidget* parent = nullptr);

    /// suppressed: how many more errors there are than the list has.
    void setProblems(
        const QString& fileName, const std::vector<Diagnostic>& problems, std::size_t suppressed);
    void retranslate();

Q_SIGNALS:
    /// Chosen by click or Return: the file's line and column, 0 for the whole file or line.
    void problemChosen(std::size_t line, std::size_t column);

private:
    void fill();

    QLabel* m_title;
    QTreeWidget* m_list;
    QString m_fileName;
    std::vector<Diagnostic> m_problems;
    std::size_t m_suppressed = 0;
};

} // namespace axiscomp::ui
