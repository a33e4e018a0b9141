// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/run_selection.h"

#include <QAbstractTableModel>

#include <optional>
#include <utility>
#include <vector>

namespace axiscomp::ui {

class RecordModel;

/// The values of a record's measurement: a row for each target, a column for each run behind the
/// one of the targets. A cell is made when it is looked at: of a million values only those in
/// sight.
class RunValuesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int targetColumn = 0;

    /// record must outlive the model.
    explicit RunValuesModel(const RecordModel& record, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

    /// What a cell stands for: a value, or the whole target in the column of targets. Nothing for a
    /// cell without a value.
    [[nodiscard]] std::optional<Exclusion> exclusionOf(const QModelIndex& cell) const;
    /// The run of a cell; nothing in the column of targets.
    [[nodiscard]] std::optional<Exclusion> runOf(const QModelIndex& cell) const;

private:
    void follow();
    [[nodiscard]] const RunValue* valueOf(const QModelIndex& cell) const;
    [[nodiscard]] std::optional<std::pair<Approach, int>> runOfColumn(int column) const;
    [[nodiscard]] QString text(const QModelIndex& cell) const;
    [[nodiscard]] QString spoken(const QModelIndex& cell) const;

    const RecordModel& m_record;
    // As announced.
    int m_rows = 0;
    std::vector<int> m_ups; ///< numbers of the runs up
    std::vector<int> m_downs;
};

} // namespace axiscomp::ui
