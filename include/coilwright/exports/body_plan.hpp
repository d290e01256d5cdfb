#pragma once

#include <vector>

#include "coilwright/actuator/design/layout.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// One coil or magnet at its place in the straight body, SI. Places along the body count from its rear end.
struct PlacedPart {
  actuator::Component component;
  double centre{};        ///< along the body
  double half_pitch{};    ///< half of its segment without rear and front part
  double length{};        ///< of the coil or magnet itself
  double radius{};        ///< outer
  double inner_radius{};  ///< of a coil's bore; 0 for a magnet
  double face_wall{};     ///< silicone on each of its two faces
};

/// The places of all parts in the straight body, SI, which sheets, drawings and moulds share. Heights count from the
/// underside of the bottom layer.
struct BodyPlan {
  double length{};
  double width{};
  double height{};
  double axis_height{};
  double hinge_height{};
  double bottom_layer{};
  std::vector<PlacedPart> parts;  ///< base first
  std::vector<double> joints;     ///< places of the slits along the body; one fewer than parts
};

/// Takes the places from dimensions and segments of the assembly.
[[nodiscard]] BodyPlan body_plan(const DesignSubject& subject);

}  // namespace coilwright::exports
