#pragma once

#include <vector>

#include "coilwright/exports/body_plan.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// Where one part goes into the cast body: a trough, round below and open above. SI, along the body from its rear end.
struct Pocket {
  double start{};
  double length{};
  double radius{};  ///< of the round below, about the axis of the parts; half the width above it
};

/// How the silicone of one actuator is cast, in the steps of the source paper's section IV.
struct Cast {
  BodyPlan plan;
  double clearance{};           ///< round a part in its pocket, m
  std::vector<Pocket> pockets;  ///< one a part, each ending where the next one begins
  double silicone_volume{};     ///< in the finished actuator, m^3: of the masses of its segments
  double bottom_volume{};       ///< of that, the bottom layer where it is of another silicone, m^3; else 0
  double main_volume{};         ///< of the rest, poured into the mould: the body with its pockets, m^3
  double filling_volume{};      ///< of that, the rest: walls of the parts, bores of the coils, bond, m^3
  double dip_volume{};          ///< that a cup must hold to dip the largest part, m^3; it stays in the cup
};

/// Room round the largest part in the cup for dipping, and above and below it, m. A choice.
inline constexpr double dip_room = 5e-3;

/// Throws std::invalid_argument where a calibrated axis lies so low that parts cut into the bottom layer, or so high
/// that they stand out of the body.
[[nodiscard]] Cast cast_of(const DesignSubject& subject);

/// Silicone of a segment, of both kinds, m^3.
[[nodiscard]] double volume_of(const actuator::Segment& segment, const actuator::Design& design);

/// Cross-section of a pocket from its bottom to the upside of the body, m^2.
[[nodiscard]] double section_of(const Pocket& pocket, const BodyPlan& plan);

}  // namespace coilwright::exports
