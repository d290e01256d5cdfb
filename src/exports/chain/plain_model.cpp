#include "exports/chain/plain_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace coilwright::exports {
namespace {

using actuator::MagneticStage;
using mechanics::JointVector;

// Of the torque that neighbours make at 1 A: what moves a finger's steady angle by about a degree.
constexpr double notable_share = 0.05;

// The largest joint torque of some pairs on the straight chain, N m, with its sign.
double largest(const MagneticStage& pairs, const actuator::Model& model, double current) {
  const JointVector straight = JointVector::Zero(model.joints());
  JointVector torques = JointVector::Zero(model.joints());
  pairs.add_torques(model.chain(), straight, model.all_coils(current), torques);
  double found = 0.0;
  for (const double torque : torques)
    if (std::abs(torque) > std::abs(found)) found = torque;
  return found;
}

}  // namespace

DistantForces distant_forces(const actuator::Model& model) {
  std::vector<actuator::DistantPair> magnets;
  std::vector<actuator::DistantPair> with_coils;
  for (const actuator::DistantPair& pair : model.magnetics().distant_pairs())
    (pair.coil < 0 ? magnets : with_coils).push_back(pair);
  constexpr double milli = 1e3;
  const double of_magnets = milli * largest(MagneticStage({}, magnets), model, 0.0);
  const double of_coils = milli * largest(MagneticStage({}, with_coils), model, 1.0);
  const double of_neighbours = milli * largest(MagneticStage(model.magnetics().hinge_pairs(), {}), model, 1.0);
  DistantForces out;
  if (!magnets.empty())
    out.lines.push_back(
        fmt::format("the pull between magnets: up to {:.3g} Nmm on a joint of the straight actuator", of_magnets));
  if (!with_coils.empty())
    out.lines.push_back(
        fmt::format("forces of coils on parts that are not their neighbours: up to {:.3g} Nmm on a joint of the "
                    "straight actuator at 1 A in every coil, where neighbours make {:.3g} Nmm",
                    of_coils, of_neighbours));
  const double lost = std::max(std::abs(of_magnets), std::abs(of_coils));
  if (lost <= notable_share * std::abs(of_neighbours)) return out;
  out.lines.back() += "; so much that its motion is not the actuator's";
  out.too_much = fmt::format(
      "links with a torque curve for each joint cannot have forces between parts that are not neighbours, which make "
      "up to {:.3g} Nmm on a joint of this actuator (neighbours {:.3g} Nmm at 1 A)",
      lost, std::abs(of_neighbours));
  return out;
}

std::vector<std::string> heat_of_a_design(const actuator::Model& model) {
  if (!model.coil_resistance()) return {};
  return {"heat: everything is at 20 degC, as in the quantities of evaluate that have cold in their names"};
}

std::vector<std::string> shares_of_coils(const actuator::Model& model) {
  const actuator::CoilCurrents shares = model.current_shares();
  if ((shares.array() == 1.0).all()) return {};
  const std::vector<double> each(shares.begin(), shares.end());
  return {
      fmt::format("the shares of the operating current that the coils carry, {} from base to tip: torques are per "
                  "ampere in their own coil",
                  fmt::join(each, " and "))};
}

PlainModel plain_model(const actuator::Model& model) {
  actuator::ModelSpec spec = model.nominal_spec();
  std::vector<std::string> left_out;
  std::vector<actuator::Effect> effects = std::exchange(spec.effects, {});
  for (actuator::Effect& effect : effects) {
    actuator::ModelSpec trial = spec;
    if (effect.kind->build(effect.values, trial) == nullptr) {
      spec.effects.push_back(std::move(effect));
      continue;
    }
    left_out.push_back(fmt::format("effect {}: {}", effect.kind->id(), effect.kind->description()));
  }
  if (spec.torque_correction) {
    left_out.emplace_back("torque_correction: the torque that a diagnosis fitted");
    spec.torque_correction.reset();
  }
  PlainModel plain{.model = actuator::Model(std::move(spec)), .left_out = std::move(left_out)};
  DistantForces distant = distant_forces(plain.model);
  std::ranges::move(distant.lines, std::back_inserter(plain.left_out));
  std::ranges::move(heat_of_a_design(plain.model), std::back_inserter(plain.left_out));
  std::ranges::move(shares_of_coils(plain.model), std::back_inserter(plain.left_out));
  plain.too_much = std::move(distant.too_much);
  return plain;
}

}  // namespace coilwright::exports
