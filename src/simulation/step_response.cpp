#include "coilwright/simulation/step_response.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/simulation/equilibrium.hpp"
#include "stepper.hpp"

namespace coilwright::simulation {
namespace {

using mechanics::JointVector;

constexpr double settling_band = 0.02;  // of the change: the usual convention
constexpr double smallest_change = 1e-6;
constexpr int samples_per_step = 4;

// Bending angle and speed along the motion. Between two samples the cubic through both values and slopes stands for the
// motion: with about sixty samples a period its error is below 1e-6 of the amplitude.
struct Sample {
  double time;
  double angle;
  double speed;
};

double hermite(const Sample& a, const Sample& b, double time) {
  const double span = b.time - a.time;
  const double s = (time - a.time) / span;
  const double r = 1.0 - s;
  return r * r * ((1.0 + 2.0 * s) * a.angle + s * span * a.speed) +
         s * s * ((1.0 + 2.0 * r) * b.angle - r * span * b.speed);
}

// Time at which the cubic passes `level`, given that the two ends lie on different sides of it.
double crossing(const Sample& a, const Sample& b, double level) {
  double low = a.time;
  double high = b.time;
  const bool rising = a.angle < level;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    const bool before = (hermite(a, b, middle) < level) == rising;
    (before ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// What decides that a motion cannot leave the settling band about an equilibrium any more.
class Basin {
 public:
  Basin(const actuator::Model& model, const actuator::CoilCurrents& currents, const JointVector& equilibrium,
        double rest_angle)
      : angles_(equilibrium), stiffness_(model.tangent_stiffness(equilibrium, currents)) {
    // The least energy that shows an excursion y of the bending angle is y^2 / (2 sum of the compliance).
    const JointVector ones = JointVector::Ones(model.joints());
    const double compliance = ones.dot(stiffness_.llt().solve(ones));
    change_ = std::max(std::abs(equilibrium.sum() - rest_angle), smallest_change);
    const double excursion = 0.5 * settling_band * change_;
    energy_limit_ = 0.5 * excursion * excursion / compliance;
  }

  [[nodiscard]] bool holds(const actuator::Model& model, const State& state) const {
    const JointVector away = state.angles - angles_;
    if (std::abs(away.sum()) > settling_band * change_) return false;
    const double potential = 0.5 * away.dot(stiffness_ * away);
    return potential < energy_limit_ &&
           potential + model.chain().kinetic_energy(state.angles, state.rates) < energy_limit_;
  }

  [[nodiscard]] const JointVector& angles() const { return angles_; }

 private:
  JointVector angles_;
  mechanics::JointMatrix stiffness_;
  double change_{};
  double energy_limit_{};
};

// Vertex of the parabola through three speeds about the largest one.
void refine_peak(const std::vector<Sample>& samples, std::size_t at, StepResponse& out) {
  out.peak_speed = std::abs(samples[at].speed);
  out.peak_speed_time = samples[at].time;
  if (at == 0 || at + 1 == samples.size()) return;
  const double x0 = samples[at - 1].time - samples[at].time;
  const double x2 = samples[at + 1].time - samples[at].time;
  const double y1 = out.peak_speed;
  const double d0 = (std::abs(samples[at - 1].speed) - y1) / x0;
  const double d2 = (std::abs(samples[at + 1].speed) - y1) / x2;
  const double curvature = (d2 - d0) / (x2 - x0);
  if (curvature >= 0.0) return;
  const double slope = d0 - curvature * x0;
  out.peak_speed_time += -slope / (2.0 * curvature);
  out.peak_speed -= slope * slope / (4.0 * curvature);
}

// Largest angle beyond the end, in the direction of the change.
double overshoot_of(const std::vector<Sample>& samples, double start, double end) {
  const double direction = end > start ? 1.0 : -1.0;
  double beyond = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample& a = samples[i - 1];
    const Sample& b = samples[i];
    beyond = std::max(beyond, direction * (b.angle - end));
    if (a.speed * b.speed >= 0.0) continue;
    // A turning point inside: the cubic's slope is close to linear over so short a span.
    const double turning = a.time + (b.time - a.time) * a.speed / (a.speed - b.speed);
    beyond = std::max(beyond, direction * (hermite(a, b, turning) - end));
  }
  return beyond / std::abs(end - start);
}

std::optional<double> first_passage(const std::vector<Sample>& samples, double level) {
  for (std::size_t i = 1; i < samples.size(); ++i)
    if ((samples[i - 1].angle - level) * (samples[i].angle - level) <= 0.0)
      return crossing(samples[i - 1], samples[i], level);
  return std::nullopt;
}

double settling_of(const std::vector<Sample>& samples, double end, double band) {
  for (std::size_t i = samples.size() - 1; i > 0; --i) {
    const double before = samples[i - 1].angle - end;
    if (std::abs(before) <= band) continue;
    const double level = end + std::copysign(band, before);
    return std::abs(samples[i].angle - end) <= band ? crossing(samples[i - 1], samples[i], level) : samples[i].time;
  }
  return 0.0;
}

StepResponse measure(const std::vector<Sample>& samples, const JointVector& steady) {
  StepResponse out;
  out.steady_angles = steady;
  const auto fastest = std::ranges::max_element(samples, {}, [](const Sample& s) { return std::abs(s.speed); });
  refine_peak(samples, static_cast<std::size_t>(fastest - samples.begin()), out);
  const double start = samples.front().angle;
  const double end = steady.sum();
  if (std::abs(end - start) < smallest_change) return out;
  out.overshoot = overshoot_of(samples, start, end);
  const std::optional<double> tenth = first_passage(samples, start + 0.1 * (end - start));
  const std::optional<double> ninth = first_passage(samples, start + 0.9 * (end - start));
  if (tenth && ninth) out.rise_time = *ninth - *tenth;
  out.settling_time = settling_of(samples, end, settling_band * std::abs(end - start));
  return out;
}

}  // namespace

std::optional<StepResponse> step_response(const actuator::Model& model, const actuator::CoilCurrents& currents,
                                          const JointVector& rest, const StepLimits& limits) {
  std::optional<JointVector> target = find_equilibrium(model, currents, rest);
  std::optional<Basin> basin;
  if (target) basin.emplace(model, currents, *target, rest.sum());

  Stepper stepper(model, limits.relative_accuracy);
  const int n = model.joints();
  stepper.start(0.0, {.angles = rest, .rates = JointVector::Zero(n)},
                {.currents = currents, .applied = JointVector::Zero(n)});
  std::vector<Sample> samples;
  samples.reserve(512);
  samples.push_back({.time = 0.0, .angle = rest.sum(), .speed = 0.0});
  while (stepper.time() < limits.longest) {
    stepper.step();
    const State now = stepper.now();
    if (!now.angles.allFinite() || now.angles.lpNorm<Eigen::Infinity>() > std::numbers::pi) return std::nullopt;
    const double span = stepper.time() - stepper.previous_time();
    for (int i = 1; i < samples_per_step; ++i) {
      const double time = stepper.previous_time() + span * i / samples_per_step;
      const State state = stepper.at(time);
      samples.push_back({.time = time, .angle = state.angles.sum(), .speed = state.rates.sum()});
    }
    const double speed_before = samples[samples.size() - samples_per_step].speed;
    samples.push_back({.time = stepper.time(), .angle = now.angles.sum(), .speed = now.rates.sum()});
    // At each turning point the motion is asked anew which equilibrium it circles: it may have left the first one's.
    if (speed_before * now.rates.sum() < 0.0) {
      target = find_equilibrium(model, currents, now.angles);
      if (target && (!basin || (*target - basin->angles()).lpNorm<Eigen::Infinity>() > 1e-9))
        basin.emplace(model, currents, *target, rest.sum());
    }
    if (basin && basin->holds(model, now)) return measure(samples, basin->angles());
  }
  return std::nullopt;
}

}  // namespace coilwright::simulation
