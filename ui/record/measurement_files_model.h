// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

namespace axiscomp::ui {

class RecordModel;
struct ReadMeasurement;

/// The files of a record, a row each: what they hold and whether they can be used.
class MeasurementFilesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { File, State, Content, Compensation, ColumnCount };

    /// record must outlive the model.
    explicit MeasurementFilesModel(const RecordModel& record, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

private:
    void follow();
    /// Of a row; null while it is being read.
    [[nodiscard]] const ReadMeasurement* readingOf(int row) const;
    [[nodiscard]] QString text(int row, int column) const;

    const RecordModel& m_record;
    QStringList m_paths; ///< as announced
};

/// "5 up, 5 down": what a file holds, in short; empty for one that cannot be used.
[[nodiscard]] QString contentText(const ReadMeasurement& reading);

} // namespace axiscomp::ui
