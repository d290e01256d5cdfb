#include "magnetics/radial_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace coilwright::magnetics {

RadialSet RadialSet::shells(const SheetBody& body, int first) {
  const int last = std::min(body.shells, first + capacity) - 1;
  RadialSet set(static_cast<std::size_t>(last - first + 1));
  for (std::size_t i = 0; i < set.padded_; ++i) {
    const int shell = std::min(first + static_cast<int>(i), last);
    set.node_[i] = body.shells == 1 ? 0.0 : -1.0 + 2.0 * shell / (body.shells - 1);
    set.weight_[i] = i < set.count_ ? 1.0 / body.shells : 0.0;
  }
  return set;
}

RadialSet RadialSet::graded(const SheetBody& body, double radius, double offset) {
  const QuadratureRule gauss = gauss_legendre(capacity);
  const double scale = std::abs(offset);
  const double lower = std::asinh((body.inner_radius - radius) / scale);
  const double upper = std::asinh((body.outer_radius - radius) / scale);
  const double half_width = body.half_width();
  RadialSet set(gauss.count);
  for (std::size_t i = 0; i < gauss.count; ++i) {
    const double u = 0.5 * (lower + upper) + 0.5 * (upper - lower) * gauss.node[i];
    set.node_[i] = (radius - body.mean_radius() + scale * std::sinh(u)) / half_width;
    set.weight_[i] = gauss.weight[i] * (upper - lower) * scale * std::cosh(u) / (2.0 * half_width);
  }
  return set;
}

double sum_over_shells(const SheetBody& source, std::span<FacePair> pairs, double other_radius) {
  double total = 0.0;
  for (int first = 0; first < source.shells; first += RadialSet::capacity) {
    const RadialSet set = RadialSet::shells(source, first);
    for (FacePair& pair : pairs) pair.nodes.rule = set.rule();
    total += sum_of_inductance_integrals(pairs, other_radius);
  }
  return total;
}

}  // namespace coilwright::magnetics
