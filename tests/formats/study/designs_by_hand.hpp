#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/study/leaders.hpp"

namespace coilwright::testing {

inline const simulation::ResultQuantity& quantity(std::string_view name) {
  return simulation::standard_quantities().at(name);
}

inline sizing::Study study() {
  using namespace sizing;
  Study out;
  out.name = "by hand";
  out.variables = {
      configuration_variable({actuator::Configuration::D, actuator::Configuration::A}),
      CurrentVariable{.range = Interval{.lower = 0.1, .upper = 1.5}},
      ParameterVariable{.parameter = actuator::find_parameter("wire_gauge_AWG"), .range = Choice{.values = {26, 30}}}};
  out.objectives = {{.quantity = quantity("current_A"), .sense = Sense::minimise},
                    {.quantity = quantity("grasp_force_N"), .sense = Sense::maximise}};
  out.limits = {{.quantity = quantity("mass_g"), .side = Limit::Side::at_most, .value = 64.0},
                {.quantity = quantity("coil_temperature_degC"), .side = Limit::Side::at_most, .value = 128.0},
                {.quantity = quantity("damping_ratio"), .side = Limit::Side::at_least, .value = 0.0625}};
  return out;
}

inline sizing::Evaluation evaluated(double current, double force, std::vector<double> constraints) {
  return {.objectives = {current, force}, .constraints = std::move(constraints), .failure = {}, .infeasibility = {}};
}

// Constraints in sixteenths of the limits, so that the margins below are exact.
inline const std::vector<sizing::Record> records = {
    {.point = {0, 0.4, 1}, .evaluation = evaluated(0.4, 1.25, {-0.0625, -0.5, 0.0})},
    {.point = {1, 0.8, 0}, .evaluation = evaluated(0.8, 2.5, {0.25, -0.25, -4.0})},
    {.point = {1, 1.2, 0},
     .evaluation = {.objectives = {}, .constraints = {}, .failure = "too hot, \"really\"", .infeasibility = 2.0}}};

inline sizing::SweptDesign swept(const sizing::Record& record) {
  return {.index = 3, .point = record.point, .evaluation = record.evaluation};
}

}  // namespace coilwright::testing
