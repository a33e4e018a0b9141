// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/environment.h"
#include "app/python/command_run.h"
#include "app/python/json_object.h"
#include "app/python/made_object.h"
#include "app/python/measurement_object.h"
#include "app/python/table_object.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>

namespace axiscomp::app {

namespace py = pybind11;

namespace {

py::dict optionFacts(const CLI::Option& option)
{
    py::dict facts;
    py::list names;
    for (const std::string& name : option.get_lnames())
        names.append("--" + name);
    facts["names"] = names;
    facts["positional"] = option.get_positional();
    facts["name"] = option.get_positional() ? option.get_name(true) : option.get_name();
    facts["text"] = option.get_option_text();
    facts["description"] = option.get_description();
    facts["required"] = option.get_required();
    facts["takes_value"] = option.get_items_expected_max() > 0;
    facts["several"] = option.get_expected_max() > 1;
    facts["delimiter"] =
        option.get_delimiter() == '\0' ? "" : std::string(1, option.get_delimiter());
    return facts;
}

/// What the command line has, for the functions of commands.py.
py::list commandFacts()
{
    CommandLine line;
    py::list list;
    for (const CLI::App* command : line.parser().get_subcommands({})) {
        py::dict facts;
        facts["name"] = command->get_name();
        facts["group"] = command->get_group();
        facts["description"] = command->get_description();
        facts["footer"] = command->get_footer();
        py::list options;
        for (const CLI::Option* option : command->get_options({}))
            options.append(optionFacts(*option));
        facts["options"] = options;
        list.append(facts);
    }
    return list;
}

py::tuple run(std::vector<std::string> arguments, const py::object& echo, Environment::Names names)
{
    return CommandRun(std::move(arguments), std::move(names)).end(echo);
}

} // namespace

PYBIND11_MODULE(_axiscomp, module)
{
    module.attr("__version__") = AXISCOMP_VERSION;
    module.def("commands", &commandFacts);
    module.def("run", &run, py::arg("arguments"), py::arg("echo") = py::none(),
        py::arg("names") = Environment::Names());
    py::class_<CommandRun, std::shared_ptr<CommandRun>>(module, "Readings")
        .def(py::init<std::vector<std::string>>(), py::arg("arguments"))
        .def("next", methodOf(+[](CommandRun& self) { return self.nextReading(); }))
        .def("stop", methodOf(+[](CommandRun& self) { self.stop(); }))
        .def_property_readonly("missed", methodOf(+[](CommandRun& self) { return self.missed(); }));
    addTables(module);
    addMeasurements(module);
}

} // namespace axiscomp::app
