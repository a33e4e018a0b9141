// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_csv.h"
#include "core/metrology/formats/measurement_formats.h"
#include "core/metrology/formats/run_assembly.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::track_csv {

namespace {

constexpr std::size_t fewestSamples = 20;
constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr std::array kinds{MeasurementKind::Track};
constexpr std::array<std::string_view, 3> rules{
    "Columns encoder (the raw position) and reference, at least 20 lines; time (as that of runs) "
    "and direction if wished.",
    "Without a column direction it follows from the motion: after each turn samples are left out, "
    "and counted, until the axis has moved --overrun (1 % of the range unless given).",
    "A track can be fitted, not judged: the figures of the standard need targets.",
};

/// Takes the direction from the motion. Going back by less than the overrun is no turn but the
/// trembling of an axis; what comes between the farthest place and the overrun behind it belongs to
/// no direction. Returns how many samples are left out.
std::size_t takeDirections(std::vector<TrackSample>& samples, double overrun)
{
    std::vector<TrackSample> kept;
    std::vector<TrackSample> undecided;
    const double start = samples.front().encoder;
    double farthest = start;
    double sign = 0.0;
    const auto keep = [&kept, &sign](TrackSample one) {
        one.direction = sign > 0.0 ? Approach::Up : Approach::Down;
        kept.push_back(one);
    };
    for (const TrackSample& one : samples) {
        const double moved = one.encoder - farthest;
        if (sign != 0.0 && moved * sign >= 0.0) {
            for (const TrackSample& trembling : undecided)
                keep(trembling);
        } else if (std::abs(moved) >= overrun) {
            sign = moved > 0.0 ? 1.0 : -1.0;
        } else {
            undecided.push_back(one);
            continue;
        }
        undecided.clear();
        farthest = one.encoder;
        keep(one);
    }
    const std::size_t dropped = samples.size() - kept.size();
    samples = std::move(kept);
    return dropped;
}

double rangeOf(const std::vector<TrackSample>& samples)
{
    if (samples.empty())
        return 0.0;
    const auto [low, high] = std::ranges::minmax_element(samples, {}, &TrackSample::encoder);
    return high->encoder - low->encoder;
}

class Reader {
public:
    Reader(MeasurementCsv& csv, const MeasurementReadOptions& options, Measurement& measurement,
        DiagnosticList& diagnostics)
        : m_csv(csv)
        , m_options(options)
        , m_measurement(measurement)
        , m_diagnostics(diagnostics)
    {
    }

    void run();

private:
    [[nodiscard]] bool findColumns();
    [[nodiscard]] std::optional<TrackSample> readLine();
    void finish(std::vector<TrackSample> samples);

