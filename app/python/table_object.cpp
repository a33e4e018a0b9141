// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/table_object.h"

#include "app/python/command_run.h"
#include "app/python/json_object.h"
#include "app/python/made_object.h"
#include "core/csv/calibration_csv.h"
#include "core/neutral/drive_note.h"
#include "core/neutral/lookup_note.h"
#include "core/table/lookup.h"
#include "core/table/tam_table.h"
#include "core/table/target_axis.h"
#include "core/text/number_text.h"
#include "drivecomm/profile/profile_loader.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace axiscomp::app {

namespace py = pybind11;

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// Dimension 1 fastest, as a table has its values.
using Values = py::array_t<double, py::array::f_style | py::array::forcecast>;

std::uint32_t crcOf(const CompensationTable& table)
{
    return valueOf(elementCrc(table, drivecomm::genericProfile().layout));
}

Outside outsideNamed(const std::string& name)
{
    if (name == "hold")
        return Outside::Hold;
    if (name == "zero")
        return Outside::Zero;
    if (name == "wrap")
        return Outside::Wrap;
    if (name == "extrapolate")
        return Outside::Extrapolate;
    if (name == "error")
        return Outside::Error;
    throw py::value_error("outside is hold, zero, wrap, extrapolate or error, not " + name);
}

std::vector<py::ssize_t> shapeOf(const Grid& grid)
{
    std::vector<py::ssize_t> shape;
    for (const GridAxis& axis : grid.axes)
        shape.push_back(static_cast<py::ssize_t>(axis.size));
    return shape;
}

py::array valuesView(const py::object& self)
{
    const TablePointer object = madeObject<TableObject>(self);
    const CompensationTable& table = object->table;
    std::vector<py::ssize_t> strides;
    py::ssize_t stride = sizeof(float);
    for (const GridAxis& axis : table.grid.axes) {
        strides.push_back(stride);
        stride *= static_cast<py::ssize_t>(axis.size);
    }
    py::array_t<float> view(shapeOf(table.grid), strides, table.values.data(), self);
    view.attr("setflags")(py::arg("write") = false);
    return view;
}

/// Errors: ValueError where something is masked, whose number would be taken as it stands.
void refuseMasked(const py::object& given, const char* reason)
{
    const py::module_ masked = py::module_::import("numpy.ma");
    // asarray: a list of masked arrays is not masked itself
    if (masked.attr("is_masked")(masked.attr("asarray")(given)).cast<bool>())
        throw py::value_error(reason);
}

/// Errors: TypeError for what numpy would make real numbers of, and drop a part or give a unit.
void refuseOtherNumbers(const py::object& given)
{
    const py::object type = py::module_::import("numpy").attr("asarray")(given).attr("dtype");
    if (std::string("cMm").find(type.attr("kind").cast<std::string>()) != std::string::npos)
        throw py::type_error("real numbers are needed, not " + py::str(type).cast<std::string>());
}

/// One value for each position, on all processors and without the interpreter's lock.
py::array_t<double> lookedUp(
    const TableObject& object, const py::object& given, const std::string& outside)
{
    refuseMasked(given, "a position is masked: nothing is looked up there");
    refuseOtherNumbers(given);
    const Numbers positions(given);
    const CompensationTable& table = object.table;
    const Lookup lookup(table, outsideNamed(outside));
    const auto dimensions = static_cast<py::ssize_t>(table.grid.axes.size());
    const py::ssize_t rank = positions.ndim();
    std::vector<py::ssize_t> shape(positions.shape(), positions.shape() + rank);
    if (dimensions > 1) {
        if (rank == 0 || shape.back() != dimensions)
            throw py::value_error("the last dimension of the positions has "
                + std::to_string(rank == 0 ? 0 : shape.back()) + " numbers, but the table has "
                + std::to_string(dimensions) + " dimensions");
        shape.pop_back();
    }
    py::array_t<double> answer(shape);
    const double* const from = positions.data();
    double* const to = answer.mutable_data();
    const auto count = static_cast<std::size_t>(answer.size());
    const auto width = static_cast<std::size_t>(dimensions);
    const py::gil_scoped_release released;
    lookup.atEach({from, count * width}, {to, count});
    return answer;
}

