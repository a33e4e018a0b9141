// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/data/table_view_model.h"

#include <QAbstractTableModel>

#include <vector>

namespace axiscomp::ui {

/// The values of what is drawn, as an engineer writes them down. 1D: a row per point with its
/// position and value, numbered by the index that the drive shows; beside another table on the
/// drive also that one's value at the same place, and what the new one changes. 2D, and a slice of
/// 3D: like the map, dimension 1 across and dimension 2 down, with the positions as headers. A long
/// list of a map would put neighbours in Y hundreds of rows apart. Reads the table in place.
class ValuesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Position, Value, OnDrive, Change, ColumnCount }; ///< of 1D
    /// Of cells with a value: its share of the scale of colours, -1 to 1.
    static constexpr int ShareRole = Qt::UserRole;

    /// shown must outlive the model.
    explicit ValuesModel(const TableViewModel& shown, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

    [[nodiscard]] GridPoint pointOf(const QModelIndex& index) const;
    [[nodiscard]] QModelIndex indexOf(const GridPoint& point) const;
    /// The names of 1D's columns: "X [mm]", "compensation [µm]".
    [[nodiscard]] QString columnName(Column column) const;
    void retranslate();

private:
    void follow();
    void chooseScales();
    [[nodiscard]] std::vector<float> valuesAtPointsOf(const CompensationTable& table) const;
    [[nodiscard]] float valueAt(const QModelIndex& index) const;
    [[nodiscard]] const ValueScale& scaleOf(const QModelIndex& index) const;
    [[nodiscard]] bool isMap() const { return m_table && m_table->grid.dimensions() == 2; }

    const TableViewModel& m_shown;
    TableViewModel::Table m_table; ///< what the views know
    TableViewModel::Table m_second; ///< likewise
    ValueScale m_scaleOnDrive; ///< of m_second at the places of m_table
    ValueScale m_scaleOfChange; ///< of the difference of the two
};

} // namespace axiscomp::ui