    MeasurementCsv& m_csv;
    const MeasurementReadOptions& m_options;
    Measurement& m_measurement;
    DiagnosticList& m_diagnostics;
    std::size_t m_encoder = 0;
    std::size_t m_reference = 0;
    std::size_t m_direction = 0;
    std::size_t m_time = 0;
    double m_encoderFactor = 1.0;
    double m_referenceFactor = 1.0;
};

bool Reader::findColumns()
{
    m_encoder = m_csv.column("encoder", {});
    m_reference = m_csv.column("reference", {"actual", "measured"});
    m_direction = m_csv.column("direction", {"dir"});
    m_time = m_csv.column("time", {});
    m_csv.findAxis();
    m_csv.checkMapping();
    if (m_encoder == 0 || m_reference == 0) {
        m_csv.error(DiagnosticCode::MissingColumn, 0,
            m_encoder == 0 ? AXISCOMP_TEXT("Error", "no column encoder")
                           : AXISCOMP_TEXT("Error", "no column reference"),
            AXISCOMP_TEXT("Error", "columns encoder and reference"));
        return false;
    }
    const auto encoder = m_csv.unit(m_encoder, m_options.unit);
    const auto reference = m_csv.unit(m_reference, m_options.valueUnit);
    m_csv.checkSameKind(encoder, reference, m_reference);
    checkStatedValues(m_options, true, m_diagnostics);
    if (!encoder || !reference || m_diagnostics.hasErrors())
        return false;
    m_encoderFactor = encoder->factor;
    m_referenceFactor = m_options.invertsReference ? -reference->factor : reference->factor;
    m_measurement.isAngular = encoder->isAngular;
    return true;
}

std::optional<TrackSample> Reader::readLine()
{
    const auto encoder = m_csv.number(m_encoder);
    const auto reference = m_csv.number(m_reference);
    TrackSample one;
    one.time = m_csv.time(m_time);
    if (m_direction != 0) {
        const std::string_view text = m_csv.text(m_direction);
        const auto direction = approachOf(text);
        one.direction = direction.value_or(Approach::Up);
        if (!direction)
            m_csv.error(DiagnosticCode::BadDirection, m_direction, Verbatim{m_csv.shown(text)},
                AXISCOMP_TEXT("Error", "+ or -, up or down, forward or backward"));
    }
    if (!encoder || !reference)
        return std::nullopt;
    one.encoder = *encoder * m_encoderFactor;
    one.reference = *reference * m_referenceFactor;
    return one;
}

void Reader::run()
{
    if (!findColumns())
        return;
    std::vector<TrackSample> samples;
    while (m_csv.next())
        if (const auto sample = readLine())
            samples.push_back(*sample);
    m_csv.noteUnknownColumns();
    if (!m_diagnostics.hasErrors())
        finish(std::move(samples));
}

void Reader::finish(std::vector<TrackSample> samples)
{
    const double range = rangeOf(samples);
    if (!std::isfinite(range)) {
        m_diagnostics.error(DiagnosticCode::NotFinite, 0, 0, {},
            AXISCOMP_TEXT("Error", "numbers that a computer can hold; check their size"));
        return;
    }
    if (samples.size() < fewestSamples || !(range > 0.0)) {
        m_diagnostics.error(DiagnosticCode::TooFewPoints, 0, 0,
            AXISCOMP_COUNTED("Error", "{count} samples", "1 sample").with("count", samples.size()),
            AXISCOMP_TEXT("Error", "at least {count} samples of an axis that moves")
                .with("count", fewestSamples));
        return;
    }
    std::vector<double> encoder;
    std::vector<double> reference;
    for (const TrackSample& one : samples) {
        encoder.push_back(one.encoder);
        reference.push_back(one.reference);
    }
    checkInstrumentScale({encoder, reference, m_measurement.isAngular}, m_options, m_diagnostics);
    if (m_direction == 0) {
        const double overrun = m_options.overrun > 0.0 ? m_options.overrun : 0.01 * range;
        const std::size_t dropped = takeDirections(samples, overrun);
        if (dropped > 0)
            m_diagnostics.warning(DiagnosticCode::LeftOut, 0, 0,
                AXISCOMP_COUNTED("Error",
                    "{count} samples after turns, until the axis had moved {overrun}",
                    "1 sample after a turn, until the axis had moved {overrun}")
                    .with("count", dropped)
                    .with("overrun",
                        Quantity{roundedText(overrun), std::string(positionUnit(m_measurement))}),
                {});
    }
    m_measurement.track = std::move(samples);
}

void parse(std::string_view text, const MeasurementReadOptions& options, Measurement& measurement,
    DiagnosticList& diagnostics)
{
    measurement.kind = MeasurementKind::Track;
    MeasurementCsv csv(text, options, measurement, diagnostics);
    if (csv.readHeader())
        Reader(csv, options, measurement, diagnostics).run();
}

MeasurementReading read(std::string_view text, const MeasurementReadOptions& options)
{
    return readMeasurementText(text, options, parse);
}

MeasurementRecognition recognise(std::string_view text)
{
    const std::vector<std::string> names = headerNames(text);
    const auto has = [&names](std::string_view name) {
        return std::ranges::find(names, name) != names.end();
    };
    return has("encoder") && (has("reference") || has("actual") || has("measured"))
            && !has("target")
        ? MeasurementRecognition::Certain
        : MeasurementRecognition::No;
}

} // namespace

const MeasurementFormat& format()
{
    static const MeasurementFormat format{
        .facts = {.name = "track",
            .origin = "loggers",
            .description =
                AXISCOMP_TEXT("Error", "CSV of encoder and reference positions without targets"),
            .extensions = extensions,
            .kinds = kinds,
            .rules = rules},
        .recognise = recognise,
        .read = read};
    return format;
}

} // namespace axiscomp::track_csv
