#pragma once

#include <variant>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/simulation/performance.hpp"

namespace coilwright::simulation {

/// Of a design that can be assembled and has an equilibrium at this operating point.
inline Performance performance_at(const actuator::Design& design, const actuator::OperatingPoint& point) {
  return std::get<Performance>(performance_of(design, actuator::assemble_or_throw(design), point));
}

}  // namespace coilwright::simulation
