// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <type_traits>
#include <utility>

namespace axiscomp::app {

/// What an object of Python holds. Errors: TypeError for one that nothing has made, as that of
/// Table.__new__(Table), in whose place pybind11 would hand out memory that it has just allocated.
template <typename T> std::shared_ptr<T> madeObject(const pybind11::object& object)
{
    if (pybind11::isinstance<T>(object)) {
        try {
            return object.cast<std::shared_ptr<T>>();
        } catch (const pybind11::cast_error&) { // it holds nothing
        }
    }
    throw pybind11::type_error("this object was never initialised");
}

/// A function of T, or of its class, as a method of the class in Python.
template <typename T, typename Answer, typename... Arguments>
auto methodOf(Answer (*function)(T&, Arguments...))
{
    return [function](const pybind11::object& self, Arguments... arguments) -> Answer {
        return function(
            *madeObject<std::remove_const_t<T>>(self), std::forward<Arguments>(arguments)...);
    };
}

} // namespace axiscomp::app
