#include "exports/chain/plain_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>
#include <utility>

#include "coilwright/text/csv/csv_writer.hpp"

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

constexpr double widest_step = 2.0 * std::numbers::pi / 180.0;
constexpr double linear_tolerance = 5e-4;  // of the largest torque
constexpr int most_steps = 480;

TorqueTable sampled(const actuator::HingePair& pair, int steps) {
  const magnetics::Curve& curve = *pair.torque_per_ampere;
  TorqueTable table{.joint = pair.joint, .coil = pair.coil};
  const double step = (curve.upper() - curve.lower()) / steps;
  for (int i = 0; i <= steps; ++i) {
    table.angles.push_back(i == steps ? curve.upper() : curve.lower() + i * step);
    table.torques.push_back(pair.sense * curve.value(table.angles.back()));
  }
  // The miss of a straight line is largest near its middle.
  for (std::size_t i = 0; i + 1 < table.angles.size(); ++i) {
    const double middle = pair.sense * curve.value(0.5 * (table.angles[i] + table.angles[i + 1]));
    table.linear_error =
        std::max(table.linear_error, std::abs(middle - 0.5 * (table.torques[i] + table.torques[i + 1])));
  }
  return table;
}

TorqueTable table_of(const actuator::HingePair& pair) {
  const magnetics::Curve& curve = *pair.torque_per_ampere;
  // A rational interpolant of the third degree needs four rows.
  int steps = std::max(4, static_cast<int>(std::ceil((curve.upper() - curve.lower()) / widest_step)));
  TorqueTable table = sampled(pair, steps);
  while (table.linear_error > linear_tolerance * largest_torque(table) && 2 * steps <= most_steps) {
    steps *= 2;
    table = sampled(pair, steps);
  }
  return table;
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

std::vector<TorqueTable> torque_tables(const actuator::Model& model) {
  std::vector<TorqueTable> tables;
  for (const actuator::HingePair& pair : model.magnetics().hinge_pairs()) tables.push_back(table_of(pair));
  return tables;
}

double last_angle(int joint, const std::vector<TorqueTable>& tables) {
  double last = std::numbers::pi;
  for (const TorqueTable& table : tables)
    if (table.joint == joint) last = std::min(last, table.angles.back());
  return last;
}

double largest_torque(const TorqueTable& table) {
  double largest = 0.0;
  for (const double torque : table.torques) largest = std::max(largest, std::abs(torque));
  return largest;
}

std::string torque_csv(const std::vector<TorqueTable>& tables) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"joint", "coil", "angle_rad", "torque_Nm_A"});
  for (const TorqueTable& table : tables)
    for (std::size_t i = 0; i < table.angles.size(); ++i)
      csv.row({table.joint + 1, table.coil + 1, table.angles[i], table.torques[i]});
  return out.str();
}

}  // namespace coilwright::exports
