#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::python {

/// A study as Python holds it, read and checked.
struct Study {
  sizing::Study content;
  std::string origin;  ///< what errors about it call it
};

/// The standard quantities and those of a program, each a tuple (name, meaning, scale, function of a Performance that
/// gives a number or None). The functions are called on any thread, with the interpreter's lock.
[[nodiscard]] simulation::QuantityTable table_with(const pybind11::sequence& own);

}  // namespace coilwright::python
