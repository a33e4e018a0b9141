// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/uncertainty.h"
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

/// Means, spreads and reversal at each target: of the values in use, or of all. Means are from the
/// datum, as in the plot.
class TargetFiguresModel : public JudgementTableModel {
    Q_OBJECT

public:
    explicit TargetFiguresModel(const RecordModel& record, QObject* parent = nullptr);

    void setShowsAll(bool showsAll);
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;
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

} // namespace axiscomp::ui
