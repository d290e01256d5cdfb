#include "coilwright/simulation/step_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bending_record.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "joint_peak.hpp"
#include "settling_detector.hpp"
#include "settling_energy_criterion.hpp"
#include "stepper.hpp"

namespace coilwright::simulation {
namespace {

using mechanics::JointVector;

constexpr double settling_band = 0.02;  // of the change: the usual convention
constexpr double smallest_change = 1e-6;
constexpr int most_steps_till_settled = 200'000;

double change_to(const JointVector& equilibrium, const JointVector& rest) {
  return std::max(std::abs(equilibrium.sum() - rest.sum()), smallest_change);
}

// The equilibrium about which a motion oscillates, found anew at each turning point: the motion may have gone over to
// another one.
class Destination {
 public:
  Destination(const actuator::Model& model, const actuator::CoilCurrents& currents, const JointVector& rest)
      : model_(model), currents_(currents), rest_(rest) {
    update(rest, 0.0);
  }

  void update(const JointVector& angles, double time) {
    const std::optional<JointVector> target = find_equilibrium(model_, currents_, angles);
    if (!target) return;
    if (energy_criterion_ && (*target - energy_criterion_->equilibrium()).lpNorm<Eigen::Infinity>() < 1e-9) return;
    const double change = change_to(*target, rest_);
    energy_criterion_.emplace(
        model_, currents_, SettlingEnergyCriterion::Spec{.equilibrium = *target, .excursion = settling_band * change});
    if (model_.has_terms())
      detector_.emplace(
          linear_system(model_, *target, currents_),
          SettlingDetector::Spec{.equilibrium = *target, .change = change, .band = settling_band, .start = time});
  }
  [[nodiscard]] const std::optional<SettlingEnergyCriterion>& energy_criterion() const { return energy_criterion_; }

  // Where the motion ends, once it cannot leave the settling band about that any more.
  [[nodiscard]] std::optional<JointVector> reached(double time, const State& state) {
    if (detector_) return detector_->observe(time, state.angles);
    if (energy_criterion_ && energy_criterion_->confines(state)) return energy_criterion_->equilibrium();
    return std::nullopt;
  }

 private:
  const actuator::Model& model_;
  const actuator::CoilCurrents& currents_;
  const JointVector& rest_;
  std::optional<SettlingEnergyCriterion> energy_criterion_;
  std::optional<SettlingDetector> detector_;  // instead, where effects act
};

StepResponse measure(const BendingRecord& record, const JointPeak& joint_peak, double start,
                     const JointVector& steady) {
  const BendingRecord::Peak peak = record.fastest();
  StepResponse out{.steady_angles = steady,
                   .peak_speed = peak.speed,
                   .peak_speed_time = peak.time,
                   // A motion that creeps to its end is left before it is there.
                   .peak_angle = std::max(record.largest(), steady.sum()),
                   .peak_joint_angle = std::max(joint_peak.angle(), steady.lpNorm<Eigen::Infinity>())};
  const double end = steady.sum();
  const double change = end - start;
  if (std::abs(change) < smallest_change) return out;
  out.overshoot = record.beyond(end) / std::abs(change);
  const std::optional<double> tenth = record.first_passage(start + 0.1 * change);
  const std::optional<double> ninth = record.first_passage(start + 0.9 * change);
  if (tenth && ninth) out.rise_time = *ninth - *tenth;
  out.settling_time = record.last_outside(end, settling_band * std::abs(change));
  return out;
}

// Effects' states have units of their own. Those that are smaller than angles where they matter are torques, of a few
// thousandths of a newton metre in a finger.
constexpr double internal_share = 1e-2;

// A tenth of the relative accuracy of the change, so that a motion near its end does not ask for more than its start.
StepTolerance tolerance_for(double relative, double change) {
  const double absolute = 0.1 * relative * change;
  return {.relative = relative, .absolute = absolute, .internal = internal_share * absolute};
}

}  // namespace

std::optional<StepResponse> step_response(const actuator::Model& model, const actuator::CoilCurrents& currents,
                                          const JointVector& rest, const StepLimits& limits) {
  Destination destination(model, currents, rest);
  const double change = destination.energy_criterion() ? change_to(destination.energy_criterion()->equilibrium(), rest)
                                                       : std::numbers::pi / 180.0;
  Stepper stepper(model, tolerance_for(limits.relative_accuracy, change));
  const int n = model.joints();
  stepper.start(0.0,
                {.angles = rest, .rates = JointVector::Zero(n), .internal = model.settled(rest, model.all_coils(0.0))},
                {.currents = currents, .applied = JointVector::Zero(n)});
  BendingRecord record(stepper.bending());
  JointPeak joint_peak(stepper.now());
  for (int step = 0; step < most_steps_till_settled && stepper.time() < limits.longest; ++step) {
    stepper.step();
    const State now = stepper.now();
    if (!now.angles.allFinite() || now.angles.lpNorm<Eigen::Infinity>() > std::numbers::pi) return std::nullopt;
    const double speed_before = record.last().speed;
    record.add(stepper.bending());
    joint_peak.add(stepper, now);
    if (speed_before * record.last().speed < 0.0) destination.update(now.angles, stepper.time());
    if (const std::optional<JointVector> end = destination.reached(stepper.time(), now))
      return measure(record, joint_peak, rest.sum(), *end);
  }
  return std::nullopt;
}

}  // namespace coilwright::simulation
