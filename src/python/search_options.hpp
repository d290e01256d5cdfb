#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>

#include "coilwright/sizing/problem/options.hpp"

namespace coilwright::python {

/// What a caller says of a search, over what the study says.
struct SearchWords {
  std::optional<std::uint64_t> seed{};
  std::optional<std::size_t> max_evaluations{};
  std::optional<std::string> algorithm{};
  unsigned threads = 0;
  pybind11::object progress = pybind11::none();  ///< called with (evaluations, max_evaluations, feasible, front_size)
};

/// `usual` with these. Throws std::invalid_argument for an algorithm that there is none of.
[[nodiscard]] sizing::SearchOptions options_of(const SearchWords& words, sizing::SearchOptions usual);

}  // namespace coilwright::python
