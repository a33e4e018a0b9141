// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/machine/snapshot.h"
#include "ui/controller/drive_list.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace axiscomp::ui {

/// Running drives as a machine file with all tables, in a folder: the bytes that the command line
/// writes. Nothing is written over without having been asked for; drives are only read.
class MachineSaving : public QObject {
    Q_OBJECT

public:
    enum class Stage { Idle, Reading, Asking, Saving, Saved, Failed };

    /// Both must outlive this.
    MachineSaving(const DriveProfile& profile, const DriveList& drives);
    ~MachineSaving() override;

    /// Reads the drives at these endpoints (without passwords) and saves them, unless that would
    /// replace something. name: of the machine, may be empty.
    void save(const QStringList& endpoints, const QString& name, const QString& folder);
    /// At Stage::Asking: saves what was read.
    void replace();
    /// What runs is of no interest any more, or is not to be done.
    void drop();

    [[nodiscard]] Stage stage() const { return m_stage; }
    /// Names of the files that would be replaced, at Stage::Asking.
    [[nodiscard]] const QStringList& replaced() const { return m_replaced; }
    /// At Stage::Failed.
    [[nodiscard]] const std::optional<Error>& problem() const { return m_problem; }
    /// The drive that it was about; empty: none.
    [[nodiscard]] const QString& problemPlace() const { return m_problemPlace; }
    /// Of what was read.
    [[nodiscard]] const std::shared_ptr<const MachineSnapshot>& snapshot() const
    {
        return m_snapshot;
    }
    [[nodiscard]] const QString& folder() const { return m_folder; }

Q_SIGNALS:
    void changed();

private:
    void take(std::size_t index, const Result<std::shared_ptr<DriveSnapshot>>& snapshot);
    void join();
    void write();
    void enter(Stage stage);
    void giveUp(const Error& error, const QString& place = {});

    const DriveProfile& m_profile;
    const DriveList& m_drives;
    Stage m_stage = Stage::Idle;
    QString m_name;
    QString m_folder;
    QStringList m_endpoints;
    std::vector<std::shared_ptr<DriveSnapshot>> m_read; ///< null: not yet
    std::shared_ptr<const MachineSnapshot> m_snapshot;
    QStringList m_replaced;
    std::optional<Error> m_problem;
    QString m_problemPlace;
    std::stop_source m_stop;
    int m_number = 0; ///< the newest counts
};

} // namespace axiscomp::ui
