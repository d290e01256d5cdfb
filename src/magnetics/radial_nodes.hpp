#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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

/// Sheets of a body one by one, for any number of them: its own shells, or Gauss-Legendre nodes of a uniform winding.
class SheetNodes {
 public:
  SheetNodes(const SheetBody& body, const QuadratureRule& rule) noexcept : body_(body), rule_(rule) {}

  [[nodiscard]] int count() const noexcept {
    return body_.spread == Spread::uniform ? static_cast<int>(rule_.count) : body_.shells;
  }
  [[nodiscard]] double radius(int i) const noexcept { return body_.mean_radius() + body_.half_width() * place(i); }
  [[nodiscard]] double weight(int i) const noexcept {
    return body_.spread == Spread::uniform ? rule_.weight[i] : 1.0 / body_.shells;
  }

 private:
  [[nodiscard]] double place(int i) const noexcept {
    if (body_.spread == Spread::uniform) return rule_.node[i];
    return body_.shells == 1 ? 0.0 : -1.0 + 2.0 * i / (body_.shells - 1);
  }

  const SheetBody& body_;
  QuadratureRule rule_;
};

/// Sheets that stand for a body where Gauss-Legendre over its radius converges at `rate` and may err by `error`.
[[nodiscard]] inline SheetNodes sheet_nodes(const SheetBody& body, double rate, double error) {
  const double needed = body.spread == Spread::uniform ? gauss_nodes_needed(rate, error) : 1.0;
  return {body, gauss_legendre(static_cast<int>(std::clamp(std::ceil(needed), 2.0, 1.0 * max_gauss_order)))};
}

}  // namespace coilwright::magnetics
