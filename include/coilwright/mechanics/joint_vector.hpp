#pragma once

#include <Eigen/Core>

namespace coilwright::mechanics {

/// The largest number of joints of a chain. It is fixed so that no evaluation allocates on the heap.
inline constexpr int max_joints = 16;

/// One value per joint, base to tip.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, max_joints, 1>;

/// (n, n) over joints.
using JointMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_joints, max_joints>;

}  // namespace coilwright::mechanics
