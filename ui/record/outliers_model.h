// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/outliers.h"
#include "ui/record/judgement_table_model.h"

namespace axiscomp::ui {

/// Values that are proposed for exclusion, the most striking first in each direction, and then what
/// is excluded: values, runs, targets.
class OutliersModel : public JudgementTableModel {
    Q_OBJECT

public:
    explicit OutliersModel(const RecordModel& record, QObject* parent = nullptr);

    [[nodiscard]] std::optional<Exclusion> valuesOf(int row) const override;
    [[nodiscard]] int rowOf(const Exclusion& values) const override;

protected:
    [[nodiscard]] int rows() const override;
    [[nodiscard]] int columns() const override;
    [[nodiscard]] QString heading(int column) const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] bool isNumber(int column) const override;
    [[nodiscard]] std::optional<Tone> tone(int row, int column) const override;

private:
    [[nodiscard]] const Outlier* outlierOf(int row) const;
    [[nodiscard]] int proposedCount() const;
};

} // namespace axiscomp::ui
