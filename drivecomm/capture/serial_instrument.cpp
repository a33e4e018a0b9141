// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/capture/serial_instrument.h"

#include "drivecomm/capture/number_pattern.h"
#include "drivecomm/serial/serial_port.h"

#include <utility>

namespace axiscomp::drivecomm {

namespace {

Result<std::string> requestBytes(std::string_view text)
{
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\') {
            bytes += text[i];
            continue;
        }
        constexpr std::string_view letters = "rnt\\";
        constexpr std::string_view meanings = "\r\n\t\\";
        const std::size_t letter = i + 1 < text.size() ? letters.find(text[i + 1]) : letters.npos;
        if (letter == letters.npos)
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the request {text}: behind a backslash r, n, t or another backslash is "
                        "expected")
                        .with("text", text)}});
        bytes += meanings[letter];
        ++i;
    }
    if (!bytes.empty() && bytes.back() != '\r' && bytes.back() != '\n')
        bytes += "\r\n";
    return bytes;
}

} // namespace

struct SerialInstrument::Private {
    Private(DriveEndpoint endpoint, std::string theRequest, ReferenceLines theLines)
        : port(std::move(endpoint))
        , request(std::move(theRequest))
        , lines(std::move(theLines))
    {
    }

    [[nodiscard]] Result<void> openPort();
    [[nodiscard]] Result<void> exchange(std::chrono::nanoseconds now);
    [[nodiscard]] Result<void> takeAll(
        std::chrono::nanoseconds now, const ExchangeDeadline& running);

    SerialPortLine port;
    std::string request;
    ReferenceLines lines;
    std::chrono::nanoseconds tried{0}; ///< to open it again
    Text problem; ///< of the port
};

Result<void> SerialInstrument::Private::openPort()
{
    AXISCOMP_CHECK(port.open());
    lines.beginWithinLine();
    return {};
}

Result<void> SerialInstrument::Private::exchange(std::chrono::nanoseconds now)
{
    if (!port.isOpen())
        AXISCOMP_CHECK(openPort());
    Exchange options;
    options.timeout = std::chrono::seconds(1);
    const ExchangeDeadline running(options);
    if (!request.empty())
        AXISCOMP_CHECK(port.write(asBytes(request), running));
    return takeAll(now, running);
}

/// All that waits: what stayed would be taken for new at the next reading, which may be after a
/// move. The system gives a few kB at once, and those behind them a moment later.
Result<void> SerialInstrument::Private::takeAll(
    std::chrono::nanoseconds now, const ExchangeDeadline& running)
{
    using Clock = std::chrono::steady_clock;
    constexpr std::size_t many = 1024; // bytes, more than come within the moment
    constexpr std::chrono::milliseconds moment(5);
    constexpr std::chrono::milliseconds longest(500); // what comes by then was not waiting
    const auto end = Clock::now() + longest;
    auto until = Clock::now();
    while (true) {
        AXISCOMP_TRY(const auto bytes, port.read(until, running));
        lines.feed(asText(bytes), now);
        const auto time = Clock::now();
        if (bytes.size() < many || time >= end)
            return {};
        until = time + moment;
    }
}

Result<std::unique_ptr<SerialInstrument>> SerialInstrument::open(
    const std::string& endpoint, std::string_view request, ReferenceLines lines)
{
    AXISCOMP_TRY(auto parsed, parseEndpoint(endpoint));
    AXISCOMP_TRY(auto bytes, requestBytes(request));
    auto made = std::make_unique<Private>(std::move(parsed), std::move(bytes), std::move(lines));
    AXISCOMP_CHECK(made->openPort());
    return std::unique_ptr<SerialInstrument>(new SerialInstrument(std::move(made)));
}

SerialInstrument::SerialInstrument(std::unique_ptr<Private> theD) : d(std::move(theD)) { }
SerialInstrument::~SerialInstrument() = default;

InstrumentReading SerialInstrument::at(std::chrono::nanoseconds now)
{
    constexpr std::chrono::nanoseconds pause = std::chrono::seconds(1);
    if (d->problem.isEmpty() || now - d->tried >= pause) {
        d->tried = now;
        const auto done = d->exchange(now);
        d->problem = done ? Text() : textOf(done.error());
    }
    InstrumentReading reading = d->lines.at(now);
    if (!d->problem.isEmpty())
        reading = {std::numeric_limits<double>::quiet_NaN(), d->problem};
    return reading;
}

Result<Instrument> openSerialInstrument(const SerialInstrumentRequest& request,
    const ReferenceScale& scale, bool isAngular, std::chrono::nanoseconds dwell)
{
    AXISCOMP_TRY(auto finder, numberPattern(request.pattern));
    AXISCOMP_TRY(auto reader, ReferenceLineReader::make(scale, isAngular, std::move(finder)));
    AXISCOMP_TRY(auto opened,
        SerialInstrument::open(
            request.endpoint, request.request, ReferenceLines(std::move(reader), dwell)));
    return Instrument([instrument = std::shared_ptr<SerialInstrument>(std::move(opened))](
                          std::chrono::nanoseconds now) { return instrument->at(now); });
}

} // namespace axiscomp::drivecomm
