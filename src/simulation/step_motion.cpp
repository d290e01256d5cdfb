#include "coilwright/simulation/step_motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <stdexcept>

#include "coilwright/actuator/demagnetisation.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/transient.hpp"
#include "motion.hpp"

namespace coilwright::simulation {
namespace {

// As warm as the steady state of the free case; as it stands where there is none that the magnets feel.
actuator::Model warm_model(const EvaluatedDesign& evaluated) {
  const thermal::NodeVector& temperatures = evaluated.performance.free.heat.temperatures;
  if (temperatures.size() == 0) return evaluated.assembly.model;
  const std::span<const double> each(temperatures.data(), static_cast<std::size_t>(temperatures.size()));
  return evaluated.assembly.model.with_magnet_strengths(actuator::magnet_strengths(evaluated.design, each));
}

}  // namespace

std::optional<StepMotion> step_motion(const EvaluatedDesign& evaluated, double duration, std::size_t samples) {
  if (!(duration > 0.0) || !std::isfinite(duration))
    throw std::invalid_argument(fmt::format("duration must be > 0 and finite; got {}", duration));
  if (samples < 2) throw std::invalid_argument(fmt::format("samples must be at least 2; got {}", samples));
  const std::optional<FreeMotion>& free = evaluated.performance.free.motion;
  if (!free) return std::nullopt;
  // Slow effects stay as they are at rest when it is cold: so they are in the figures of Performance.
  const actuator::Model model = held_at_rest(warm_model(evaluated), evaluated.performance.cold.rest_angles);
  StepMotion motion;
  for (std::size_t i = 0; i < samples; ++i)
    motion.times.push_back(duration *
                           (static_cast<double>(i) / static_cast<double>(samples - 1)));  // ends at it exactly
  const actuator::CoilCurrents on = model.all_coils(evaluated.point.current);
  const ModelInput input{.times = {0.0, duration}, .currents = {on, on}};
  const State rest{.angles = free->rest_angles,
                   .rates = mechanics::JointVector::Zero(model.joints()),
                   .internal = model.settled(free->rest_angles, model.all_coils(0.0))};
  motion.states = simulate_at(model, input, rest, motion.times);
  return motion;
}

std::size_t peak_of(const StepMotion& motion) {
  const double start = motion.states.front().angles.sum();
  std::size_t peak = 0;
  for (std::size_t i = 0; i < motion.states.size(); ++i)
    if (std::abs(motion.states[i].angles.sum() - start) > std::abs(motion.states[peak].angles.sum() - start)) peak = i;
  return peak;
}

}  // namespace coilwright::simulation
