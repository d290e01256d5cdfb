#pragma once

#include <memory>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::simulation {

/// A design at an operating point with all its results. It refers to nothing outside itself.
struct EvaluatedDesign {
  actuator::Design design;
  actuator::Assembly assembly;
  OperatingPoint point;
  Performance performance;
  Settings settings{};  ///< settings that a study varies
  /// Results that quantities of this design share. Whoever changes a member above must replace this one, and
  /// `performance`.
  std::shared_ptr<SharedResults> shared = std::make_shared<SharedResults>();

  /// The argument of the functions of a QuantityTable: `table.at("mass_g").value(evaluated.view())`. Valid as long as
  /// this object.
  [[nodiscard]] DesignView view() const& {
    return {.design = design,
            .assembly = assembly,
            .point = point,
            .performance = performance,
            .settings = &settings,
            .shared = shared.get()};
  }
  DesignView view() const&& = delete;
};

/// Assembles a design and computes its performance at an operating point. Pure: the same input gives the same bits.
/// Throws std::invalid_argument with the first rule that the design breaks or for a duty outside 0 to 1, and
/// std::runtime_error with the reason if it has no performance.
[[nodiscard]] EvaluatedDesign evaluate(actuator::Design design, const OperatingPoint& point);

}  // namespace coilwright::simulation
