#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// Something that no measurement of the design has settled, made the other way: a modelling choice, or a number at an
/// end of what is known of it.
struct OtherChoice {
  std::string_view subject;     ///< what it is: "damping of the joints", "remanence of the magnets"
  std::string taken;            ///< how the design takes it, with its numbers
  std::string otherwise;        ///< how `design` takes it
  std::string_view settled_by;  ///< the measurement that decides between the two
  Design design;              ///< the same parts under the other choice; what was measured on the prototype still holds
  std::string_view source{};  ///< what makes the other way tenable
  std::string_view number{};  ///< the parameter that differs; empty for a modelling choice
  bool decided = false;       ///< whether its builder decides it, so that it is said and not measured
};

/// Every modelling choice of `design` that is tenable in another way too, one entry for each other way: the hinge law,
/// the law of damping, the film coefficient, the contact of faces, the ampacity and the winding convention; where the
/// design takes the source paper's torque or masses, those too. What each choice rests on is in docs/assumptions.md.
/// Precondition: construction_faults(design) is empty.
[[nodiscard]] std::vector<OtherChoice> other_choices(const Design& design);

/// Every number of `design` that is neither measured nor stated, at the other values of number_widths(), one entry for
/// each. Precondition: construction_faults(design) is empty.
[[nodiscard]] std::vector<OtherChoice> other_numbers(const Design& design);

}  // namespace coilwright::actuator
