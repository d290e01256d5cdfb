#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// A change of a design in something that no measurement of it has settled: another modelling choice, or a number at an
/// end of what is known of it.
struct OtherChoice {
  std::string_view subject;     ///< the name of the subject: "damping of the joints", "remanence of the magnets"
  std::string taken;            ///< the way in which the design takes it, with its numbers
  std::string otherwise;        ///< the way in which `design` takes it
  std::string_view settled_by;  ///< the measurement that decides between the two
  Design design;                ///< the same parts under the other choice; measured values of the prototype still hold
  std::string_view source{};    ///< the reason why the other way is tenable
  std::string_view number{};    ///< the parameter that differs; empty for a modelling choice
  bool decided = false;         ///< whether the builder decides it, so that no measurement is needed
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
