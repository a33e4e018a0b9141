// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

namespace axiscomp::ui {

class AxisOverview;
class MachineController;
struct OverviewRow;

/// The axes of all drives as a table, in the language of the moment.
class OverviewModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        Drive,
        Axis,
        State,
        Machine, ///< how the axis stands to the machine file; empty without one
        Table,
        Persistence,
        FlashLeft,
        Measured,
        LastProof,
        LastWrite,
        ColumnCount,
    };
    enum Role {
        SortRole = Qt::UserRole, ///< by which a column is put in order
        ToneRole, ///< of the state, a Tone; none: not known
        DriftToneRole, ///< of the machine file, a Tone; none: nothing stands out
        IsLiveRole, ///< false: as it was read before the drive was lost
    };

    /// overview must outlive the model.
    explicit OverviewModel(const AxisOverview& overview, QObject* parent = nullptr);

    /// machine must outlive the model.
    void showMachine(const MachineController& machine);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

    void retranslate();

private:
    [[nodiscard]] QString text(const OverviewRow& row, int column) const;
    [[nodiscard]] QVariant sortKey(const OverviewRow& row, int column) const;
    [[nodiscard]] QString toolTip(const OverviewRow& row, int column) const;
    [[nodiscard]] static QString stateText(const OverviewRow& row);

    void announceAll();

    const AxisOverview& m_overview;
    const MachineController* m_machine = nullptr;
    int m_rows = 0; ///< as announced
};

} // namespace axiscomp::ui
