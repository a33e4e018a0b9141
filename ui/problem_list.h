// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/diagnostic.h"
#include "ui/file_excerpt.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPlainTextEdit;
class QTreeWidget;

namespace axiscomp::ui {

/// What is wrong with a file, or odd about it: line, column, sentence; and the file's own line for
/// the problem that is chosen.
class ProblemList : public QWidget {
    Q_OBJECT

public:
    explicit ProblemList(QWidget* parent = nullptr);

    /// suppressed: how many more errors there are than the list has.
    void setProblems(
        const QString& path, const std::vector<Diagnostic>& problems, std::size_t suppressed);
    void retranslate();

Q_SIGNALS:
    /// Chosen by click or key: the file's line and column, 0 for the whole file or line.
    void problemChosen(std::size_t line, std::size_t column);

private:
    void build();
    void fill();
    void choose();
    void showExcerpt(const FileExcerpt& excerpt, std::size_t line);

    QLabel* m_title;
    QTreeWidget* m_list;
    QPlainTextEdit* m_excerpt;
    QString m_path;
    std::vector<Diagnostic> m_problems;
    std::size_t m_suppressed = 0;
    int m_request = 0; ///< the newest question for an excerpt
};

} // namespace axiscomp::ui
