// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_run.h"

#include <utility>

namespace axiscomp {

CaptureRun::CaptureRun(DriveLink& link, AxisReadings readings, RunFile file, MeasuringPlan plan,
    CaptureRules rules, DriveIdentity drive)
    : m_link(link)
    , m_readings(std::move(readings))
    , m_file(std::move(file))
    , m_session(std::move(plan), rules, m_file.values())
    , m_drive(std::move(drive))
{
}

Result<CaptureNews> CaptureRun::lost(const Error& error)
{
    if (!isUnreachable(error.code))
        return fail(error);
    return std::exchange(m_isLost, true)
        ? CaptureNews{}
        : CaptureNews{.kind = CaptureNews::Kind::Lost, .text = textOf(error)};
}

Result<CaptureNews> CaptureRun::read(
    const std::function<std::chrono::nanoseconds()>& now, const Exchange& exchange)
{
    const bool wasLost = m_isLost;
    if (wasLost) {
        const auto drive = m_link.identify(exchange);
        if (!drive)
            return lost(drive.error());
        if (drive->serialNumber != m_drive.serialNumber)
            return fail(ErrorCode::OtherDrive,
                {{"expected", m_drive.serialNumber}, {"found", drive->serialNumber}});
    }
    const auto reading = m_readings.read(exchange);
    if (!reading)
        return lost(reading.error());
    m_isLost = false;
    m_reading = *reading;
    m_reading.time = now();
    if (m_instrument) {
        const InstrumentReading instrument = m_instrument(m_reading.time);
        m_reading.reference = instrument.position;
        m_instrumentProblem = instrument.problem;
    }
    AXISCOMP_TRY(CaptureNews news, take());
    news.isBack = wasLost;
    return news;
}

CaptureNews CaptureRun::said(CaptureNews::Kind kind, const Text& text)
{
    const char* words = text.pattern().words;
    return std::exchange(m_saidWords, words) == words ? CaptureNews{}
                                                      : CaptureNews{.kind = kind, .text = text};
}

Result<CaptureNews> CaptureRun::take()
{
    using Event = CaptureSession::Event;
    using Kind = CaptureNews::Kind;
    switch (m_session.take(m_reading)) {
    case Event::Moving:
        m_saidWords = nullptr;
        return CaptureNews{.kind = Kind::Moving};
    case Event::Standing:
        return CaptureNews{};
    case Event::Taken:
        AXISCOMP_CHECK(m_file.append(m_session.value()));
        return CaptureNews{
            .kind = m_file.taken() == plan().steps.size() ? Kind::Done : Kind::Taken};
    case Event::Refused:
        return said(Kind::Refused, m_session.problem());
    case Event::NoReference:
        return said(Kind::NoReference,
            m_instrumentProblem.isEmpty() ? m_session.problem() : m_instrumentProblem);
    case Event::Stopped:
        return CaptureNews{.kind = Kind::Stopped, .text = m_session.problem()};
    case Event::Done:
        return CaptureNews{.kind = Kind::Done};
    }
    return CaptureNews{};
}

} // namespace axiscomp
