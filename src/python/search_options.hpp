#pragma once

#include <pybind11/pybind11.h>

#include "coilwright/sizing/problem/options.hpp"

namespace coilwright::python {

/// `usual` with what a caller says of seed, max_evaluations, algorithm and threads where it is not None, and the
/// function progress(evaluations, max_evaluations, feasible, front_size). Throws std::invalid_argument for an algorithm
/// that there is none of.
[[nodiscard]] sizing::SearchOptions options_of(const pybind11::dict& words, sizing::SearchOptions usual);

}  // namespace coilwright::python
