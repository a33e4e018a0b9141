// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/json_object.h"

#include "app/cli/output/json_output.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::app {

namespace py = pybind11;

Json diagnosticsJson(const std::vector<Diagnostic>& diagnostics)
{
    Json list = Json::array();
    for (const Diagnostic& diagnostic : diagnostics)
        list.push_back(toJson(diagnostic));
    return list;
}

py::str pythonText(std::string_view text)
{
    PyObject* const decoded =
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
    if (!decoded)
        throw py::error_already_set();
    return py::reinterpret_steal<py::str>(decoded);
}

py::list pythonTexts(const std::vector<std::string>& texts)
{
    py::list list;
    for (const std::string& text : texts)
        list.append(pythonText(text));
    return list;
}

py::object pythonObject(const Json& json)
{
    switch (json.type()) {
    case Json::value_t::object: {
        py::dict object;
        for (const auto& [key, value] : json.items())
            object[pythonText(key)] = pythonObject(value);
        return object;
    }
    case Json::value_t::array: {
        py::list list;
        for (const Json& element : json)
            list.append(pythonObject(element));
        return list;
    }
    case Json::value_t::string:
        return pythonText(json.get_ref<const std::string&>());
    case Json::value_t::boolean:
        return py::bool_(json.get<bool>());
    case Json::value_t::number_integer:
        return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_unsigned:
        return py::int_(json.get<std::uint64_t>());
    case Json::value_t::number_float:
        if (const double number = json.get<double>(); std::isfinite(number))
            return py::float_(number);
        return py::none();
    case Json::value_t::null:
    case Json::value_t::binary:
    case Json::value_t::discarded:
        break;
    }
    return py::none();
}

void refuseControl(std::string_view text, const std::string& what)
{
    if (std::ranges::any_of(text, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }))
        throw py::value_error(what + " has a line break or another control character");
}

} // namespace axiscomp::app
