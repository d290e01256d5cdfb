#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace coilwright::measurement::data {

/// Samples in a row that are equal.
struct EqualStretch {
  std::size_t first{};  ///< its first sample
  std::size_t size{};   ///< samples; >= 1

  [[nodiscard]] std::size_t end() const { return first + size; }  ///< the first sample behind it
};

/// The longest such stretches into which `values` fall, in order: each sample is in one, and neighbours differ.
[[nodiscard]] std::vector<EqualStretch> equal_stretches(std::span<const double> values);

}  // namespace coilwright::measurement::data
