// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/record.h"

#include <QWidget>

#include <optional>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableView;

namespace axiscomp::ui {

class FileChoices;
class MeasurementFilesModel;
class RecordModel;
struct ReadMeasurement;

/// The files of a measurement, and how each is read.
class MeasurementFiles : public QWidget {
    Q_OBJECT

public:
    /// prefix: before the names of the widgets, so that each is there once in a window. record must
    /// outlive the widget.
    explicit MeasurementFiles(
        RecordModel& record, const QString& prefix = {}, QWidget* parent = nullptr);

    /// spoken: the same for those who hear it.
    void setTitle(const QString& title, const QString& spoken);
    void retranslate();
    /// Under the files and what is chosen of them, scrolled with them.
    void addRow(QWidget* row);
    /// Of the current file.
    void mapColumns(const std::vector<ColumnMapping>& columns);
    [[nodiscard]] std::optional<std::size_t> current() const;
    /// Empty: none.
    [[nodiscard]] MeasurementFile currentFile() const;
    /// null: none, or it is being read.
    [[nodiscard]] const ReadMeasurement* currentReading() const;

Q_SIGNALS:
    void addRequested(); ///< the user wants to choose files
    void currentChanged(); ///< another file is the current one, or what is known of it

private:
    void build(const QString& prefix);
    void buildList();
    void connectParts();
    void follow();
    void showFile();
    void remove();

    RecordModel& m_record;
    MeasurementFilesModel* m_model;
    QLabel* m_title;
    QPushButton* m_add;
    QTableView* m_files;
    QPushButton* m_remove;
    QCheckBox* m_swap;
    FileChoices* m_choices;
    QWidget* m_fields;
    std::size_t m_fileCount = 0; ///< as last seen
};

} // namespace axiscomp::ui
