#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "magnetics/gauss_legendre.hpp"
#include "magnetics/sheet_kernels.hpp"
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

/// sum_of_inductance_integrals over all shells of `source`, whatever rules `pairs` have.
[[nodiscard]] double sum_over_shells(const SheetBody& source, std::span<FacePair> pairs, double other_radius);

/// Gauss-Legendre repeated over equal panels of [-1, 1]: any number of nodes.
class PanelRule {
 public:
  static constexpr int largest_order = 48;

  /// Bodies that touch or overlap would ask for any number; this many resolve a clearance of about 2 % of the length
  /// integrated over, and keep the cost of an overlapping pose in milliseconds.
  static constexpr double most_nodes = 192.0;

  /// Enough nodes for a single rule of `needed` nodes (each of m panels then needs about needed / m), and one more; as
  /// many as there may be where `needed` is no number, as of lengths whose squares vanish.
  explicit PanelRule(double needed)
      : panels_(static_cast<int>(std::ceil(bounded(needed) / largest_order))),
        rule_(gauss_legendre(
            std::clamp(static_cast<int>(std::ceil(bounded(needed) / panels_)) + 1, 2, max_gauss_order))) {}

  [[nodiscard]] int count() const noexcept { return panels_ * static_cast<int>(rule_.count); }
  [[nodiscard]] double node(int i) const noexcept {
    if (panels_ == 1) return rule_.node[i];
    const int order = static_cast<int>(rule_.count);
    const int panel = i / order;
    return (rule_.node[i % order] + 2 * panel + 1) / panels_ - 1.0;
  }
  [[nodiscard]] double weight(int i) const noexcept {
    return rule_.weight[i % static_cast<int>(rule_.count)] / panels_;
  }

 private:
  // At least one: lengths whose squares vanish need none, or no number of them.
  static double bounded(double needed) { return needed < most_nodes ? std::max(needed, 1.0) : most_nodes; }

  int panels_;
  QuadratureRule rule_;
};

/// Sheets of a body one by one, for any number of them: its own shells, or Gauss-Legendre nodes of a uniform winding
/// enough for a single rule of `needed` nodes.
class SheetNodes {
 public:
  SheetNodes(const SheetBody& body, double needed) : body_(body), rule_(needed) {}

  [[nodiscard]] int count() const noexcept { return body_.spread == Spread::uniform ? rule_.count() : body_.shells; }
  [[nodiscard]] double radius(int i) const noexcept { return body_.mean_radius() + body_.half_width() * place(i); }
  [[nodiscard]] double weight(int i) const noexcept {
    return body_.spread == Spread::uniform ? rule_.weight(i) : 1.0 / body_.shells;
  }

 private:
  [[nodiscard]] double place(int i) const noexcept {
    if (body_.spread == Spread::uniform) return rule_.node(i);
    return body_.shells == 1 ? 0.0 : -1.0 + 2.0 * i / (body_.shells - 1);
  }

  const SheetBody& body_;
  PanelRule rule_;
};

}  // namespace coilwright::magnetics
