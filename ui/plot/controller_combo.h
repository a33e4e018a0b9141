// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/controller_preview.h"
#include "ui/async/background_job.h"

#include <QComboBox>

#include <memory>

namespace axiscomp::ui {

/// By which controller the shown table is applied: the drive, or another one, whose table is
/// computed in the background.
class ControllerCombo : public QComboBox {
    Q_OBJECT

public:
    using Table = std::shared_ptr<const CompensationTable>;

    explicit ControllerCombo(QWidget* parent = nullptr);

    /// The table of the drive; null: none. place: see tableAsAppliedBy.
    void setTable(const Table& table, const AxisPlace& place);
    /// What is to be shown: the drive's table, or the other controller's as soon as it is there.
    [[nodiscard]] const Table& table() const { return m_shown; }
    [[nodiscard]] bool isOfDrive() const { return m_shown == m_table; }
    /// Why the controller cannot have the table, a translated sentence; mostly empty.
    [[nodiscard]] QString problem() const;
    void retranslate();

Q_SIGNALS:
    void changed(); ///< table(), problem()

private:
    void fill();
    void compute();
    void take(const Result<CompensationTable>& applied);
    [[nodiscard]] const TableFormat* format() const; ///< null: the drive

    Table m_table;
    AxisPlace m_place;
    Table m_shown;
    std::optional<Error> m_problem;
    NewestJob<Result<CompensationTable>> m_job;
};

} // namespace axiscomp::ui
