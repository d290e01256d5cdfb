#pragma once

#include <boost/numeric/odeint.hpp>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator {

using mechanics::JointVector;
using Numbers = std::vector<double>;

/// One joint with a body of `inertia` (kg m^2) that gravity does not move, on a spring of `stiffness` (N m/rad).
inline ModelSpec rotor(double inertia, double stiffness = 0.0) {
  const mechanics::Link link{.length = 0.1, .com_along = 0.0, .com_offset = 0.0, .mass = 1.0, .inertia = inertia};
  return {.chain = mechanics::PlanarChain({&link, 1}, 0.0),
          .hinges = {{.stiffness = stiffness}},
          .magnetics = {},
          .coils = 0,
          .tip = {.link = 0, .along = 0.1, .offset = 0.0}};
}

/// A finger of the prototype's parts: 2, 4 or 5 joints, 2, 3 or 4 coils. Assembled once, so that its exact curves are.
inline const ModelSpec& finger(Configuration configuration = Configuration::B) {
  static std::map<Configuration, ModelSpec> known;
  if (const auto found = known.find(configuration); found != known.end()) return found->second;
  Design design = paper_finger();
  design.layout = layout_of(configuration);
  return known.emplace(configuration, assemble_or_throw(design).model.nominal_spec()).first->second;
}

/// The same with torques that are only known as curves, as of motors with shafts: for effects that need those.
inline ModelSpec with_motors(ModelSpec spec) {
  std::vector<HingePair> pairs = spec.magnetics.hinge_pairs();
  for (HingePair& pair : pairs) pair.parts = nullptr;
  spec.magnetics = MagneticStage(std::move(pairs), spec.magnetics.distant_pairs());
  return spec;
}

/// The finger, with motors where the effect cannot be without.
inline ModelSpec finger_for(const EffectKind& kind) {
  return kind.inapplicable(finger()) ? with_motors(finger()) : finger();
}

/// A spec with an effect built into it, and what acts while it runs.
struct WithEffect {
  ModelSpec spec;
  std::unique_ptr<const EffectTerm> term;
};

/// Builds the effect of that id in. `values` in SI, inside the bounds.
inline WithEffect with_effect(std::string_view id, Numbers values, ModelSpec spec) {
  const Effect effect{.kind = standard_effects().find(id), .values = std::move(values)};
  validate_effect(effect);
  std::unique_ptr<const EffectTerm> term = effect.kind->build(effect.values, spec);
  return {.spec = std::move(spec), .term = std::move(term)};
}

/// The same of a kind with the further numbers of that id.
inline WithEffect with_further_numbers(std::string_view id, Numbers values, ModelSpec spec) {
  const Effect effect{.kind = standard_effects().find(id)->with_further_numbers(), .values = std::move(values)};
  validate_effect(effect);
  std::unique_ptr<const EffectTerm> term = effect.kind->build(effect.values, spec);
  return {.spec = std::move(spec), .term = std::move(term)};
}

/// Joint torques of the effect alone, N m; slopes of its states go to `slopes` unless null.
inline JointVector torque_of(const WithEffect& rig, const JointVector& angles, const JointVector& rates,
                             const double* states = nullptr, double* slopes = nullptr) {
  JointVector torques = JointVector::Zero(angles.size());
  rig.term->add_torques({.chain = rig.spec.chain, .angles = angles, .rates = rates}, CoilCurrents::Zero(rig.spec.coils),
                        {.states = states, .slopes = slopes}, torques);
  return torques;
}

/// The same for a rig of one joint.
inline double torque_of(const WithEffect& rig, double angle, double rate, const double* states = nullptr,
                        double* slopes = nullptr) {
  return torque_of(rig, JointVector::Constant(1, angle), JointVector::Constant(1, rate), states, slopes)[0];
}

/// Follows y' = slope(y, dy, t) from time 0 for `duration`: Dormand-Prince, 1e-10 a step. `watch(y, t)` sees every
/// step.
template <typename Slope, typename Watch>
void follow(Numbers& y, double duration, Slope&& slope, Watch&& watch) {
  namespace odeint = boost::numeric::odeint;
  odeint::integrate_adaptive(odeint::make_controlled<odeint::runge_kutta_dopri5<Numbers>>(1e-10, 1e-10),
                             std::forward<Slope>(slope), y, 0.0, duration, 1e-6, std::forward<Watch>(watch));
}

template <typename Slope>
void follow(Numbers& y, double duration, Slope&& slope) {
  follow(y, duration, std::forward<Slope>(slope), [](const Numbers&, double) {});
}

/// Follows a rotor of `inertia` under its spring, the effect and `applied` (N m): y = angle, rate, states of the
/// effect.
template <typename Watch>
void follow_rotor(const WithEffect& rig, double applied, Numbers& y, double duration, Watch&& watch) {
  const double inertia = rig.spec.chain.mass_matrix(JointVector::Zero(1))(0, 0);
  const double stiffness = rig.spec.hinges[0].stiffness;
  follow(
      y, duration,
      [&](const Numbers& at, Numbers& slope, double) {
        slope[0] = at[1];
        const double torque = torque_of(rig, at[0], at[1], at.data() + 2, slope.data() + 2);
        slope[1] = (applied - stiffness * at[0] + torque) / inertia;
      },
      std::forward<Watch>(watch));
}

inline void follow_rotor(const WithEffect& rig, double applied, Numbers& y, double duration) {
  follow_rotor(rig, applied, y, duration, [](const Numbers&, double) {});
}

}  // namespace coilwright::actuator
