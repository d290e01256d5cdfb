#include "measurement/data/equal_stretches.hpp"

namespace coilwright::measurement::data {

std::vector<EqualStretch> equal_stretches(std::span<const double> values) {
  std::vector<EqualStretch> out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && values[i] == values[i - 1])
      ++out.back().size;
    else
      out.push_back({.first = i, .size = 1});
  }
  return out;
}

}  // namespace coilwright::measurement::data
