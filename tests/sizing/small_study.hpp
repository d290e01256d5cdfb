#pragma once

#include <string_view>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::sizing::testing {

/// The row of that name in the table of quantities.
inline const simulation::ResultQuantity& quantity(std::string_view name) {
  return simulation::standard_quantities().at(name);
}

/// A study of the default finger with a variable of every kind but a continuous one: 2 * 3 * 2 * 3 designs.
inline Study small_study() {
  Study study;
  study.name = "small";
  study.current = ShareOfLimit{.share = 0.9};
  study.operating.duty = 0.4;
  study.variables = {configuration_variable({actuator::Configuration::B, actuator::Configuration::A}),
                     ParameterVariable{.parameter = actuator::find_parameter("gap_mm"),
                                       .range = Interval{.lower = 0.7, .upper = 1.2, .step = 0.2}},
                     ParameterVariable{.parameter = actuator::find_parameter("turns_radial"),
                                       .range = Interval{.lower = 13, .upper = 14}},
                     ParameterVariable{.parameter = actuator::find_parameter("wire_gauge_AWG"),
                                       .range = Choice{.values = {27, 28, 30}}}};
  study.objectives = {{.quantity = quantity("peak_bending_speed_deg_s"), .sense = Sense::maximise},
                      {.quantity = quantity("mass_g"), .sense = Sense::minimise}};
  study.limits = {{.quantity = quantity("mass_g"), .side = Limit::Side::at_most, .value = 66.0},
                  {.quantity = quantity("steady_angle_deg"), .side = Limit::Side::at_least, .value = 20.0}};
  return study;
}

}  // namespace coilwright::sizing::testing
