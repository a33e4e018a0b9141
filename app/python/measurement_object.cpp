// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/measurement_object.h"

#include "app/cli/output/judgement_output.h"
#include "app/python/command_run.h"
#include "app/python/json_object.h"
#include "app/python/table_object.h"
#include "core/compensator/known_tables.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/header_texts.h"
#include "core/text/number_text.h"
#include "drivecomm/profile/profile_loader.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace axiscomp::app {

namespace py = pybind11;

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// values: [run][target], NaN where nothing was measured.
void addRuns(Measurement& measurement, Approach direction, const Numbers& values)
{
    const auto targets = static_cast<py::ssize_t>(measurement.targets.size());
    if (values.ndim() != 2 || values.shape(1) != targets)
        throw py::value_error("the deviations are an array of runs x targets, with "
            + std::to_string(targets) + " targets");
    for (py::ssize_t run = 0; run < values.shape(0); ++run)
        for (py::ssize_t target = 0; target < targets; ++target) {
            const double deviation = values.at(run, target);
            if (std::isinf(deviation))
                throw py::value_error("a deviation is infinite");
            if (!std::isnan(deviation))
                measurement.values.push_back({.target = static_cast<std::size_t>(target),
                    .direction = direction,
                    .run = static_cast<int>(run) + 1,
                    .deviation = deviation});
        }
}

/// What has no value is not in the file: the numbers of targets and runs would be others than those
/// of the arrays.
void checkIsMeasured(const Measurement& measurement, const Numbers& up, const Numbers& down)
{
    if (measurement.values.empty())
        throw py::value_error("the measurement has no value");
    std::vector<bool> isMeasured(measurement.targets.size(), false);
    for (const RunValue& value : measurement.values)
        isMeasured[value.target] = true;
    for (std::size_t n = 0; n < isMeasured.size(); ++n)
        if (!isMeasured[n])
            throw py::value_error("no run has a value at the target "
                + toText(measurement.targets[n]) + ": leave the target out");
    const auto check = [&](Approach direction, const Numbers& runs, const char* name) {
        if (measurement.lastRun(direction) != runs.shape(0))
            throw py::value_error(
                std::string("the last run of ") + name + " has no value: leave the run out");
    };
    check(Approach::Up, up, "up");
    check(Approach::Down, down, "down");
}

void takeTargets(Measurement& measurement, const Numbers& targets)
{
    if (targets.ndim() != 1 || targets.size() < 1)
        throw py::value_error("the targets are an array of one dimension");
    measurement.targets.assign(targets.data(), targets.data() + targets.size());
    for (std::size_t i = 0; i < measurement.targets.size(); ++i)
        if (!std::isfinite(measurement.targets[i])
            || (i > 0 && measurement.targets[i] <= measurement.targets[i - 1]))
            throw py::value_error("the targets are finite and ascend");
}

void takeStatements(Measurement& measurement, const std::map<std::string, std::string>& statements)
{
    MeasurementHeader& header = measurement.header;
    for (const auto& [key, value] : statements) {
        refuseControl(value, "the statement " + key);
        if (key == "compensation") {
            if (value != "off" && value != "on")
                throw py::value_error("compensation is on or off");
            header.compensation.kind =
                value == "off" ? MeasuredState::Kind::Off : MeasuredState::Kind::On;
            continue;
        }
        if (key == "kind") {
            if (value != "runs" && value != "averages")
                throw py::value_error("kind is runs or averages");
            measurement.kind = value == "runs" ? MeasurementKind::Runs : MeasurementKind::Averages;
            continue;
        }
        const auto text = std::ranges::find(headerTexts, key, &HeaderText::key);
        if (text == headerTexts.end())
            throw py::value_error("a measurement has no statement " + key);
        header.*text->member = value;
    }
}

py::bytes csvOfRuns(const Numbers& targets, const Numbers& up, const Numbers& down, bool isAngular,
    const std::map<std::string, std::string>& statements)
{
    Measurement measurement;
    measurement.isAngular = isAngular;
    takeTargets(measurement, targets);
    addRuns(measurement, Approach::Up, up);
    addRuns(measurement, Approach::Down, down);
    checkIsMeasured(measurement, up, down);
    takeStatements(measurement, statements);
    return py::bytes(writeRunsCsv(measurement));
}

py::array_t<double> runsOf(const Measurement& measurement, Approach direction)
{
    const auto targets = static_cast<py::ssize_t>(measurement.targets.size());
    py::array_t<double> values({static_cast<py::ssize_t>(measurement.lastRun(direction)), targets});
    std::fill_n(values.mutable_data(), values.size(), std::numeric_limits<double>::quiet_NaN());
    for (const RunValue& value : measurement.values)
        if (value.direction == direction && value.isUsed)
            values.mutable_at(value.run - 1, static_cast<py::ssize_t>(value.target)) =
                value.deviation;
    return values;
}

