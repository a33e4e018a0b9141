// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/data/file_excerpt.h"

#include <QAbstractTableModel>

namespace axiscomp::ui {

/// A place of a file that something is wrong or odd with.
struct ProblemPlace {
    std::size_t line = 0; ///< from 1; 0: the whole file
    std::size_t column = 0; ///< of the file's columns, from 1; 0: the whole line
    bool isError = true;
    QString sentence;
};

/// Lines of a file as a table, with the place of one problem marked by a symbol, bold text and a
/// tint.
class FileLinesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void setExcerpt(FileExcerpt excerpt, ProblemPlace place);
    /// The cell of the problem, or the first of its line; invalid when the excerpt lacks it.
    [[nodiscard]] QModelIndex placeIndex() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] bool isProblem(const QModelIndex& index) const;
    [[nodiscard]] QString fieldAt(const QModelIndex& index) const;
    [[nodiscard]] QString cellText(const QModelIndex& index) const;

    FileExcerpt m_excerpt;
    ProblemPlace m_place;
    int m_columns = 0;
};

} // namespace axiscomp::ui
