#include "truth/data_set.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "truth/film.hpp"
#include "truth/hidden.hpp"
#include "truth/random.hpp"
#include "truth/rivals.hpp"

namespace truth {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double noise = 0.3 * degree;
constexpr double resolution_deg = 0.02;

// Below this many standard deviations of all samples together nobody can see a thing in the noise.
constexpr double visible = 6.0;

// The share of its bound at which an effect has a strength; 1 where even the bound does not.
template <typename StrengthAt>
double share_for(double asked, StrengthAt&& strength_at) {
  const auto excess = [&](double log_share) {
    double there = 1e3;  // where the finger flies off or finds no rest the effect is too strong
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
  // half a per cent is far closer than anybody can tell the strength of an effect
  const auto [lower, upper] = boost::math::tools::toms748_solve(
      excess, weakest, 0.0, at_weakest, at_bound, [](double a, double b) { return std::abs(b - a) < 5e-3; },
      iterations);
  return std::exp(lower);
}

}  // namespace

DataSet make_data_set(const Order& order) {
  Random random(order.seed);
  DataSet set{.order = order, .answer = {}, .runs = {}};
  Finger finger;
  // What Table II says is a few per cent off.
  finger.stiffness *= 1.0 + random.sign() * random.uniform(0.02, 0.08);
  finger.damping *= 1.0 + random.sign() * random.uniform(0.03, 0.12);
  set.answer = {.seed = order.seed,
                .hidden = {},
                .joint_stiffness = finger.stiffness,
                .joint_damping = finger.damping,
                .noise = noise,
                .resolution = resolution_deg * degree};

  const Bench bench = order.programme == Programme::brief ? brief_bench() : paper_bench();
  Quirks all;
  all.chance = random.seed();
  if (!order.hidden.empty()) {
    const Films nominal = film(order.camera, finger, {}, bench.fit);
    const Calibration calibration(order.camera, finger, bench.fit, nominal);
    const Reach reach = reach_of(finger, bench.fit);
    for (const std::string& id : order.hidden) {
      const HiddenKind& kind = hidden_kind(id);
      Quirks alone;
      alone.chance = all.chance;
      const double asked = random.log_uniform(order.weakest, order.strongest);
      const auto set_strength = kind.draw(random, reach, alone);
      const auto with = [&](double share) {
        Quirks quirks = alone;
        set_strength(quirks, share);
        return film(order.camera, finger, quirks, bench.fit);
      };
      // An outsider is as strong as that where stiffness and damping have taken up what they can: one that hides in
      // them would test nothing.
      const auto strength = [&](double share) {
        const Films moved = with(share);
        return largest_difference(kind.outsider ? calibration.absorb(moved, nominal) : moved, nominal) / noise;
      };
      const bool adjustable = !kind.numbers.empty();
      const double share = adjustable ? share_for(asked, strength) : 1.0;
      set_strength(alone, share);
      const Films moved = with(share);
      const Films left = calibration.absorb(moved, nominal);
      HiddenEffect effect{.id = kind.id,
                          .outsider = kind.outsider,
                          .numbers = {},
                          .asked = adjustable ? asked : 0.0,
                          .strength = largest_difference(moved, nominal) / noise,
                          .strength_after_calibration = largest_difference(left, nominal) / noise,
                          .visible = whole_difference(left, nominal) > visible * noise};
      if (order.find_rivals && order.hidden.size() == 1)
        effect.rivals = rivals_of({.id = kind.id,
                                   .camera = order.camera,
                                   .finger = finger,
                                   .runs = bench.fit,
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

  const auto shoot = [&](const Experiment& experiment, bool validate) {
    Random flicker(random.seed());
    const Eigen::VectorXd seen = observed(order.camera, all, experiment, record(finger, all, experiment));
    Recording recording{.experiment = experiment, .validate = validate, .angles_deg = {}};
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < experiment.times.size(); ++i) {
      std::vector<double>& row = recording.angles_deg.emplace_back();
      for (int c = 0; c < channels(order.camera); ++c) {
        const double angle_deg = (seen[at++] + noise * flicker.normal()) / degree;
        row.push_back(std::round(angle_deg / resolution_deg) * resolution_deg);
      }
    }
    set.runs.push_back(std::move(recording));
  };
  for (const Experiment& experiment : bench.fit) shoot(experiment, false);
  for (const Experiment& experiment : bench.validate) shoot(experiment, true);
  return set;
}

}  // namespace truth
