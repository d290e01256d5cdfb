#pragma once

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/drive/driver.hpp"
#include "coilwright/simulation/state.hpp"
#include "coilwright/simulation/transient.hpp"
#include "systems/driven_coils.hpp"

namespace coilwright::systems {

/// A model whose coils are on one path of a driver. Its states are those of DrivenCoils, then the model's own.
class DrivenPhase {
 public:
  DrivenPhase(const actuator::Model& model, const drive::Path& path, const CoilLoop& loop);
  DrivenPhase(const DrivenPhase&) = delete;
  DrivenPhase& operator=(const DrivenPhase&) = delete;

  [[nodiscard]] const drive::Path& path() const { return path_; }
  [[nodiscard]] const actuator::Model& model() const { return model_; }

  /// Current of the driver, as one actuator has it, A.
  [[nodiscard]] double current(const simulation::State& state) const;
  /// The voltage by which the path drives that current up, V: without current, a diode begins to conduct above zero.
  [[nodiscard]] double forward(const simulation::State& state) const;
  /// The same state with no current of the driver, as a very short pulse of voltage would leave it.
  [[nodiscard]] simulation::State without_current(simulation::State state) const;
  /// The state at `end` of a motion from `begin` (s). Throws as simulation::simulate_at() does.
  [[nodiscard]] simulation::State moved(const simulation::State& from, double begin, double end,
                                        const simulation::Accuracy& accuracy) const;

 private:
  [[nodiscard]] int coils() const { return static_cast<int>(loop_.entry.size()); }
  [[nodiscard]] actuator::Model with_coils(const actuator::Model& model) const;

  drive::Path path_;
  CoilLoop loop_;
  actuator::CoilCurrents answer_;  // of the currents to the driver's voltage, 1/H
  actuator::MagneticStage pairs_;
  DrivenCoils kind_;
  actuator::Model model_;  // refers to kind_
};

}  // namespace coilwright::systems
