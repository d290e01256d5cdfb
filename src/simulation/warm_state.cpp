#include "warm_state.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "coilwright/actuator/demagnetisation.hpp"
#include "coilwright/simulation/blocked_grasp.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "heat_state.hpp"
#include "motion.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Model;
using mechanics::JointVector;

// rad. Heat moves a pose by a hundredth of what the pose moved the heat's, so a pose this near is settled to 1e-10.
constexpr double same_pose = 1e-8;
constexpr int most_rounds = 50;

// rad. A pose this near has the same heat: a magnet's temperature moves by less than a tenth of a kelvin.
constexpr double near_pose = 1e-3;
constexpr int most_attempts = 5;

// What a round of the loop found: the model as warm as `angles` make it.
struct Settled {
  JointVector angles;
  std::optional<Model> model;  // nothing in a thermal runaway
};

std::span<const double> as_span(const thermal::NodeVector& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

// The model with everything as warm as holding it at `angles` makes it.
Settled as_warm_as(const actuator::Design& design, const actuator::Assembly& assembly, const OperatingPoint& point,
                   const MotionSummary& cold, const JointVector& angles) {
  const thermal::NodeVector temperatures = steady_temperatures(design, assembly, point, angles);
  if (temperatures.size() == 0) return {.angles = angles, .model = std::nullopt};
  const std::vector<double> strengths = actuator::magnet_strengths(design, as_span(temperatures));
  return {.angles = angles, .model = held_at_rest(assembly.model.with_magnet_strengths(strengths), cold.rest_angles)};
}

// Temperatures and pose in turn, until the pose stays: `pose_of` gives the pose of a model from a start. Nothing where
// there is none.
template <class PoseOf>
std::optional<Settled> settle(const actuator::Design& design, const actuator::Assembly& assembly,
                              const OperatingPoint& point, const MotionSummary& cold, JointVector angles,
                              const PoseOf& pose_of) {
  for (int round = 0; round < most_rounds; ++round) {
    Settled warm = as_warm_as(design, assembly, point, cold, angles);
    if (!warm.model) return warm;
    const std::optional<JointVector> next = pose_of(*warm.model, angles);
    if (!next) return std::nullopt;
    const double change = (*next - angles).template lpNorm<Eigen::Infinity>();
    angles = *next;
    if (change < same_pose) return Settled{.angles = angles, .model = std::move(warm.model)};
  }
  return std::nullopt;
}

}  // namespace

bool feels_heat(const actuator::Design& design) {
  return design.magnet.remanence_coefficient != 0.0;
}

std::variant<FreeCase, NoPerformance> free_case(const actuator::Design& design, const actuator::Assembly& assembly,
                                                const OperatingPoint& point, const MotionSummary& cold) {
  if (!feels_heat(design))
    return FreeCase{.heat = heat_of(design, assembly, point, cold.steady_angles), .motion = cold};
  const actuator::CoilCurrents on = assembly.model.all_coils(point.current);
  const auto pose_of = [&](const Model& model, const JointVector& start) { return find_equilibrium(model, on, start); };
  // First the pose that magnets and temperatures have in equilibrium. A warm step may end elsewhere, in another
  // equilibrium or where friction stops it: then the heat is that of its end.
  std::optional<Settled> warm = settle(design, assembly, point, cold, cold.steady_angles, pose_of);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    if (!warm) return NoPerformance{"no equilibrium at the steady temperatures"};
    if (!warm->model) return FreeCase{.heat = heat_of(design, assembly, point, warm->angles), .motion = std::nullopt};
    const auto rest = find_equilibrium(*warm->model, assembly.model.all_coils(0.0), cold.rest_angles);
    if (!rest) return NoPerformance{"no stable rest pose at the steady temperatures"};
    auto motion = free_motion_of(*warm->model, point.current, *rest);
    if (const auto* reason = std::get_if<NoPerformance>(&motion)) return *reason;
    FreeMotion& found = std::get<FreeMotion>(motion);
    if ((found.steady_angles - warm->angles).lpNorm<Eigen::Infinity>() < near_pose)
      return FreeCase{.heat = heat_of(design, assembly, point, found.steady_angles), .motion = std::move(found)};
    warm = as_warm_as(design, assembly, point, cold, found.steady_angles);
  }
  return NoPerformance{"the pose and its temperatures do not settle together"};
}

std::variant<GrippingCase, NoPerformance> gripping_case(const actuator::Design& design,
                                                        const actuator::Assembly& assembly, const OperatingPoint& point,
                                                        const MotionSummary& cold) {
  if (!feels_heat(design))
    return GrippingCase{.heat = heat_of(design, assembly, point, cold.grasp_angles), .grasp = cold};
  const actuator::CoilCurrents on = assembly.model.all_coils(point.current);
  Grasp grasp = cold;
  const auto pose_of = [&](const Model& model, const JointVector&) -> std::optional<JointVector> {
    const std::optional<BlockedGrasp> found = blocked_grasp(model, on, point.grasp);
    if (!found) return std::nullopt;
    grasp.grasp_force = found->force;
    grasp.grasp_angles = found->angles;
    return found->angles;
  };
  const std::optional<Settled> warm = settle(design, assembly, point, cold, cold.grasp_angles, pose_of);
  if (!warm) return NoPerformance{"no equilibrium with the tip against a wall at the steady temperatures"};
  GrippingCase out{.heat = heat_of(design, assembly, point, warm->angles), .grasp = std::nullopt};
  if (warm->model) out.grasp = std::move(grasp);
  return out;
}

}  // namespace coilwright::simulation