py::array_t<double> positionsOf(const TableObject& object, std::size_t dimension)
{
    const auto& axes = object.table.grid.axes;
    if (dimension < 1 || dimension > axes.size())
        throw py::index_error("the table has dimensions 1 to " + std::to_string(axes.size()));
    const GridAxis& axis = axes[dimension - 1];
    py::array_t<double> positions(static_cast<py::ssize_t>(axis.size));
    double* const to = positions.mutable_data();
    for (std::size_t i = 0; i < axis.size; ++i)
        to[i] = axis.position(i);
    return positions;
}

GridAxis axisFrom(const py::handle& given, py::ssize_t size)
{
    GridAxis axis;
    const py::sequence parts = given.cast<py::sequence>();
    if (parts.size() < 2 || parts.size() > 5)
        throw py::value_error("an axis is (start, distance), (start, distance, unit), "
                              "(start, distance, unit, name) or an Axis");
    py::ssize_t stated = 0; // not stated
    try {
        axis.start = parts[0].cast<double>();
        axis.distance = parts[1].cast<double>();
        if (parts.size() > 2)
            axis.unit = parts[2].cast<std::string>();
        if (parts.size() > 3)
            axis.name = parts[3].cast<std::string>();
        if (parts.size() > 4)
            stated = parts[4].cast<py::ssize_t>();
    } catch (const py::cast_error&) {
        throw py::type_error("start and distance of an axis are numbers, unit and name are texts, "
                             "and its size is a whole number");
    }
    if (stated != 0 && stated != size)
        throw py::value_error("an axis has " + std::to_string(stated) + " points, and there are "
            + std::to_string(size) + " values along it");
    axis.size = static_cast<std::uint32_t>(size);
    return axis;
}

/// Errors: of numpy, ValueError for masked values, TypeError for complex ones and times.
Values valuesFrom(const py::object& given)
{
    refuseMasked(given, "a value is masked: a table has a value at each point");
    refuseOtherNumbers(given);
    return Values(given);
}

/// As a table has them. Errors: InvalidArgument for a number that no float32 is; numpy would make
/// it infinite.
std::vector<float> roundedValues(const Values& values)
{
    constexpr auto largest = static_cast<double>(std::numeric_limits<float>::max());
    std::vector<float> rounded(static_cast<std::size_t>(values.size()));
    const double* const from = values.data();
    for (std::size_t i = 0; i < rounded.size(); ++i) {
        if (std::isfinite(from[i]) && std::abs(from[i]) > largest)
            raiseError(fail(ErrorCode::InvalidArgument,
                {{"reason",
                    "value " + std::to_string(i + 1) + " is " + shortestText(from[i])
                        + ", which is beyond what a float32 can be (3.4e38)"}})
                           .value());
        rounded[i] = static_cast<float>(from[i]);
    }
    return rounded;
}

/// Each point once. Errors: TypeError for what is no index; of a mask True and False would be the
/// points 1 and 0. ValueError for a point that the table does not have.
std::vector<std::uint32_t> pointsFrom(const py::iterable& given, std::size_t count)
{
    std::vector<std::uint32_t> points;
    for (const py::handle element : given) {
        const bool isOfMask = py::isinstance<py::bool_>(element)
            || (py::hasattr(element, "dtype")
                && element.attr("dtype").attr("kind").cast<std::string>() == "b");
        if (isOfMask || PyIndex_Check(element.ptr()) == 0)
            throw py::type_error("filled has indices of points, dimension 1 fastest, not "
                + py::str(py::type::of(element).attr("__name__")).cast<std::string>()
                + "; of a mask they are numpy.flatnonzero(mask.ravel(\"F\"))");
        const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(element.ptr()));
        if (!index)
            throw py::error_already_set();
        int isTooLarge = 0;
        const long long point = PyLong_AsLongLongAndOverflow(index.ptr(), &isTooLarge);
        if (isTooLarge != 0 || point < 0 || static_cast<unsigned long long>(point) >= count)
            throw py::value_error("a point of filled is beyond the table");
        points.push_back(static_cast<std::uint32_t>(point));
    }
    std::ranges::sort(points);
    points.erase(std::ranges::unique(points).begin(), points.end());
    return points;
}

void refuseControls(const TableObject& object)
{
    const CompensationTable& table = object.table;
    refuseControl(table.name, "the name");
    refuseControl(table.unit, "the unit");
    refuseControl(table.target, "the target");
    for (const GridAxis& axis : table.grid.axes) {
        refuseControl(axis.name, "the name of an axis");
        refuseControl(axis.unit, "the unit of an axis");
    }
    for (const std::string& note : object.notes)
        refuseControl(note, "a note");
}

