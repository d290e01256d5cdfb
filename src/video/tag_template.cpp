#include "video/tag_template.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "coilwright/video/tag_pattern.hpp"

namespace coilwright::video {
namespace {

constexpr int nodes_a_module = 16;
constexpr double grid_reach = 4.0;
constexpr int grid_side = static_cast<int>(2 * grid_reach * nodes_a_module) + 1;
constexpr std::size_t grid_nodes = std::size_t{grid_side} * std::size_t{grid_side};

// The blurred share of each row or column of modules, its first and second derivative.
struct Shares {
  Eigen::Matrix<double, tag_modules, 3> of_module;
};

Shares shares_at(double place, double blur) {
  std::array<Eigen::RowVector3d, tag_modules + 1> edges;
  for (int k = 0; k <= tag_modules; ++k) {
    const double z = (place - (k - 0.5 * tag_modules)) / blur;
    const double bell = std::exp(-0.5 * z * z) / (std::sqrt(2.0 * std::numbers::pi) * blur);
    edges[k] = {0.5 * std::erfc(-z / std::numbers::sqrt2), bell, -z / blur * bell};
  }
  Shares out;
  for (int k = 0; k < tag_modules; ++k) out.of_module.row(k) = edges[k] - edges[k + 1];
  return out;
}

}  // namespace

TagTemplate::TagTemplate(int tag, double blur) : blur_(blur), grid_(grid_nodes) {
  Eigen::Matrix<double, tag_modules, tag_modules> black;
  for (int row = 0; row < tag_modules; ++row)
    for (int column = 0; column < tag_modules; ++column) black(row, column) = is_white(tag, row, column) ? 0.0 : 1.0;
  std::vector<Shares> shares;
  for (int i = 0; i < grid_side; ++i)
    shares.push_back(shares_at(static_cast<double>(i) / nodes_a_module - grid_reach, blur));
  for (int j = 0; j < grid_side; ++j)
    for (int i = 0; i < grid_side; ++i) {
      const Eigen::Matrix3d s = shares[j].of_module.transpose() * black * shares[i].of_module;  // (order v, order u)
      grid_[j * grid_side + i] << static_cast<float>(1.0 - s(0, 0)), static_cast<float>(-s(0, 1)),
          static_cast<float>(-s(1, 0)), static_cast<float>(-s(0, 2)), static_cast<float>(-s(1, 1)),
          static_cast<float>(-s(2, 0));
    }
}

TagSlopes TagTemplate::at(double u, double v) const {
  const double x = (u + grid_reach) * nodes_a_module;
  const double y = (v + grid_reach) * nodes_a_module;
  const int i = static_cast<int>(x + 0.5);
  const int j = static_cast<int>(y + 0.5);
  const auto du = static_cast<float>((x - i) / nodes_a_module);
  const auto dv = static_cast<float>((y - j) / nodes_a_module);
  TagSlopes out = grid_[j * grid_side + i];
  out[0] += du * (out[1] + 0.5F * du * out[3] + dv * out[4]) + dv * (out[2] + 0.5F * dv * out[5]);
  out[1] += du * out[3] + dv * out[4];
  out[2] += du * out[4] + dv * out[5];
  return out;
}

const TagTemplate& TagTemplates::of(int tag, double blur) {
  const double step = std::log(1.25);
  const int level = std::clamp(static_cast<int>(std::lround(std::log(blur) / step)), -13, 1);  // 0.055 to 1.25
  const auto found = made_.find({tag, level});
  if (found != made_.end()) return found->second;
  return made_.try_emplace({tag, level}, tag, std::exp(level * step)).first->second;
}

}  // namespace coilwright::video
