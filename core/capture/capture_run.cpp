// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_run.h"

#include <utility>

namespace axiscomp {

CaptureRun::CaptureRun(AxisReadings readings, RunFile file, MeasuringPlan plan, CaptureRules rules,
    DriveIdentity drive)
    : m_readings(std::move(readings))
    , m_file(std::move(file))
    , m_session(std::move(plan), rules, m_file.values())
    , m_window(rules.window)
    , m_drive(std::move(drive))
{
}

void CaptureRun::useConnection(const std::shared_ptr<const void>& connection)
{
    if (m_connection.lock() == connection)
        return;
    m_mustIdentify = m_mustIdentify || m_hasConnection;
    m_hasConnection = true;
    m_connection = connection;
}

void CaptureRun::setTyped(ReferenceLineReader reader)
{
    m_typed.emplace(std::move(reader), m_file.values(), m_window);
}

Text CaptureRun::type(std::string_view line)
{
    if (!m_typed || !m_isAsked)
        return AXISCOMP_TEXT("Error",
            "no position is asked for at the moment: wait until the axis stands at its target");
    Text problem = m_typed->type(line, m_reading, plan().isAngular);
    // Another number among those that are averaged would spoil them.
    m_isAsked = !problem.isEmpty();
    return problem;
}

Result<void> CaptureRun::undo()
{
    if (m_file.taken() == 0)
        return {};
    const auto removed = m_file.removeLast();
    m_session.takeBack(m_file.values());
    m_saidWords = nullptr;
    m_isAsked = false;
    if (m_typed)
        m_typed->takeBack(m_file.values());
    return removed;
}

const Text& CaptureRun::lastProblem() const
{
    const bool isOfInstrument =
        m_event == CaptureSession::Event::NoReference && !m_instrumentProblem.isEmpty();
    return isOfInstrument ? m_instrumentProblem : m_session.problem();
}

/// What was typed belongs to where the axis stood, or was not taken.
void CaptureRun::askAgain()
{
    m_isAsked = false;
    if (m_typed)
        m_typed->forget();
}

Result<CaptureNews> CaptureRun::lost(const Error& error)
{
    if (!isUnreachable(error.code))
        return fail(error);
    return std::exchange(m_isLost, true)
        ? CaptureNews{}
        : CaptureNews{.kind = CaptureNews::Kind::Lost, .text = textOf(error), .error = error};
}

Result<CaptureNews> CaptureRun::read(
    DriveLink& link, const std::function<std::chrono::nanoseconds()>& now, const Exchange& exchange)
{
    const bool wasLost = m_isLost;
    if (wasLost || m_mustIdentify) {
        const auto drive = link.identify(exchange);
        if (!drive)
            return lost(drive.error());
        if (drive->serialNumber != m_drive.serialNumber)
            return fail(ErrorCode::OtherDrive,
                {{"expected", m_drive.serialNumber}, {"found", drive->serialNumber}});
        m_mustIdentify = false;
    }
    const auto reading = m_readings.read(link, exchange);
    if (!reading)
        return lost(reading.error());
    m_isLost = false;
    m_reading = *reading;
    m_reading.time = now();
    if (m_instrument || m_typed) {
        const InstrumentReading instrument =
            m_typed ? m_typed->reading() : m_instrument(m_reading.time);
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
    m_event = m_session.take(m_reading);
    switch (m_event) {
    case Event::Moving:
        m_saidWords = nullptr;
        askAgain();
        return CaptureNews{.kind = Kind::Moving};
    case Event::Standing:
        return CaptureNews{};
    case Event::Taken:
        AXISCOMP_CHECK(m_file.append(m_session.value()));
        m_isAsked = false;
        if (m_typed)
            m_typed->taken(m_session.value());
        return CaptureNews{
            .kind = m_file.taken() == plan().steps.size() ? Kind::Done : Kind::Taken};
    case Event::Refused:
        askAgain();
        return said(Kind::Refused, m_session.problem());
    case Event::NoReference:
        m_isAsked = m_typed.has_value();
        return said(Kind::NoReference, lastProblem());
    case Event::Stopped:
        return CaptureNews{.kind = Kind::Stopped, .text = m_session.problem()};
    case Event::Done:
        return CaptureNews{.kind = Kind::Done};
    }
    return CaptureNews{};
}

} // namespace axiscomp
