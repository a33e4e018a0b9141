// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/diagnostic.h"
#include "ui/data/file_lines_model.h"

#include <QAbstractTableModel>

#include <vector>

namespace axiscomp::ui {

/// What is wrong or odd with a file, a row for each problem: line, column of the file, sentence.
class ProblemModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Line, FileColumn, Statement, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    void setProblems(const std::vector<Diagnostic>& problems);
    [[nodiscard]] const std::vector<Diagnostic>& problems() const { return m_problems; }
    /// row: one of the model's.
    [[nodiscard]] ProblemPlace place(int row) const;
    /// Announces the sentences in another language.
    void retranslate();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<Diagnostic> m_problems;
};

} // namespace axiscomp::ui
