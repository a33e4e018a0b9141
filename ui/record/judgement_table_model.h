// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/run_selection.h"
#include "ui/style/contrast.h"

#include <QAbstractTableModel>

#include <optional>

namespace axiscomp::ui {

class RecordModel;
struct RecordState;

/// A table of what a record comes to. Its cells are made when they are looked at; the first cell of
/// a row says all of it to a screen reader.
class JudgementTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// record must outlive the model.
    explicit JudgementTableModel(const RecordModel& record, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

    /// The values that a row is about; nothing: not about some of them.
    [[nodiscard]] virtual std::optional<Exclusion> valuesOf(int row) const;
    /// The row about these values or the target or run that they are of; -1: there is none.
    [[nodiscard]] virtual int rowOf(const Exclusion& values) const;

protected:
    [[nodiscard]] const RecordState& state() const;
    /// Takes the number of rows and columns anew; to be called in the constructor of a model.
    void follow();

    [[nodiscard]] virtual int rows() const = 0;
    [[nodiscard]] virtual int columns() const = 0;
    [[nodiscard]] virtual QString heading(int column) const = 0;
    [[nodiscard]] virtual QString text(int row, int column) const = 0;
    [[nodiscard]] virtual bool isNumber(int column) const; ///< no, unless it is overridden
    /// Of a cell that says how good or bad something is.
    [[nodiscard]] virtual std::optional<Tone> tone(int row, int column) const;

private:
    [[nodiscard]] QString spoken(int row) const;

    const RecordModel& m_record;
    // As announced.
    int m_rows = 0;
    int m_columns = 0;
};

} // namespace axiscomp::ui
