// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/serial_port.h"

#include "drivecomm/serial/device_node.h"

#include <QEventLoop>
#include <QSerialPort>

namespace axiscomp::drivecomm {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// A stop is seen this soon; what arrives ends the wait at once.
constexpr auto slice = 10ms;

int untilNextSlice(Clock::time_point until)
{
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
    return static_cast<int>(std::clamp<std::chrono::milliseconds>(left, 0ms, slice).count());
}

} // namespace

SerialPortLine::SerialPortLine(DriveEndpoint endpoint)
    : m_endpoint(std::move(endpoint))
    , m_name(displayText(m_endpoint))
{
}

SerialPortLine::~SerialPortLine()
{
    close();
}

tl::unexpected<Error> SerialPortLine::notConnected(Argument reason, std::string detail)
{
    close();
    return fail(ErrorCode::NotConnected, {{"endpoint", m_name}, {"reason", std::move(reason)}},
        std::move(detail));
}

tl::unexpected<Error> SerialPortLine::lost()
{
    const std::string detail = m_failure;
    close();
    return fail(ErrorCode::ConnectionLost,
        {{"endpoint", m_name},
            {"reason",
                AXISCOMP_TEXT(
                    "Error", "the serial port is gone; was the cable or the adapter unplugged?")}},
        detail);
}

Result<void> SerialPortLine::open()
{
    close();
    // The lock that keeps other programs out goes by name: the same for every link to a device.
    const Result<std::string> device = usableDevice(m_endpoint.device);
    if (!device)
        return notConnected(*device.error().context.find("reason"), device.error().detail);
    // The port's notifiers want an event dispatcher, which this gives to any thread.
    const QEventLoop dispatcher;
    m_failure.clear();
    m_port = std::make_unique<QSerialPort>();
    QSerialPort* port = m_port.get();
    port->setPortName(QString::fromStdString(*device));
    if (!port->open(QIODevice::ReadWrite)) {
        const std::string detail = port->errorString().toStdString();
        if (port->error() == QSerialPort::PermissionError)
            return notConnected(
                AXISCOMP_TEXT("Error", "another program is using the port; close it there"),
                detail);
        return notConnected(
            AXISCOMP_TEXT("Error", "this is no serial port ({reason})").with("reason", detail),
            detail);
    }
    if (!port->setBaudRate(m_endpoint.baud))
        return notConnected(AXISCOMP_TEXT("Error", "the port cannot do {speed} baud")
                                .with("speed", m_endpoint.baud),
            port->errorString().toStdString());
    // A lost peer makes Qt 6.4 report an error again and again, for as long as the port is open,
    // and closing it in here would report one more: so it is closed as soon as this has returned,
    // by whoever waits for the port or by the thread's event loop.
    QObject::connect(
        port, &QSerialPort::errorOccurred, port, [this, port](QSerialPort::SerialPortError error) {
            if (error == QSerialPort::NoError || error == QSerialPort::TimeoutError
                || !m_failure.empty())
                return;
            m_failure = port->errorString().toStdString();
            if (m_failure.empty())
                m_failure = "error " + std::to_string(error);
            QMetaObject::invokeMethod(
                port,
                [port] {
                    if (port->isOpen())
                        port->close();
                },
                Qt::QueuedConnection);
        });
    port->clear();
    return {};
}

void SerialPortLine::close()
{
    if (!m_port)
        return;
    m_port->disconnect();
    if (m_port->isOpen())
        m_port->close();
    m_port.reset();
}

Result<void> SerialPortLine::check(const ExchangeDeadline& running)
{
    if (!m_port || !m_failure.empty() || !m_port->isOpen())
        return lost();
    if (running.isStopped())
        return fail(ErrorCode::Cancelled);
    if (running.isLate())
        return timeoutError(m_name, running.exchange);
    return {};
}

Result<void> SerialPortLine::write(ByteView bytes, const ExchangeDeadline& running)
{
    if (auto usable = check(running); !usable)
        return usable;
    const auto size = static_cast<qint64>(bytes.size());
    if (m_port->write(reinterpret_cast<const char*>(bytes.data()), size) != size)
        return lost();
    m_port->flush();
    while (m_port->bytesToWrite() > 0) {
        m_port->waitForBytesWritten(untilNextSlice(running.deadline));
        m_port->clearError(); // a time-out stays otherwise
        if (auto usable = check(running); !usable) {
            if (m_port) // what has not been sent must not be sent later
                m_port->clear(QSerialPort::Output);
            return usable;
        }
    }
    return check(running);
}

Result<Bytes> SerialPortLine::read(Clock::time_point until, const ExchangeDeadline& running)
{
    while (true) {
        AXISCOMP_CHECK(check(running));
        if (m_port->bytesAvailable() > 0) {
            Bytes bytes(static_cast<std::size_t>(m_port->bytesAvailable()));
            const qint64 count = m_port->read(
                reinterpret_cast<char*>(bytes.data()), static_cast<qint64>(bytes.size()));
            bytes.resize(static_cast<std::size_t>(std::max<qint64>(count, 0)));
            return bytes;
        }
        const bool isLast = Clock::now() >= until;
        m_port->waitForReadyRead(untilNextSlice(std::min(until, running.deadline)));
        m_port->clearError();
        if (isLast && m_failure.empty() && m_port->bytesAvailable() == 0)
            return Bytes{};
    }
}

std::chrono::nanoseconds SerialPortLine::timeFor(std::uint64_t bytes) const
{
    constexpr std::uint64_t bitsPerByte = 10;
    return std::chrono::nanoseconds(
        bytes * bitsPerByte * 1'000'000'000U / static_cast<std::uint64_t>(m_endpoint.baud));
}

} // namespace axiscomp::drivecomm
