#pragma once

#include <pybind11/pybind11.h>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::python {

/// The standard quantities and those of a program, each a tuple (name, meaning, scale, function of a Performance that
/// gives a number or None). The functions are called on any thread, with the interpreter's lock.
[[nodiscard]] simulation::QuantityTable table_with(const pybind11::sequence& own);

}  // namespace coilwright::python
