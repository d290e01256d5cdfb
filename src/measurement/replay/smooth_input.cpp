#include "measurement/replay/smooth_input.hpp"

#include <algorithm>
#include <utility>

namespace coilwright::measurement::replay {
namespace {

// Slope at a node of the polynomial through it and the nodes around it, by Lagrange's formula.
double slope_at(const std::vector<double>& x, const std::vector<double>& y, std::size_t node, std::size_t from,
                std::size_t to) {
  double slope = 0.0;
  for (std::size_t k = from; k < to; ++k) {
    if (k == node) continue;
    double weight = 1.0 / (x[k] - x[node]);
    for (std::size_t j = from; j < to; ++j)
      if (j != node && j != k) weight *= (x[node] - x[j]) / (x[k] - x[j]);
    slope += weight * (y[k] - y[node]);
  }
  return slope;
}

}  // namespace

SmoothInput::SmoothInput(const std::vector<double>& times, const std::vector<std::vector<double>>& rows,
                         std::size_t first, std::size_t last) {
  constexpr std::size_t around = 5;
  const std::vector<double> x(times.begin() + static_cast<std::ptrdiff_t>(first),
                              times.begin() + static_cast<std::ptrdiff_t>(last));
  for (std::size_t column = 0; column < rows[first].size(); ++column) {
    std::vector<double> y;
    for (std::size_t i = first; i < last; ++i) y.push_back(rows[i][column]);
    std::vector<double> slopes;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const std::size_t begin = std::min(i > around / 2 ? i - around / 2 : 0, x.size() - std::min(around, x.size()));
      slopes.push_back(slope_at(x, y, i, begin, std::min(begin + around, x.size())));
    }
    columns_.emplace_back(std::vector<double>(x), std::move(y), std::move(slopes));
  }
}

std::vector<double> SmoothInput::at(double time) const {
  std::vector<double> out;
  for (const auto& column : columns_) out.push_back(column(time));
  return out;
}

}  // namespace coilwright::measurement::replay
