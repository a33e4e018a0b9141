// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/data/file_lines_model.h"

#include <QWidget>

class QLabel;
class QTableView;
class QToolButton;

namespace axiscomp::ui {

/// The file itself where it could not be used: the lines round a problem, with the way to the next
/// one and back to the table's values. Of the file it reads a window of lines, on another thread.
class FileLinesView : public QWidget {
    Q_OBJECT

public:
    explicit FileLinesView(QWidget* parent = nullptr);
    ~FileLinesView() override;

    void showProblem(const QString& path, const ProblemPlace& place);
    void retranslate();

Q_SIGNALS:
    void stepRequested(int step); ///< to the next (1) or previous (-1) problem
    void closeRequested();

private:
    void build();
    void read(std::size_t line);
    void showExcerpt(const FileExcerpt& excerpt, std::size_t line);
    void showTitle();
    void showRange();

    FileLinesModel* m_model;
    QLabel* m_title;
    QToolButton* m_previous;
    QToolButton* m_next;
    QToolButton* m_close;
    QTableView* m_table;
    QLabel* m_range;
    QToolButton* m_earlier;
    QToolButton* m_later;
    QString m_path;
    ProblemPlace m_place;
    std::size_t m_firstLine = 1;
    bool m_hasMore = false;
    bool m_isReading = false;
    int m_request = 0; ///< the newest question for lines
    std::stop_source m_stop; ///< of that
};

} // namespace axiscomp::ui
