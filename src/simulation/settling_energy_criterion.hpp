#pragma once

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

/// A stable equilibrium and the energy above it that a motion needs to show an excursion of the bending angle.
///
/// The energy of the linearised chain, with the faces' springs as they are: one-sided. A joint that the torques press
/// onto its stop has little of its own to hold it away from it but that pressure, which is counted by its secant over
/// the excursion. Good for excursions over which the stiffness changes by a small part.
class SettlingEnergyCriterion {
 public:
  struct Spec {
    mechanics::JointVector equilibrium;  ///< rad; stable under `currents`
    double excursion{};                  ///< of the bending angle, rad; > 0
  };
  SettlingEnergyCriterion(const actuator::Model& model, const actuator::CoilCurrents& currents, Spec spec);

  /// Whether a motion through `state` stays within the excursion for good.
  [[nodiscard]] bool confines(const State& state) const;
  [[nodiscard]] const mechanics::JointVector& equilibrium() const { return spec_.equilibrium; }

 private:
  [[nodiscard]] double stop_energy(const mechanics::JointVector& away) const;

  const actuator::Model& model_;
  Spec spec_;
  mechanics::JointMatrix free_stiffness_;  // without the stops
  double energy_limit_{};
};

}  // namespace coilwright::simulation
