#include "truth/data_set.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "truth/confounders.hpp"
#include "truth/hidden_effects.hpp"
#include "truth/random.hpp"
#include "truth/recording.hpp"

namespace truth {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double noise = 0.3 * degree;
constexpr double resolution_deg = 0.02;

// An effect is visible if it changes all samples together by at least so many standard deviations of the noise.
constexpr double visible = 6.0;

// The share of its bound at which an effect has the strength that is asked for; 1 if it is weaker even at its bound.
template <typename StrengthAt>
double share_for(double asked, StrengthAt&& strength_at) {
  const auto excess = [&](double log_share) {
    double there = 1e3;  // a finger that leaves its range or has no equilibrium: too strong
    try {
      there = strength_at(std::exp(log_share));
    } catch (const std::runtime_error&) {
    }
    return std::log(std::max(there, 1e-6) / asked);
  };
  const double at_bound = excess(0.0);
  if (at_bound <= 0.0) return 1.0;
  const double weakest = std::log(1e-5);
  const double at_weakest = excess(weakest);
  if (at_weakest >= 0.0) return std::exp(weakest);
  std::uintmax_t iterations = 20;
  // Half a per cent is far below the accuracy with which the strength of an effect can be determined.
  const auto [lower, upper] = boost::math::tools::toms748_solve(
      excess, weakest, 0.0, at_weakest, at_bound, [](double a, double b) { return std::abs(b - a) < 5e-3; },
      iterations);
  return std::exp(lower);
}

}  // namespace

DataSet make_data_set(const DataSetRequest& request) {
  Random random(request.seed);
  DataSet set{.request = request, .answer = {}, .runs = {}};
  Finger finger;
  // The true values differ from those of Table II by a few per cent.
  finger.stiffness *= 1.0 + random.sign() * random.uniform(0.02, 0.08);
  finger.damping *= 1.0 + random.sign() * random.uniform(0.03, 0.12);
  set.answer = {.seed = request.seed,
                .hidden = {},
                .joint_stiffness = finger.stiffness,
                .joint_damping = finger.damping,
                .noise = noise,
                .resolution = resolution_deg * degree};

  const PlannedRuns planned = request.programme == Programme::brief ? brief_runs() : paper_runs();
  UnmodelledEffects all;
  all.chance = random.seed();
  if (!request.hidden.empty()) {
    const RecordedAngles nominal = recorded_angles(request.camera, finger, {}, planned.fit);
    const Calibration calibration(request.camera, finger, planned.fit, nominal);
    const AngleRange range = angle_range_of(finger, planned.fit);
    for (const std::string& id : request.hidden) {
      const HiddenKind& kind = hidden_kind(id);
      UnmodelledEffects alone;
      alone.chance = all.chance;
      const double asked = random.log_uniform(request.weakest, request.strongest);
      const auto set_strength = kind.draw(random, range, alone);
      const auto with = [&](double share) {
        UnmodelledEffects effects = alone;
        set_strength(effects, share);
        return recorded_angles(request.camera, finger, effects, planned.fit);
      };
      // The strength of an outsider is that after the fit of stiffness and damping: one that they compensate would test
      // nothing.
      const auto strength = [&](double share) {
        const RecordedAngles moved = with(share);
        return largest_difference(kind.outsider ? calibration.absorb(moved, nominal) : moved, nominal) / noise;
      };
      const bool adjustable = !kind.numbers.empty();
      const double share = adjustable ? share_for(asked, strength) : 1.0;
      set_strength(alone, share);
      const RecordedAngles moved = with(share);
      const RecordedAngles left = calibration.absorb(moved, nominal);
      HiddenEffect effect{.id = kind.id,
                          .outsider = kind.outsider,
                          .numbers = {},
                          .asked = adjustable ? asked : 0.0,
                          .strength = largest_difference(moved, nominal) / noise,
                          .strength_after_calibration = largest_difference(left, nominal) / noise,
                          .visible = total_difference(left, nominal) > visible * noise};
      if (request.find_confounders && request.hidden.size() == 1)
        effect.confounders = confounders_of({.id = kind.id,
                                             .camera = request.camera,
                                             .finger = finger,
                                             .runs = planned.fit,
                                             .nominal = nominal,
                                             .moved = moved,
                                             .noise = noise});
      for (const HiddenNumber& number : kind.numbers) {
        all.*number.member = alone.*number.member;
        effect.numbers.push_back({.key = number.key, .value = alone.*number.member * number.denominator});
      }
      all.off_axis = all.off_axis || alone.off_axis;
      all.coil_coil = all.coil_coil || alone.coil_coil;
      set.answer.hidden.push_back(std::move(effect));
    }
  }

  const auto record_run = [&](const Experiment& experiment, bool validate) {
    Random camera_noise(random.seed());
    const Eigen::VectorXd seen = camera_view(request.camera, all, experiment, simulate(finger, all, experiment));
    RecordedRun recorded{.experiment = experiment, .validate = validate, .angles_deg = {}};
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < experiment.times.size(); ++i) {
      std::vector<double>& row = recorded.angles_deg.emplace_back();
      for (int c = 0; c < channel_count(request.camera); ++c) {
        const double angle_deg = (seen[at++] + noise * camera_noise.normal()) / degree;
        row.push_back(std::round(angle_deg / resolution_deg) * resolution_deg);
      }
    }
    set.runs.push_back(std::move(recorded));
  };
  for (const Experiment& experiment : planned.fit) record_run(experiment, false);
  for (const Experiment& experiment : planned.validate) record_run(experiment, true);
  return set;
}

}  // namespace truth
