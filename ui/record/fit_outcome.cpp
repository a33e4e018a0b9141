// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/fit_outcome.h"

#include "core/conversion/table_import.h"
#include "core/metrology/fit/fit_fields.h"
#include "core/metrology/record/fit_record.h"
#include "core/metrology/record/reference_reading.h"
#include "core/neutral/drive_note.h"
#include "core/table/tam_table.h"
#include "core/write/lookup_side.h"
#include "ui/record/record_assembly.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace axiscomp::ui {

namespace {

using MeasuredWith = FitChoices::MeasuredWith;
using Onto = FitChoices::Onto;

/// More than a screen has columns of pixels.
constexpr std::size_t mostDrawn = 4000;
/// Marks that can still be told apart.
constexpr std::size_t mostMarks = 2000;

auto cannotFit(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

TableLayout layoutOf(const FitDrive& drive)
{
    return drive.profile ? drive.profile->layout : genericTableLayout();
}

/// The tables of a file, as they are opened on the tab Write.
Result<TablesOfFile> readTables(const QString& path, const FitRequest& request,
    std::optional<LookupAt> lookupAt, const std::stop_token& stop)
{
    const QFileInfo info(path);
    const std::string name = info.fileName().toStdString();
    if (path.isEmpty())
        return cannotFit(AXISCOMP_TEXT("Error", "choose the file of the table that was active"));
    const TableLayout layout = layoutOf(request.drive);
    const Measurement& measurement = *request.measurement;
    TableImportRequest import;
    import.file = info.filesystemAbsoluteFilePath();
    import.dimensions = measurement.kind == MeasurementKind::Points
        ? static_cast<int>(measurement.points.axes.size())
        : 1;
    import.layout = &layout;
    import.choices.place.lookupAt = lookupAt;
    import.stop = stop;
    const TableImport read = importTables(import);
    if (read.isCancelled)
        return fail(ErrorCode::Cancelled);
    if (read.data)
        return tablesOfFile(
            name, *read.data, std::string(positionUnit(measurement)), layout, lookupAt);
    const auto problem = std::ranges::find(read.problems, Severity::Error, &Diagnostic::severity);
    Text reason = AXISCOMP_TEXT("Error", "its content cannot be used");
    if (read.refusal && read.refusal->code == ErrorCode::SignNotStated)
        reason = AXISCOMP_TEXT("Error",
            "nobody has published the sign of its format. Import it on Write, where you state the "
            "sign, export it from there as a calibration file, and choose that");
    else if (read.refusal)
        reason = textOf(*read.refusal);
    else if (problem != read.problems.end())
        reason = textOf(*problem);
    return cannotFit(AXISCOMP_TEXT("Error", "{file} cannot be used as the table: {reason}")
                         .with("file", Verbatim{name})
                         .with("reason", std::move(reason)));
}

/// One fit, step by step into its outcome.
class Fitting {
public:
    Fitting(FitOutcome& outcome, std::stop_token stop)
        : m_outcome(outcome)
        , m_request(outcome.request)
        , m_choices(outcome.request.record.fit)
        , m_measurement(*outcome.request.measurement)
        , m_stop(std::move(stop))
    {
    }

    [[nodiscard]] Result<void> run()
    {
        chooseSettings();
        AXISCOMP_CHECK(readKnown());
        AXISCOMP_TRY(const auto state,
            findState({m_measurement.header.compensation, m_stated, hasRawReadings(m_measurement),
                m_hasOnto ? &m_outcome.known.front() : nullptr,
                std::span(m_outcome.known).subspan(m_hasOnto ? 1 : 0), {},
                m_measurement.header.compensationOfSome}));
        AXISCOMP_TRY(auto report, fitMeasurement(m_measurement, m_outcome.settings, state, m_stop));
        for (const FittedTable& made : report.tables) {
            AXISCOMP_TRY(const auto crc, elementCrc(made.table, layoutOf(m_request.drive)));
            m_outcome.crcs.push_back(crc);
            m_outcome.tables.push_back(
                loaded(std::make_shared<const CompensationTable>(made.table)));
        }
        m_outcome.isComputed = !isReferenceReadAtLargest(
            m_measurement, m_request.record.corrections, m_outcome.settings, report);
        m_outcome.report = std::move(report);
        draw();
        return {};
    }

private:
    [[nodiscard]] std::optional<LookupAt> lookupAt() const;
    void chooseSettings();
    [[nodiscard]] Result<void> readKnown();
    [[nodiscard]] Result<void> readDrive();
    void draw();
    void drawCurve();

    FitOutcome& m_outcome;
    const FitRequest& m_request;
    const FitChoices& m_choices;
    const Measurement& m_measurement;
    std::stop_token m_stop;
    std::optional<MeasuredState> m_stated;
    bool m_hasOnto = false; ///< it is the first of those known
};

/// As it is chosen, or by the source of the drive.
std::optional<LookupAt> Fitting::lookupAt() const
{
    const std::optional<LookupAt> chosen = m_choices.settings.lookupAt;
    return chosen ? chosen : m_request.drive.lookupAt();
}

void Fitting::chooseSettings()
{
    FitSettings settings = m_choices.areLengthsAngles == m_measurement.isAngular
        ? m_choices.settings
        : withoutLengths(m_choices.settings);
    settings.lookupAt = lookupAt();
    // A limit of 10 um is none of an angle.
    if (m_request.record.areLimitsAngles == m_measurement.isAngular) {
        settings.tolerances = m_request.record.tolerances;
        settings.uncertainty = m_request.record.uncertainty;
    }
    settings.outlierRule = m_request.record.outlierRule;
    if (m_request.drive.profile)
        settings.mostPoints = m_request.drive.profile->mostPoints();
    if (m_choices.onto == Onto::Nothing)
        settings.gain = 1.0;
    m_outcome.settings = settingsFor(m_measurement, std::move(settings));
}

Result<void> Fitting::readDrive()
{
    const FitDrive& drive = m_request.drive;
    if (!drive.axis || !drive.profile)
        return cannotFit(AXISCOMP_TEXT("Error",
            "there is no axis whose table the residuals could be merged onto; choose one, or take "
            "the file of the table"));
    if (drive.held && !drive.table)
        return cannotFit(
            AXISCOMP_TEXT("Error", "the table of the axis is still being read from the drive"));
    if (!drive.table)
        return fail(ErrorCode::NoTable, {{"axis", std::to_string(drive.axis->axis.index)}});
    AXISCOMP_CHECK(
        checkMeasuredDrive(driveSerialOf(m_measurement.header), drive.axis->serialNumber));
    if (m_choices.settings.lookupAt)
        AXISCOMP_CHECK(
            checkLookupAt(*m_choices.settings.lookupAt, *drive.profile, drive.axis->source));
    const DriveStore store(drive.storeRoot);
    AXISCOMP_TRY(auto tables,
        tablesOfAxis(*drive.axis, *drive.table, *drive.profile, store,
            std::string(positionUnit(m_measurement))));
    m_outcome.known.push_back(std::move(tables.active));
    std::ranges::move(tables.backups, std::back_inserter(m_outcome.known));
    m_outcome.remarks = std::move(tables.remarks);
    for (const Error& error : tables.unreadable)
        m_outcome.remarks.push_back(textOf(error));
    return {};
}

Result<void> Fitting::readKnown()
{
    m_hasOnto = m_choices.onto != Onto::Nothing;
    if (m_choices.onto == Onto::Drive) {
        AXISCOMP_CHECK(readDrive());
    } else if (m_choices.onto == Onto::File) {
        AXISCOMP_TRY(auto tables, readTables(m_choices.ontoFile, m_request, lookupAt(), m_stop));
        m_outcome.known.push_back(std::move(tables.tables));
        m_outcome.remarks = std::move(tables.remarks);
    }
    const bool isAsked = m_measurement.header.compensation.kind == MeasuredState::Kind::NotSaid
        && !hasRawReadings(m_measurement);
    if (!isAsked)
        return {};
    if (m_choices.measuredWith == MeasuredWith::Off)
        m_stated = MeasuredState{MeasuredState::Kind::Off, {}};
    else if (m_choices.measuredWith == MeasuredWith::On)
        m_stated = MeasuredState{MeasuredState::Kind::On, {}};
    if (m_choices.measuredWith != MeasuredWith::File)
        return {};
    AXISCOMP_TRY(
        auto tables, readTables(m_choices.measuredWithFile, m_request, lookupAt(), m_stop));
    // Columns of points have a table each, all of which were active.
    std::size_t stated = 0;
    if (m_measurement.kind != MeasurementKind::Points) {
        AXISCOMP_TRY(stated, tableOfAxis(tables.tables, m_measurement.header.axis));
    }
    m_stated = statedTable(tables.tables, stated, m_measurement.header);
    m_outcome.known.push_back(std::move(tables.tables));
    return {};
}

/// Every so many, ends included.
template <typename T> std::vector<T> thinned(std::vector<T> all, std::size_t most)
{
    if (all.size() <= most)
        return all;
    std::vector<T> some;
    for (std::size_t i = 0; i < most; ++i)
        some.push_back(all[i * (all.size() - 1) / (most - 1)]);
    return some;
}

/// The lowest and the highest value of each part: no peak is lost.
void Fitting::drawCurve()
{
    const CompensationTable& table = *m_outcome.tables.front().table;
    const GridAxis& axis = table.grid.axes.front();
    const std::size_t count = table.values.size();
    const auto add = [&](std::size_t i) {
        m_outcome.drawing.curve.push_back({axis.position(i), static_cast<double>(table.values[i])});
    };
    const std::size_t parts = mostDrawn / 2;
    const std::size_t length = count <= mostDrawn ? 1 : (count + parts - 1) / parts;
    for (std::size_t from = 0; from < count; from += length) {
        const auto begin = table.values.begin() + static_cast<std::ptrdiff_t>(from);
        const auto end =
            table.values.begin() + static_cast<std::ptrdiff_t>(std::min(from + length, count));
        const auto [low, high] = std::minmax_element(begin, end);
        const auto [first, second] = std::minmax(low, high);
        add(static_cast<std::size_t>(first - table.values.begin()));
        if (second != first)
            add(static_cast<std::size_t>(second - table.values.begin()));
    }
}

void Fitting::draw()
{
    FitDrawing& drawing = m_outcome.drawing;
    const FitReport& report = *m_outcome.report;
    if (m_measurement.kind == MeasurementKind::Points) {
        const MeasuredPoints& points = m_measurement.points;
        drawing.pointCount = points.size();
        std::vector<std::array<double, 3>> places(points.size());
        for (std::size_t axis = 0; axis < points.positions.size(); ++axis)
            for (std::size_t i = 0; i < places.size(); ++i)
                places[i].at(axis) = points.positions[axis][i];
        drawing.places = thinned(std::move(places), mostMarks);
        return;
    }
    drawCurve();
    auto points = fittedPoints(m_measurement, m_outcome.settings, report);
    drawing.pointCount = points.size();
    drawing.points = thinned(std::move(points), mostMarks);
    if (report.heldOut) {
        drawing.heldOutCount = report.heldOut->residuals.size();
        drawing.heldOut = thinned(report.heldOut->residuals, mostMarks);
    }
}

bool isSameAxis(const std::optional<AxisOfDrive>& a, const std::optional<AxisOfDrive>& b)
{
    if (!a || !b)
        return a.has_value() == b.has_value();
    return a->axis.index == b->axis.index && a->axis.name == b->axis.name
        && a->axis.unit == b->axis.unit && a->serialNumber == b->serialNumber
        && a->source == b->source && a->sources == b->sources;
}

} // namespace

std::optional<LookupAt> FitDrive::lookupAt() const
{
    if (!profile || !axis || axis->source.empty())
        return std::nullopt;
    return lookupAtSource(*profile, axis->source);
}

std::optional<HeldTable> FitDrive::heldTable() const
{
    if (!axis || !held)
        return std::nullopt;
    return HeldTable{axis->serialNumber, axis->axis.index, *held};
}

bool isSameDrive(const FitDrive& a, const FitDrive& b)
{
    return a.profile == b.profile && a.storeRoot == b.storeRoot && a.table == b.table
        && a.heldTable() == b.heldTable() && isSameAxis(a.axis, b.axis);
}

std::shared_ptr<const FitOutcome> fitted(const FitRequest& request, const std::stop_token& stop)
{
    auto outcome = std::make_shared<FitOutcome>();
    outcome->request = request;
    if (const auto done = Fitting(*outcome, stop).run(); !done) {
        outcome->refusal = done.error();
        outcome->report.reset();
        outcome->tables.clear();
        outcome->crcs.clear();
    }
    return outcome;
}

MadeTables madeTables(const FitOutcome& outcome, std::size_t wanted)
{
    auto data = std::make_shared<CalibrationData>();
    data->grid = outcome.tables[wanted].table->grid;
    data->tables.push_back(*outcome.tables[wanted].table);
    for (std::size_t n = 0; n < outcome.tables.size(); ++n)
        if (n != wanted)
            data->tables.push_back(*outcome.tables[n].table);
    data->notes = notesOf(outcome);
    MadeTables made;
    made.data = data;
    made.lookupAt = outcome.report->lookupAt;
    made.isComputed = outcome.isComputed;
    // One after the other shares the data, and knows its largest value already.
    made.tables.push_back({{data, &data->tables[0]}, outcome.tables[wanted].largestElement});
    for (std::size_t n = 0, next = 1; n < outcome.tables.size(); ++n)
        if (n != wanted)
            made.tables.push_back(
                {{data, &data->tables[next++]}, outcome.tables[n].largestElement});
    made.name = QCoreApplication::translate("axiscomp::ui::FitOutcome", "fit of %1")
                    .arg(QFileInfo(outcome.request.files.front().file.path).fileName());
    return made;
}

std::vector<std::string> notesOf(const FitOutcome& outcome)
{
    std::string sources;
    for (const ReadMeasurement& file : outcome.request.files)
        sources += (sources.empty() ? "" : ", ")
            + QFileInfo(file.file.path).fileName().toStdString() + " ("
            + std::string(file.format->facts.name) + ')';
    return notesOfFit(sources, *outcome.request.measurement, outcome.settings, *outcome.report);
}

std::shared_ptr<const CalibrationRecord> calibrationOf(const FitOutcome& outcome)
{
    RecordState state;
    state.record = outcome.request.record;
    state.files = outcome.request.files;
    auto before = recordedMeasurement(state);
    if (!before)
        return nullptr;
    return std::make_shared<const CalibrationRecord>(
        recordOfFit(*std::move(before), outcome.settings, *outcome.report,
            "axiscomp " AXISCOMP_VERSION, std::chrono::system_clock::now()));
}

} // namespace axiscomp::ui
