// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/parameter_export.h"

#include "core/compensator/configuration_transfer.h"
#include "ui/async/background_job.h"

namespace axiscomp::ui {

ParameterExport::ParameterExport(const DriveList& drives, AxisState& axis, LastOutcome& outcome)
    : m_drives(drives)
    , m_axis(axis)
    , m_outcome(outcome)
{
}

void ParameterExport::read()
{
    drop();
    m_stop = std::stop_source();
    DriveSession& session = m_drives.connection()->session();
    const auto ask = [store = session.storeRoot()](
                         AxisCompensator& compensator, const OperationOptions& options) {
        return driveParameters(compensator, store, options);
    };
    whenDone(session.run<CompensationParameters>(ask, m_stop.get_token()), this,
        [this, number = m_number](const Result<CompensationParameters>& parameters) {
            if (number != m_number)
                return;
            m_parameters = parameters;
            if (!parameters && isLinkFailure(parameters.error().code))
                m_axis.take(fail(parameters.error()));
            Q_EMIT parametersRead();
        });
}

void ParameterExport::drop()
{
    m_stop.request_stop();
    ++m_number;
    m_parameters.reset();
}

void ParameterExport::report(const QString& fileName, const Result<void>& saved)
{
    m_outcome.show([fileName, saved] {
        if (!saved)
            return errorOutcome(saved.error());
        return Outcome{
            tr("Wrote %1: only compensation registers have changed.").arg(fileName), false, {}};
    });
}

} // namespace axiscomp::ui
