#pragma once

#include <Eigen/Core>
#include <vector>

#include "sizing/problem/design_space.hpp"

namespace coilwright::sizing {

/// Grid points around `optimum` (n unit coordinates): the corners of its cell along the at most five axes in which it
/// lies nearest to half way between two grid values, and single steps from the nearest grid point. Axes without a grid
/// keep their coordinate. A point may be there more than once.
[[nodiscard]] std::vector<std::vector<double>> grid_points_near(const DesignSpace& space,
                                                                const Eigen::VectorXd& optimum);

/// Points one and two grid steps from `centre` along one axis, and with one step more along another one. A point may be
/// there more than once.
[[nodiscard]] std::vector<std::vector<double>> grid_neighbours(const DesignSpace& space,
                                                               const std::vector<double>& centre);

}  // namespace coilwright::sizing