/// Errors: ValueError for "#2" of one dimension, which no file could say.
void checkTarget(const std::string& target, py::ssize_t dimensions)
{
    for (py::ssize_t n = dimensions + 1; n <= 3; ++n)
        if (target == sourceTarget(static_cast<std::size_t>(n - 1)))
            throw py::value_error("the target " + target
                + " is no dimension of the table, which has " + std::to_string(dimensions));
}

TablePointer makeTable(const py::object& given, const py::sequence& axes, const std::string& name,
    const std::string& unit, const std::string& target, const py::iterable& filled,
    const std::vector<std::string>& notes)
{
    const Values values = valuesFrom(given);
    if (values.ndim() < 1 || values.ndim() > 3)
        throw py::value_error("the values have 1, 2 or 3 dimensions");
    if (static_cast<py::ssize_t>(axes.size()) != values.ndim())
        throw py::value_error("the values have " + std::to_string(values.ndim())
            + " dimensions, but there are " + std::to_string(axes.size()) + " axes");
    checkTarget(target, values.ndim());
    auto object = std::make_shared<TableObject>();
    object->notes = notes;
    CompensationTable& table = object->table;
    table.name = name;
    table.unit = unit;
    std::vector<std::string> sources;
    for (py::ssize_t n = 0; n < values.ndim(); ++n) {
        table.grid.axes.push_back(axisFrom(axes[static_cast<std::size_t>(n)], values.shape(n)));
        sources.push_back(table.grid.axes.back().name);
    }
    table.target = statedOrInHeader(target, name, sources);
    refuseControls(*object);
    table.values = roundedValues(values);
    table.filled = pointsFrom(filled, table.values.size());
    static_cast<void>(crcOf(table)); // the rules of a table
    for (const GridAxis& axis : table.grid.axes)
        if (!pointsAreDistinct(axis))
            throw py::value_error("the distance of an axis is below the resolution of numbers");
    return object;
}

/// Of the notes only the side counts: with it the values are others.
bool isSame(const TableObject& one, const TableObject& other)
{
    return one.table == other.table
        && lookupInNotes(one.notes).value_or(std::nullopt)
        == lookupInNotes(other.notes).value_or(std::nullopt);
}

py::list axesOf(const TableObject& object)
{
    const py::object type = py::module_::import("axiscomp.tables").attr("Axis");
    py::list list;
    for (const GridAxis& axis : object.table.grid.axes)
        list.append(type(
            axis.start, axis.distance, pythonText(axis.unit), pythonText(axis.name), axis.size));
    return list;
}

std::string described(const TableObject& object)
{
    const CompensationTable& table = object.table;
    std::string text = "<axiscomp.Table \"" + table.name + "\" [" + table.unit + "]:";
    for (const GridAxis& axis : table.grid.axes)
        text += " " + std::to_string(axis.size) + " from "
            + py::str(py::float_(axis.start)).cast<std::string>() + " to "
            + py::str(py::float_(axis.last())).cast<std::string>() + " [" + axis.unit + "]";
    return text + ">";
}

/// Everything that the object has, for pickle.
py::tuple stateOf(const py::object& self)
{
    const TablePointer object = madeObject<TableObject>(self);
    const CompensationTable& table = object->table;
    py::list axes;
    for (const GridAxis& axis : table.grid.axes)
        axes.append(py::make_tuple(axis.start, axis.distance, axis.unit, axis.name));
    py::list filled;
    for (const std::uint32_t point : table.filled)
        filled.append(point);
    // A view must not go into a file.
    return py::make_tuple(valuesView(self).attr("copy")("F"), axes, table.name, table.unit,
        table.target, filled, pythonTexts(object->notes));
}

/// Errors: ValueError, since in one file the notes of one table are those of all.
void checkSameStatements(const TableObject& one, const TableObject& other)
{
    if (valueOf(lookupInNotes(one.notes)) != valueOf(lookupInNotes(other.notes)))
        throw py::value_error(
            "the tables of one file say the same in their notes of where they are "
            "looked up (lookup: encoder, lookup: set, or nothing): give each "
            "alone, or make them with the same notes");
    if (valueOf(measuredDriveInNotes(one.notes)) != valueOf(measuredDriveInNotes(other.notes)))
        throw py::value_error(
            "the tables of one file say the same in their notes of which drive was "
            "measured (drive: NAME, serial number N, or nothing): give each "
            "alone, or make them with the same notes");
}

