#include "magnetics/gauss_legendre.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace coilwright::magnetics {
namespace {

constexpr std::size_t block = 8;

struct NodeAndWeight {
  double node;
  double weight;
};

/// Newton's method on the Legendre polynomial from Tricomi's first guess; three steps reach rounding for n <= 64.
NodeAndWeight legendre_node(int order, int index) {
  long double x = std::cos(std::numbers::pi * (index + 0.75) / (order + 0.5));
  long double slope = 1.0L;
  for (int step = 0; step < 4; ++step) {
    long double previous = 1.0L;
    long double value = x;
    for (int k = 2; k <= order; ++k) {
      const long double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
      previous = value;
      value = next;
    }
    slope = order * (x * value - previous) / (x * x - 1.0L);
    x -= value / slope;
  }
  return {static_cast<double>(-x), static_cast<double>(1.0L / ((1.0L - x * x) * slope * slope))};
}

class Table {
 public:
  Table() {
    for (int order = 1; order <= max_gauss_order; ++order) {
      offset_[order] = nodes_.size();
      const auto padded = (static_cast<std::size_t>(order) + block - 1) / block * block;
      for (int i = 0; i < order; ++i) {
        const NodeAndWeight point = legendre_node(order, i);
        nodes_.push_back(point.node);
        weights_.push_back(point.weight);
      }
      nodes_.resize(offset_[order] + padded, nodes_.back());
      weights_.resize(offset_[order] + padded, 0.0);
    }
  }

  [[nodiscard]] QuadratureRule rule(int order) const {
    const auto count = static_cast<std::size_t>(order);
    return {nodes_.data() + offset_[order], weights_.data() + offset_[order], count,
            (count + block - 1) / block * block};
  }

 private:
  std::array<std::size_t, max_gauss_order + 1> offset_{};
  std::vector<double> nodes_;
  std::vector<double> weights_;
};

}  // namespace

QuadratureRule gauss_legendre(int order) {
  assert(order >= 1 && order <= max_gauss_order);
  static const Table table;
  return table.rule(order);
}

double gauss_rate(double to_ends, double length) {
  const double reach = std::max(to_ends / length, 1.0);
  return reach + std::sqrt((reach - 1.0) * (reach + 1.0));
}

int gauss_order_of_blocks(double rate, double error) {
  const double square = rate * rate;
  const double fourth = square * square;
  const double gain = fourth * fourth * fourth * fourth;  // rate^16: of eight nodes
  const double wanted = 1.0 / error;
  int order = 8;
  for (double reached = gain; reached < wanted && order <= max_gauss_order; reached *= gain) order += 8;
  return order;
}

double gauss_nodes_needed(double rate, double log_error) {
  return -log_error / (2.0 * std::log(std::max(rate, 1.0 + 1e-9)));
}

}  // namespace coilwright::magnetics
