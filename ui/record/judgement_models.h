// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/judgement.h"
#include "ui/record/judgement_table_model.h"

namespace axiscomp::ui {

struct JudgedValues;

/// The figures of ISO 230-2, a row each, with tolerance and verdict; then those of VDI/DGQ 3441.
/// When values are excluded, those of all values stand beside them, as on the command line.
class FiguresModel : public JudgementTableModel {
    Q_OBJECT

public:
    explicit FiguresModel(const RecordModel& record, QObject* parent = nullptr);

protected:
    [[nodiscard]] int rows() const override;
    [[nodiscard]] int columns() const override;
    [[nodiscard]] QString heading(int column) const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] bool isNumber(int column) const override;
    [[nodiscard]] std::optional<Tone> tone(int row, int column) const override;

private:
    enum class Cell { Symbol, Meaning, Value, OfAll, Tolerance, Verdict, Places };
    [[nodiscard]] Cell cellOf(int column) const;
    [[nodiscard]] const Verdict* verdictOf(int row) const;
    [[nodiscard]] QString vdiText(int row, Cell cell) const;
};

/// Means, spreads and reversal at each target: of the values in use, or of all.
class TargetFiguresModel : public JudgementTableModel {
    Q_OBJECT

public:
    explicit TargetFiguresModel(const RecordModel& record, QObject* parent = nullptr);

    void setShowsAll(bool showsAll);
    [[nodiscard]] std::optional<Exclusion> valuesOf(int row) const override;
    [[nodiscard]] int rowOf(const Exclusion& values) const override;

protected:
    [[nodiscard]] int rows() const override;
    [[nodiscard]] int columns() const override;
    [[nodiscard]] QString heading(int column) const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] bool isNumber(int column) const override;

private:
    [[nodiscard]] const JudgedValues& shown() const;
    bool m_showsAll = false;
};

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
    [[nodiscard]] bool isNumber(int column) const override;
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
    [[nodiscard]] bool isNumber(int column) const override;
    [[nodiscard]] std::optional<Tone> tone(int row, int column) const override;
};

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
