#pragma once

#include <array>
#include <cstddef>

#include "magnetics/gauss_legendre.hpp"
#include "magnetics/sheets.hpp"

namespace coilwright::magnetics {

/// Radii and weights (of a mean) that a kernel reads; owns what is not a table.
class RadialSet {
 public:
  static constexpr int capacity = 64;

  /// At most `capacity` of a body's shells, from number `first` on. Weights are those of the mean over all shells.
  static RadialSet shells(const SheetBody& body, int first);
  /// Nodes that resolve an integrand singular at radius +- i offset however close that is to the body's sheets: equal
  /// steps of Gauss-Legendre in u with r = radius + |offset| sinh u (Johnston and Elliott 2005), in which the
  /// singularities are at u = +- i pi / 2. `offset` must not be 0.
  static RadialSet graded(const SheetBody& body, double radius, double offset);

  [[nodiscard]] QuadratureRule rule() const noexcept { return {node_.data(), weight_.data(), count_, padded_}; }

 private:
  RadialSet(std::size_t count) : count_(count), padded_((count + 7) / 8 * 8) {}

  std::array<double, capacity> node_;
  std::array<double, capacity> weight_;
  std::size_t count_;
  std::size_t padded_;
};

}  // namespace coilwright::magnetics
