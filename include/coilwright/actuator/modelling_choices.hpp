#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// A modelling choice that no measurement of the design has settled, made the other way.
struct OtherChoice {
  std::string_view subject;     ///< what is modelled: "damping of the hinges"
  std::string taken;            ///< how the design takes it, with its numbers
  std::string otherwise;        ///< how `design` takes it
  std::string_view settled_by;  ///< the measurement that decides between the two
  Design design;  ///< the same parts under the other choice; what was measured on the prototype still holds
};

/// Every modelling choice of `design` that is tenable in another way too, one entry for each other way: the hinge law,
/// the law of damping, the film coefficient, the contact of faces, the ampacity and the winding convention. What each
/// choice rests on is in docs/assumptions.md. Precondition: construction_faults(design) is empty.
[[nodiscard]] std::vector<OtherChoice> other_choices(const Design& design);

}  // namespace coilwright::actuator
