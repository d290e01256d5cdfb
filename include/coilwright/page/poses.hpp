#pragma once

#include <string>
#include <vector>

#include "coilwright/exports/body_plan.hpp"
#include "coilwright/mechanics/joint_vector.hpp"
#include "coilwright/page/page.hpp"

namespace coilwright::page {

/// A pose to draw.
struct Pose {
  std::string id;                 ///< "rest"
  std::string title;              ///< "at rest, without current"
  mechanics::JointVector angles;  ///< rad, one a joint, opening positive
};

/// A longitudinal section of the body in each pose, hanging from its rear end, all to one scale with a bar of 10 mm in
/// each. `base_tilt` in rad, towards opening. The angles of the joints stand below each. Throws std::invalid_argument
/// if a pose has another number of joints than the body.
[[nodiscard]] std::vector<Figure> pose_figures(const exports::BodyPlan& plan, const std::vector<Pose>& poses,
                                               double base_tilt);

/// Place of a point of the straight body (m along it from its rear end, m above its underside) in a pose: to the right
/// of and below the rear end of the underside, m.
struct PosedPoint {
  double right{};
  double down{};
};
[[nodiscard]] PosedPoint posed(const exports::BodyPlan& plan, const mechanics::JointVector& angles, double base_tilt,
                               double along, double up);

}  // namespace coilwright::page
