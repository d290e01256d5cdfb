#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design.hpp"
#include "coilwright/simulation/performance.hpp"

namespace coilwright::simulation {

/// A design with everything that is known of it.
struct Candidate {
  const actuator::Design& design;
  const actuator::Assembly& assembly;
  const OperatingPoint& point;
  const Performance& performance;
};

/// One number of a candidate as results print it and as a study asks for it.
struct Quantity {
  std::string_view name;     ///< with the unit at its end
  std::string_view meaning;  ///< one line
  double scale{};            ///< of an ordinary value, in its unit, > 0: what a difference is measured against
  /// In the unit of the name; nothing where the quantity does not exist (a temperature in a thermal runaway).
  std::optional<double> (*get)(const Candidate&) = nullptr;
  std::string_view absence{};  ///< when it has no value: end of a sentence; empty for a quantity every design has
};

/// Every quantity, in the order in which results print them.
[[nodiscard]] std::span<const Quantity> quantities();

/// The quantity of that name; nullptr if there is none.
[[nodiscard]] const Quantity* find_quantity(std::string_view name);

}  // namespace coilwright::simulation
