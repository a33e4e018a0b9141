// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include <optional>

namespace axiscomp::ui {

class ComparisonModel;

/// The figures of ISO 230-2 before, predicted, held out and after, a row each, and what is said of
/// them.
class ComparisonFiguresModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// AllBefore and AllAfter are of all values, and there only where some are left out.
    enum Column {
        Figure,
        Before,
        Predicted,
        HeldOut,
        After,
        Change,
        Limit,
        Verdict,
        AllBefore,
        AllAfter,
        ColumnCount
    };

    /// comparison must outlive the model.
    explicit ComparisonFiguresModel(const ComparisonModel& comparison, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    /// What a screen reader says of the first cell is the whole row as a sentence.
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;
    void retranslate();

private:
    void follow();
    [[nodiscard]] std::optional<double> value(int row, int column) const; ///< in mm or deg
    [[nodiscard]] QString text(int row, int column) const;
    [[nodiscard]] QString spoken(int row, int column) const;
    [[nodiscard]] QString sentence(int row) const;
    [[nodiscard]] static QString columnName(int column);

    const ComparisonModel& m_comparison;
    bool m_isThere = false; ///< as announced
    bool m_hasAllValues = false; ///< likewise
};

} // namespace axiscomp::ui
