// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/async/background_job.h"
#include "ui/record/record.h"

#include <QTableWidget>

#include <optional>

class QComboBox;

namespace axiscomp::ui {

/// The beginning of a CSV file, with a list over each column that says what it is.
class ColumnPreview : public QTableWidget {
    Q_OBJECT

public:
    explicit ColumnPreview(QWidget* parent = nullptr);

    /// Reads the beginning of the file on another thread. An empty path: nothing is shown.
    void show(const QString& path, const MeasurementChoices& choices);
    void retranslate();
    /// The names of the columns; empty: the file is being read, or has none.
    [[nodiscard]] QStringList header() const;
    /// roles: one for each column; empty ones, and those that there are not, give nothing.
    [[nodiscard]] static std::vector<ColumnMapping> mappingOf(const QStringList& roles);
    [[nodiscard]] static QStringList rolesOf(
        const std::vector<ColumnMapping>& columns, qsizetype count);
    /// "target in column 1, deviation in column 4"
    [[nodiscard]] static QString mappingText(const std::vector<ColumnMapping>& columns);

Q_SIGNALS:
    /// Every role that was chosen, of columns by their numbers; empty: the header names them.
    void mappingChosen(const std::vector<axiscomp::ColumnMapping>& columns);
    /// header() is that of the file that is shown.
    void previewed();

private:
    using Preview = std::optional<MeasurementPreview>;

    void fill(const Preview& preview);
    void addList(int column);
    void choose(const std::vector<ColumnMapping>& columns);
    void report();

    NewestJob<Preview> m_job;
    QString m_path;
    std::size_t m_skippedLines = 0;
    std::vector<ColumnMapping> m_columns;
    Preview m_preview;
    std::vector<QComboBox*> m_lists; ///< one for each column
};

} // namespace axiscomp::ui
