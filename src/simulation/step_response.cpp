#include "coilwright/simulation/step_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "basin.hpp"
#include "bending_record.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "stepper.hpp"

namespace coilwright::simulation {
namespace {

using mechanics::JointVector;

constexpr double settling_band = 0.02;  // of the change: the usual convention
constexpr double smallest_change = 1e-6;
constexpr int most_steps = 200'000;

double change_to(const JointVector& equilibrium, const JointVector& rest) {
  return std::max(std::abs(equilibrium.sum() - rest.sum()), smallest_change);
}

// Which equilibrium a motion circles, asked anew at each turning point: it may have left the first one's basin.
class Destination {
 public:
  Destination(const actuator::Model& model, const actuator::CoilCurrents& currents, const JointVector& rest)
      : model_(model), currents_(currents), rest_(rest) {
    look_from(rest);
  }

  void look_from(const JointVector& angles) {
    const std::optional<JointVector> target = find_equilibrium(model_, currents_, angles);
    if (!target) return;
    if (basin_ && (*target - basin_->equilibrium()).lpNorm<Eigen::Infinity>() < 1e-9) return;
    basin_.emplace(model_, currents_,
                   Basin::Spec{.equilibrium = *target, .excursion = settling_band * change_to(*target, rest_)});
  }
  [[nodiscard]] const std::optional<Basin>& basin() const { return basin_; }

 private:
  const actuator::Model& model_;
  const actuator::CoilCurrents& currents_;
  const JointVector& rest_;
  std::optional<Basin> basin_;
};

StepResponse measure(const BendingRecord& record, double start, const JointVector& steady) {
  const BendingRecord::Peak peak = record.fastest();
  StepResponse out{.steady_angles = steady, .peak_speed = peak.speed, .peak_speed_time = peak.time};
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

// A tenth of the relative accuracy of the change, so that a motion near its end does not ask for more than its start.
Stepper::Tolerance tolerance_for(double relative, double change) {
  return {.relative = relative, .absolute = 0.1 * relative * change};
}

}  // namespace

std::optional<StepResponse> step_response(const actuator::Model& model, const actuator::CoilCurrents& currents,
                                          const JointVector& rest, const StepLimits& limits) {
  Destination destination(model, currents, rest);
  const double change =
      destination.basin() ? change_to(destination.basin()->equilibrium(), rest) : std::numbers::pi / 180.0;
  Stepper stepper(model, tolerance_for(limits.relative_accuracy, change));
  const int n = model.joints();
  stepper.start(0.0, {.angles = rest, .rates = JointVector::Zero(n)},
                {.currents = currents, .applied = JointVector::Zero(n)});
  BendingRecord record(stepper.bending());
  for (int step = 0; step < most_steps && stepper.time() < limits.longest; ++step) {
    stepper.step();
    const State now = stepper.now();
    if (!now.angles.allFinite() || now.angles.lpNorm<Eigen::Infinity>() > std::numbers::pi) return std::nullopt;
    const double speed_before = record.last().speed;
    record.add(stepper.bending());
    if (speed_before * record.last().speed < 0.0) destination.look_from(now.angles);
    if (destination.basin() && destination.basin()->holds(now))
      return measure(record, rest.sum(), destination.basin()->equilibrium());
  }
  return std::nullopt;
}

}  // namespace coilwright::simulation
