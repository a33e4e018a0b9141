// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/configuration/compensation_parameters.h"
#include "ui/controller/axis_state.h"

#include <QObject>

#include <optional>
#include <stop_token>

namespace axiscomp::ui {

/// The compensation parameters of the current drive, for a TAM configuration.
class ParameterExport : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive this.
    ParameterExport(const DriveList& drives, AxisState& axis, LastOutcome& outcome);

    /// Reads them; parametersRead() follows unless another question does.
    void read();
    /// The last question is of no interest any more.
    void drop();
    /// None while the drive is being read.
    [[nodiscard]] const std::optional<Result<CompensationParameters>>& parameters() const
    {
        return m_parameters;
    }
    /// Shows what has become of the file.
    void report(const QString& fileName, const Result<void>& saved);

Q_SIGNALS:
    void parametersRead();

private:
    const DriveList& m_drives;
    AxisState& m_axis;
    LastOutcome& m_outcome;
    std::optional<Result<CompensationParameters>> m_parameters;
    int m_number = 0; ///< the newest question counts
    std::stop_source m_stop;
};

} // namespace axiscomp::ui