/// Of a file that axiscomp has written itself.
Measurement measurementOf(const py::bytes& file)
{
    const auto format = measurementFormatNamed("runs");
    if (!format)
        raiseError(format.error());
    MeasurementReading reading;
    {
        const auto text = static_cast<std::string_view>(file);
        const py::gil_scoped_release released;
        reading = (*format)->read(text, {});
    }
    if (!reading.measurement)
        raiseError(measurementError("measurement", reading), diagnosticsJson(reading.diagnostics));
    return *std::move(reading.measurement);
}

py::dict arraysOf(const Measurement& measurement)
{
    py::dict parts;
    parts["targets"] = py::array_t<double>(
        static_cast<py::ssize_t>(measurement.targets.size()), measurement.targets.data());
    parts["up"] = runsOf(measurement, Approach::Up);
    parts["down"] = runsOf(measurement, Approach::Down);
    parts["kind"] = pythonText(measurementKindName(measurement.kind));
    parts["unit"] = measurement.isAngular ? "deg" : "mm";
    return parts;
}

py::dict runsOfCsv(const py::bytes& file)
{
    return arraysOf(measurementOf(file));
}

/// Nobody would read what is assumed of a unit. Errors: UnitMismatch.
void checkUnits(const CompensationTable& table, const std::string& wanted)
{
    const auto check = [&wanted](const std::string& unit, Text what) {
        if (unit.empty())
            raiseError(fail(ErrorCode::UnitMismatch,
                {{"what", std::move(what)},
                    {"unit", AXISCOMP_TEXT("Error", "a unit that is not stated")},
                    {"other", wanted}})
                           .value());
    };
    check(table.unit, AXISCOMP_TEXT("Error", "values"));
    for (std::size_t n = 0; n < table.grid.axes.size(); ++n)
        check(table.grid.axes[n].unit,
            AXISCOMP_TEXT("Error", "positions of dimension {number}").with("number", n + 1));
}

/// In the unit of the measurement.
KnownTables knownTable(
    const char* name, const TablePointer& table, const Measurement& measurement, LookupAt lookupAt)
{
    checkUnits(table->table, std::string(positionUnit(measurement)));
    const CalibrationData data{table->table.grid, {table->table}, table->notes};
    return valueOf(tablesOfFile(name, data, std::string(positionUnit(measurement)),
                       drivecomm::genericProfile().layout, lookupAt))
        .tables;
}

LookupAt lookupNamed(const std::string& name)
{
    if (name == "encoder")
        return LookupAt::Encoder;
    if (name == "set")
        return LookupAt::Set;
    throw py::value_error("lookup_at is encoder or set, not " + name);
}

/// active: the table with which it was measured, as a person says it; isOff: with none.
py::dict predict(const py::bytes& file, const TablePointer& table, const std::string& lookupAt,
    const TablePointer& active, bool isOff, std::optional<double> turn)
{
    const Measurement measurement = measurementOf(file);
    const LookupAt side = lookupNamed(lookupAt);
    const KnownTables wanted = knownTable("the table", table, measurement, side);
    std::optional<KnownTables> onto;
    StateRequest request{measurement.header.compensation, {}, hasRawReadings(measurement)};
    if (active) {
        onto = knownTable("the active table", active, measurement, side);
        request.stated = statedTable(*onto, 0, measurement.header);
        request.onto = &*onto;
    } else if (isOff) {
        request.stated = MeasuredState{MeasuredState::Kind::Off, {}};
    }
    const FoundState state = valueOf(findState(request));
    const Measurement predicted =
        valueOf(predictMeasurement(measurement, wanted.tables.front(), side, state, turn));
    py::dict parts = arraysOf(predicted);
    parts["figures"] = pythonObject(axisFiguresJson(iso230Figures(predicted)));
    return parts;
}

} // namespace

void addMeasurements(py::module_& module)
{
    module.def("csv_of_runs", &csvOfRuns, py::arg("targets"), py::arg("up"), py::arg("down"),
        py::arg("is_angular"), py::arg("statements"));
    module.def("runs_of_csv", &runsOfCsv, py::arg("file"));
    module.def("predict", &predict, py::arg("file"), py::arg("table").none(false),
        py::arg("lookup_at"), py::arg("active"), py::arg("is_off"), py::arg("turn"));
}

} // namespace axiscomp::app
