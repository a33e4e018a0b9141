// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/judgement_table_model.h"

namespace axiscomp::ui {

/// Offset and slope of each run, beside the mean of its direction.
class RunDriftModel : public JudgementTableModel {
    Q_OBJECT

public:
    explicit RunDriftModel(const RecordModel& record, QObject* parent = nullptr);

    [[nodiscard]] std::optional<Exclusion> valuesOf(int row) const override;
    [[nodiscard]] int rowOf(const Exclusion& values) const override;

protected:
    [[nodiscard]] int rows() const override;
    [[nodiscard]] int columns() const override;
    [[nodiscard]] QString heading(int column) const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] bool isNumber(int column) const override;
};

/// The drift of both directions: what stands for each, a row for every statement.
class DriftModel : public JudgementTableModel {
    Q_OBJECT

public:
    explicit DriftModel(const RecordModel& record, QObject* parent = nullptr);

protected:
    [[nodiscard]] int rows() const override;
    [[nodiscard]] int columns() const override;
    [[nodiscard]] QString heading(int column) const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] bool isNumber(int column) const override;
    [[nodiscard]] std::optional<Tone> tone(int row, int column) const override;
};

} // namespace axiscomp::ui
