#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// A change of a design in something that no measurement of it has settled: another modelling choice, or a number at an
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

/// Returns one entry for each other tenable value of a modelling choice of `design`: the hinge law, the law of damping,
/// the film coefficient, the contact of faces, the ampacity, the winding convention, and, if the design takes them, the
/// source paper's torque and masses. docs/assumptions.md gives the reasons for each. Precondition:
/// construction_faults(design) is empty.
[[nodiscard]] std::vector<OtherChoice> other_choices(const Design& design);

/// Returns one entry for each value of number_widths() at which a number of `design` may also be, if it is neither
/// measured nor stated. Precondition: construction_faults(design) is empty.
[[nodiscard]] std::vector<OtherChoice> other_numbers(const Design& design);

}  // namespace coilwright::actuator
