#pragma once

#include <Eigen/Core>

#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::actuator {

/// Current of each coil, A, base to tip. A positive current opens the joints of a coil of polarity +1 beside a magnet
/// of polarity +1.
using CoilCurrents = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, mechanics::max_joints + 1, 1>;

}  // namespace coilwright::actuator