CalibrationData dataOf(const std::vector<TablePointer>& tables)
{
    if (tables.empty())
        throw py::value_error("there is no table");
    if (std::ranges::find(tables, nullptr) != tables.end())
        throw py::type_error("None is no table");
    CalibrationData data{tables.front()->table.grid, {}, {}};
    for (const TablePointer& object : tables) {
        if (object->table.grid != data.grid)
            throw py::value_error("the tables of one file have the same axes and units");
        if (object != tables.front())
            checkSameStatements(*tables.front(), *object);
        data.tables.push_back(object->table);
        if (object == tables.front() || object->notes != tables.front()->notes)
            data.notes.insert(data.notes.end(), object->notes.begin(), object->notes.end());
    }
    for (const CompensationTable& table : data.tables) {
        if (table.filled.empty())
            continue;
        const std::string note = filledNote(table.name, table.filled.size(), table.values.size());
        if (std::ranges::find(data.notes, note) == data.notes.end())
            data.notes.push_back(note);
    }
    return data;
}

py::bytes csvOf(const std::vector<TablePointer>& tables)
{
    const CalibrationData data = dataOf(tables);
    std::string text;
    {
        const py::gil_scoped_release released;
        text = writeCalibrationCsv(data);
    }
    return py::bytes(text);
}

/// Of a file that axiscomp has written itself.
std::vector<TablePointer> tablesOfCsv(const py::bytes& file, int dimensions)
{
    if (dimensions < 1 || dimensions > 3)
        throw py::value_error("a table has 1, 2 or 3 dimensions");
    const auto text = static_cast<std::string_view>(file);
    CsvReading reading;
    {
        const py::gil_scoped_release released;
        CsvOptions options;
        options.dimensions = dimensions;
        reading = parseCalibrationCsv(text, options);
    }
    if (!reading.data) {
        raiseError({ErrorCode::InvalidCalibration,
                       {{"file", Verbatim{"table"}}, {"count", reading.diagnostics.size()}}, {}},
            diagnosticsJson(reading.diagnostics));
    }
    std::vector<TablePointer> tables;
    for (CompensationTable& table : reading.data->tables) {
        tables.push_back(std::make_shared<TableObject>());
        tables.back()->table = std::move(table);
        tables.back()->notes = reading.data->notes;
    }
    return tables;
}

} // namespace

void addTables(py::module_& module)
{
    py::class_<TableObject, TablePointer> table(module, "Table");
    table
        .def(py::init(&makeTable), py::arg("values"), py::arg("axes"), py::arg("name") = "Table",
            py::arg("unit") = "", py::arg("target") = "", py::arg("filled") = py::tuple(),
            py::arg("notes") = std::vector<std::string>())
        .def_property_readonly("values", &valuesView)
        .def_property_readonly("axes", methodOf(&axesOf))
        .def_property_readonly(
            "name", methodOf(+[](const TableObject& self) { return pythonText(self.table.name); }))
        .def_property_readonly(
            "unit", methodOf(+[](const TableObject& self) { return pythonText(self.table.unit); }))
        .def_property_readonly("target",
            methodOf(+[](const TableObject& self) { return pythonText(self.table.target); }))
        .def_property_readonly("dimensions",
            methodOf(+[](const TableObject& self) { return self.table.grid.dimensions(); }))
        .def_property_readonly(
            "filled", methodOf(+[](const TableObject& self) { return self.table.filled; }))
        .def_property_readonly(
            "notes", methodOf(+[](const TableObject& self) { return pythonTexts(self.notes); }))
        .def_property_readonly(
            "crc", methodOf(+[](const TableObject& self) { return crcOf(self.table); }))
        .def("positions", methodOf(&positionsOf), py::arg("dimension") = 1)
        .def("lookup", methodOf(&lookedUp), py::arg("positions"), py::arg("outside") = "hold")
        .def("__repr__", methodOf(&described))
        .def("__eq__",
            [](const py::object& self, const py::object& other) -> py::object {
                if (!py::isinstance<TableObject>(other))
                    return py::reinterpret_borrow<py::object>(Py_NotImplemented);
                return py::bool_(
                    isSame(*madeObject<TableObject>(self), *madeObject<TableObject>(other)));
            })
        .def("__reduce__", [](const py::object& self) {
            return py::make_tuple(self.attr("__class__"), stateOf(self));
        });
    module.def("tables_of_csv", &tablesOfCsv, py::arg("file"), py::arg("dimensions"));
    module.def("csv_of_tables", &csvOf, py::arg("tables"));
}

} // namespace axiscomp::app
