#include "coilwright/control/reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "coilwright/control/input_shaping.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "coilwright/simulation/step_response.hpp"
#include "coilwright/units/angle.hpp"
#include "control/profile_search.hpp"

namespace coilwright::control {
namespace {

using actuator::Model;
using mechanics::JointVector;

void check(const Model& model, const ReachTask& task) {
  const auto require = [](bool met, const char* name, const char* rule, double value) {
    if (!met) throw std::invalid_argument(fmt::format("{} must be {}; got {}", name, rule, value));
  };
  require(model.coils() > 0, "coils of the actuator", "at least one", model.coils());
  require(std::isfinite(task.angle), "angle", "finite", task.angle);
  require(std::isfinite(task.lowest_current), "lowest current", "finite", task.lowest_current);
  require(std::isfinite(task.highest_current) && task.highest_current > task.lowest_current, "highest current",
          "finite and above the lowest", task.highest_current);
  if (task.start_current < task.lowest_current || task.start_current > task.highest_current)
    throw std::invalid_argument(
        fmt::format("start current must be from {:.6g} to {:.6g} A, the lowest and the highest; got {:.6g} A",
                    task.lowest_current, task.highest_current, task.start_current));
  require(task.stiffness_error >= 0.0 && task.stiffness_error <= 0.5, "stiffness error", "from 0 to 0.5",
          task.stiffness_error);
  require(task.damping_error >= 0.0 && task.damping_error <= 0.5, "damping error", "from 0 to 0.5", task.damping_error);
  require(task.pieces >= 1 && task.pieces <= 6, "pieces", "from 1 to 6", task.pieces);
}

// As it is, and with k and b off either way.
std::vector<Model> fingers(const Model& model, const ReachTask& task) {
  std::vector<Model> out{model};
  for (const double stiffness : {-task.stiffness_error, task.stiffness_error})
    for (const double damping : {-task.damping_error, task.damping_error}) {
      if (stiffness == 0.0 && damping == 0.0) continue;
      actuator::ModelSpec spec = model.nominal_spec();
      for (actuator::Hinge& hinge : spec.hinges) {
        hinge.stiffness *= 1.0 + stiffness;
        hinge.damping *= 1.0 + damping;
      }
      out.emplace_back(std::move(spec));
    }
  return out;
}

simulation::State at_rest(const Model& model, double current) {
  auto rest = simulation::state_at_rest(model, model.all_coils(current), JointVector::Zero(model.joints()));
  if (!rest) throw std::runtime_error(fmt::format("has no stable pose under {} A", current));
  return *std::move(rest);
}

// A model whose heat and the like stay as they are at rest under a current.
Model held_at_rest(const Model& model, double current) {
  return model.has_slow_states() ? model.with_slow_states_held(at_rest(model, current).internal) : model;
}

double holding_current(const Model& model, const ReachTask& task) {
  const JointVector start = at_rest(model, task.start_current).angles;
  const auto angle = [&](double current) {
    const auto pose = simulation::find_equilibrium(model, model.all_coils(current), start);
    if (!pose) throw std::runtime_error(fmt::format("has no stable pose under {} A", current));
    return pose->sum();
  };
  const double low = angle(task.lowest_current) - task.angle;
  const double high = angle(task.highest_current) - task.angle;
  if (low * high > 0.0) {
    const double a = (low + task.angle) * units::degrees_per_radian;
    const double b = (high + task.angle) * units::degrees_per_radian;
    throw std::invalid_argument(fmt::format(
        "angle must be from {:.4g} to {:.4g} deg, which {:.4g} to {:.4g} A hold; got {:.6g} deg", std::min(a, b),
        std::max(a, b), task.lowest_current, task.highest_current, task.angle * units::degrees_per_radian));
  }
  if (low == 0.0) return task.lowest_current;
  if (high == 0.0) return task.highest_current;
  std::uintmax_t calls = 100;
  const auto bracket = boost::math::tools::toms748_solve([&](double current) { return angle(current) - task.angle; },
                                                         task.lowest_current, task.highest_current, low, high,
                                                         boost::math::tools::eps_tolerance<double>(40), calls);
  return 0.5 * (bracket.first + bracket.second);
}

// What sticks comes to rest where friction holds it, which no profile without a sensor decides.
void require_not_sticking(const Model& model, double current) {
  for (const actuator::Effect& effect : model.nominal_spec().effects)
    if (effect.kind->id() == "dry_friction" || effect.kind->id() == "hysteresis" || effect.kind->id() == "backlash")
      throw std::invalid_argument(
          fmt::format("effect {}: a joint that sticks stops short of an angle or beyond it, which a profile without a "
                      "sensor cannot mend; take the effect out to see the rest, {:.4g} A hold the angle without it",
                      effect.kind->id(), current));
}

// Of small motions at the angle: the slowest that oscillates, or the slowest of all.
simulation::Mode mode_at(const Model& model, double current, const JointVector& near) {
  const auto pose = simulation::find_equilibrium(model, model.all_coils(current), near);
  if (!pose) throw std::runtime_error("has no stable pose at the angle");
  const std::vector<simulation::Mode> modes = simulation::modes(model, *pose, model.all_coils(current));
  const auto found = std::ranges::find_if(modes, [](const simulation::Mode& mode) { return mode.damping_ratio < 1.0; });
  return found == modes.end() ? modes.front() : *found;
}

// Longer than the plain step takes to settle in any of the fingers.
double duration_for(const std::vector<Model>& models, const ReachTask& task, double current) {
  double longest = 0.0;
  for (const Model& each : models) {
    const Model held = held_at_rest(each, task.start_current);
    const auto step =
        simulation::step_response(held, held.all_coils(current), at_rest(held, task.start_current).angles);
    if (!step || !step->settling_time) throw std::runtime_error("does not settle after a plain step to the angle");
    longest = std::max(longest, *step->settling_time);
  }
  return 1.1 * longest + 0.02;
}

// How a profile does in each finger.
std::vector<Arrival> arrivals(const std::vector<Model>& models, const CurrentProfile& profile, double duration) {
  std::vector<Arrival> out;
  for (const Model& model : models) out.push_back(arrival(model, profile, duration));
  return out;
}

ProfileQuality quality(std::string name, const CurrentProfile& profile, const std::vector<Arrival>& of_fingers) {
  Arrival worst = *std::ranges::max_element(of_fingers, {}, &Arrival::settling_or_never);
  worst.overshoot = std::ranges::max(of_fingers, {}, &Arrival::overshoot).overshoot;
  return {.name = std::move(name), .profile = profile, .nominal = of_fingers.front(), .worst = worst};
}

}  // namespace

Reach reach(const Model& model, const ReachTask& task) {
  check(model, task);
  const Model held = held_at_rest(model, task.start_current);
  const double current = holding_current(held, task);
  const JointVector start = at_rest(held, task.start_current).angles;
  if (std::abs(task.angle - start.sum()) < 1e-3)
    throw std::invalid_argument(
        fmt::format("angle must differ from where the motion starts, {:.4g} deg; got {:.4g} deg",
                    start.sum() * units::degrees_per_radian, task.angle * units::degrees_per_radian));
  require_not_sticking(held, current);
  const std::vector<Model> models = fingers(model, task);
  const simulation::Mode mode = mode_at(held, current, start);
  Reach out{.current = current,
            .mode = mode,
            .duration = std::max(duration_for(models, task, current), 4.0 / mode.natural_frequency),
            .profiles = {}};
  const auto add = [&](std::string name, const CurrentProfile& profile) {
    std::vector<Arrival> of_fingers = arrivals(models, profile, out.duration);
    out.profiles.push_back(quality(std::move(name), profile, of_fingers));
    return of_fingers;
  };
  const CurrentProfile step = shaped_step(task.start_current, current, mode, Shaper::step);
  const auto [least, greatest] = std::ranges::minmax(add(std::string(name_of(Shaper::step)), step), {}, &Arrival::end);
  out.least_end = least.end;
  out.greatest_end = greatest.end;
  std::vector<CurrentProfile> shaped{step};
  for (const Shaper shaper : {Shaper::zero_vibration, Shaper::zero_vibration_derivative}) {
    const CurrentProfile profile = shaped_step(task.start_current, current, mode, shaper);
    if (profile.times.size() == 1) continue;  // nothing oscillates
    if (profile.times.back() >= out.duration) continue;
    add(std::string(name_of(shaper)), profile);
    shaped.push_back(profile);
  }
  add("searched", search_profile(models, {.start_current = task.start_current,
                                          .lowest = task.lowest_current,
                                          .highest = task.highest_current,
                                          .current = current,
                                          .pieces = task.pieces,
                                          .longest_piece = 0.75 / mode.natural_frequency,
                                          .duration = out.duration,
                                          .starts = shaped}));
  return out;
}

const ProfileQuality& best_profile(const Reach& reach) {
  const auto worst = [](const ProfileQuality& each) {
    return std::pair{std::max(0.0, each.worst.overshoot - most_overshoot), each.worst.settling_or_never()};
  };
  return *std::ranges::min_element(reach.profiles, {}, worst);
}

}  // namespace coilwright::control
