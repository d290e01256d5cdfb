#include "measurement/replay/declared_duplicates.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/units/angle.hpp"
#include "measurement/replay/if_possible.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::CoilCurrents;
using actuator::Model;
using mechanics::JointVector;

constexpr int poses = 16;
// Half a tolerance: far above the 4e-7 to which curves are interpolated, and still in proportion to a millionth.
constexpr double step_over_tolerance = 0.5;
constexpr double step_over_scale = 0.02;
// Sine squared of the angle between two effects below which they are one.
constexpr double alike_within = 3e-6;

// Evenly spread over 0 to 1, another sequence for each `which` (the fractions of multiples of square roots of primes).
double spread(int i, int which) {
  constexpr double roots[] = {1.4142135623730951, 1.7320508075688772, 2.23606797749979, 2.6457513110645907};
  const int round = which / 4;
  const double value = (i + 1) * roots[which % 4] * (1.0 + 0.1 * round);
  return value - std::floor(value);
}

// A pose in motion under a command.
struct Scene {
  JointVector angles, rates;
  CoilCurrents currents;
  JointVector torques;
};

Scene scene(const Model& model, int i) {
  const int n = model.joints();
  Scene out{.angles = JointVector(n),
            .rates = JointVector(n),
            .currents = CoilCurrents(model.coils()),
            .torques = JointVector::Zero(n)};
  for (int j = 0; j < n; ++j) {
    const bool closed = i % 4 == 3 && (i / 4) % n == j;
    out.angles[j] = closed ? model.hinges()[static_cast<std::size_t>(j)].contact.closing_angle - 1.0 * units::degree
                           : (5.0 + 50.0 * spread(i, j)) * units::degree;
    out.rates[j] = 12.0 * (spread(i, j + 7) - 0.5);
  }
  for (int c = 0; c < model.coils(); ++c) out.currents[c] = 3.0 * (spread(i, c + 3) - 0.4);
  if (model.coils() == 0)
    for (int j = 0; j < n; ++j)
      out.torques[j] = 100.0 * (spread(i, j + 5) - 0.5) * model.chain().mass_matrix(out.angles)(j, j);
  return out;
}

JointVector accelerations(const Model& model, const Scene& at) {
  actuator::InternalStates states = model.settled(at.angles, at.currents);
  model.set_friction(at.rates.cwiseSign(), {states.data(), static_cast<std::size_t>(states.size())});
  std::vector<double> slopes(static_cast<std::size_t>(states.size()));
  JointVector out(model.joints());
  model.derivative(at.angles, at.rates, {states.data(), slopes.size()}, at.currents, at.torques, out, slopes);
  return out;
}

// Accelerations in all scenes, one after the other.
Eigen::VectorXd all_accelerations(const Model& model, const std::vector<Scene>& scenes) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(scenes.size()) * model.joints());
  for (std::size_t i = 0; i < scenes.size(); ++i)
    out.segment(static_cast<Eigen::Index>(i) * model.joints(), model.joints()) = accelerations(model, scenes[i]);
  return out;
}

}  // namespace

std::vector<DuplicateNumber> duplicate_numbers(const DeclaredModel& declared, std::size_t first) {
  std::vector<double> values;
  for (const CalibrationParameter& each : declared.calibration) values.push_back(each.declared);
  const Model model(declared.build(values));
  std::vector<Scene> scenes;
  for (int i = 0; i < poses; ++i) scenes.push_back(scene(model, i));
  const Eigen::VectorXd nominal = all_accelerations(model, scenes);
  // Pressed faces outweigh all else by far: every scene counts by its own size.
  Eigen::VectorXd weights(nominal.size());
  for (Eigen::Index i = 0; i < nominal.size(); i += model.joints())
    weights.segment(i, model.joints()).setConstant(1.0 / std::max(nominal.segment(i, model.joints()).norm(), 1e-9));

  // Nothing where the number makes no model to a side: it moves something, and nothing says that another does the same.
  const auto effect_of = [&](std::size_t number) {
    const CalibrationParameter& each = declared.calibration[number];
    const double step = each.tolerance ? step_over_tolerance * each.tolerance->deviation : step_over_scale * each.scale;
    const auto moved = [&](double by) {
      std::vector<double> at = values;
      at[number] = std::clamp(each.declared + by, each.lower, each.upper);
      return all_accelerations(Model(declared.build(at)), scenes);
    };
    return if_possible<Eigen::VectorXd>(
        [&] { return Eigen::VectorXd((moved(step) - moved(-step)).cwiseProduct(weights)); });
  };

  std::vector<DuplicateNumber> out;
  std::vector<std::pair<std::size_t, Eigen::VectorXd>> kept;  // effects of length 1
  for (std::size_t number = 0; number < declared.calibration.size(); ++number) {
    std::optional<Eigen::VectorXd> possible = effect_of(number);
    if (!possible) continue;
    Eigen::VectorXd& effect = *possible;
    // A millionth of the accelerations: what is left of rounding.
    const bool nothing = effect.norm() <= 1e-6 * std::sqrt(static_cast<double>(poses));
    if (!nothing) effect.normalize();
    const auto alike = std::ranges::find_if(kept, [&](const auto& other) {
      return !nothing && (effect - effect.dot(other.second) * other.second).squaredNorm() < alike_within;
    });
    if (number >= first && (nothing || alike != kept.end()))
      out.push_back({.number = number, .alike = nothing ? std::nullopt : std::optional(alike->first)});
    else if (!nothing)
      kept.emplace_back(number, std::move(effect));
  }
  return out;
}

}  // namespace coilwright::measurement::replay
