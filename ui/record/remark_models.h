// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/judgement_table_model.h"

namespace axiscomp::ui {

/// Whether it was measured as the standard wants it.
class ConditionsModel : public JudgementTableModel {
    Q_OBJECT

public:
    explicit ConditionsModel(const RecordModel& record, QObject* parent = nullptr);

protected:
    [[nodiscard]] int rows() const override;
    [[nodiscard]] int columns() const override;
    [[nodiscard]] QString heading(int column) const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] std::optional<Tone> tone(int row, int column) const override;
};

/// What is to be known before the figures are believed: drift, contradictions with results in the
/// file, disturbances.
class JudgeWarningsModel : public JudgementTableModel {
    Q_OBJECT

public:
    explicit JudgeWarningsModel(const RecordModel& record, QObject* parent = nullptr);

protected:
    [[nodiscard]] int rows() const override;
    [[nodiscard]] int columns() const override;
    [[nodiscard]] QString heading(int column) const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] std::optional<Tone> tone(int row, int column) const override;
};

} // namespace axiscomp::ui
