#include "sizing/sampling/neighbours.hpp"

namespace coilwright::sizing {

std::vector<UnitPoint> unknown_neighbours(const Samples& samples, std::size_t index) {
  const DesignSpace& space = samples.space();
  const Sample& centre = samples[index];
  std::vector<UnitPoint> neighbours;
  const auto consider = [&](std::vector<double> unit, std::uint64_t combination) {
    if (!samples.rules_out(unit, combination))
      neighbours.push_back({.unit = std::move(unit), .combination = combination});
  };
  for (std::size_t axis = 0; axis < space.dimension(); ++axis) {
    const double spacing = space.spacing(axis);
    if (spacing == 0) continue;
    for (const double step : {-spacing, spacing}) {
      std::vector<double> unit = centre.unit;
      unit[axis] += step;
      consider(space.snapped(unit), centre.combination);
    }
  }
  std::uint64_t stride = 1;
  for (const std::uint64_t levels : space.level_counts()) {
    const std::uint64_t level = centre.combination / stride % levels;
    for (std::uint64_t other = 0; other < levels; ++other) {
      if (other != level) consider(centre.unit, centre.combination - level * stride + other * stride);
    }
    stride *= levels;
  }
  return neighbours;
}

}  // namespace coilwright::sizing
