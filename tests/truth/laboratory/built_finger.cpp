#include "truth/laboratory/built_finger.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace truth::laboratory {
namespace {

// Relative standard deviations: a balance and cut silicone, a caliper, datasheets of magnets (N52: 1.43 to 1.48 T),
// hinges cast alike.
struct Kind {
  const char* name;
  double declared;
  double usual;
  std::function<void(Finger&, double factor)> set;
};

enum Index { first_mass, tip_mass, tip_com, first_magnet, second_magnet, stiffness_ratio, damping_ratio, curve };

const std::array<Kind, 8>& kinds() {
  static const std::array<Kind, 8> all{{
      {"/links/0/mass_kg", 0.0165, 0.02, [](Finger& f, double x) { f.first_mass *= x; }},
      {"/links/1/mass_kg", 0.0225, 0.05, [](Finger& f, double x) { f.second_mass *= x; }},
      {"/links/1/com_along_m", 0.0091, 0.04, [](Finger& f, double x) { f.second_com *= x; }},
      {"/magnetics/0/magnet/remanence_T", 1.44, 0.015, [](Finger& f, double x) { f.force_factor[0] *= x; }},
      {"/magnetics/1/magnet/remanence_T", 1.44, 0.015, [](Finger& f, double x) { f.force_factor[1] *= x; }},
      {"joint_stiffness_ratio", 1.0, 0.06, [](Finger& f, double x) { f.second_stiffness_ratio *= x; }},
      {"joint_damping_ratio", 1.0, 0.08, [](Finger& f, double x) { f.second_damping_ratio *= x; }},
      {"force_curve", 0.0, 0.035, nullptr},
  }};
  return all;
}

constexpr double tight = 0.25;   // tolerances of numbers that are moved far, over the usual ones
constexpr double scale = 0.005;  // relative standard deviation of the camera's scale

double cut_normal(Random& random) {
  for (;;) {
    const double x = random.normal();
    if (std::abs(x) <= 2.0) return x;
  }
}

// Smoothly random with this rms over -20 to 70 degrees.
CurveError draw_curve(Random& random, double rms) {
  CurveError error{};
  double weight = 1.0;
  for (double& coefficient : error) {
    coefficient = weight * random.normal();
    weight *= 0.7;
  }
  double squares = 0.0;
  constexpr int points = 90;
  for (int i = 0; i < points; ++i) {
    const double angle = (-20.0 + i + 0.5) * 0.017453292519943295;
    squares += std::pow(curve_error(error, angle), 2);
  }
  const double is = std::sqrt(squares / points);
  for (double& coefficient : error) coefficient *= rms / is;
  return error;
}

// Relative deviations; of force_curve: the rms error.
using Deviations = std::array<double, 8>;

Deviations draw_within(Random& random, double share) {
  Deviations off{};
  for (std::size_t i = 0; i < off.size(); ++i) off[i] = share * kinds()[i].usual * cut_normal(random);
  off[curve] = std::abs(off[curve]);
  return off;
}

Deviations draw_reported(Random& random) {
  Deviations off = draw_within(random, 1.0);
  off[tip_mass] = random.sign() * random.uniform(0.06, 0.08);
  off[tip_com] = 0.05;
  off[stiffness_ratio] = -random.uniform(0.06, 0.10);
  off[curve] = random.uniform(0.03, 0.04);
  return off;
}

// By how much a number is far off.
void move_far(Random& random, int which, double times, Deviations& off) {
  switch (which) {
    case 0:
      off[tip_mass] = times * random.sign() * random.uniform(0.10, 0.15);
      break;
    case 1:
      off[tip_com] = times * random.sign() * random.uniform(0.10, 0.15);
      break;
    case 2:
      off[first_magnet] = off[second_magnet] = -times * random.uniform(0.06, 0.10);
      break;
    case 3:
      off[stiffness_ratio] = times * random.sign() * random.uniform(0.2, 0.3);
      break;
    default:
      off[curve] = times * random.uniform(0.07, 0.09);
  }
}

}  // namespace

BuiltFinger build_finger(Random& random, Deviation deviation, Tolerances tolerances) {
  BuiltFinger built;
  built.finger.stiffness *= 1.0 + random.sign() * random.uniform(0.02, 0.08);
  built.finger.damping *= 1.0 + random.sign() * random.uniform(0.03, 0.12);
  // Nobody says how exact the numbers are: they must be off further to be off further than anybody would assume.
  const double share = deviation == Deviation::far && tolerances == Tolerances::listed ? tight : 1.0;
  Deviations off{};
  std::array<bool, 5> is_far{};
  if (deviation == Deviation::within) off = random.sign() > 0.0 ? draw_within(random, 1.0) : draw_reported(random);
  if (deviation == Deviation::far) {
    off = draw_within(random, share);
    const int first = random.below(5);
    is_far[first] = true;
    if (random.uniform() < 0.4) is_far[(first + 1 + random.below(4)) % 5] = true;
    for (int i = 0; i < 5; ++i)
      if (is_far[i]) move_far(random, i, tolerances == Tolerances::listed ? 1.0 : 2.0, off);
  }
  if (deviation != Deviation::none && tolerances == Tolerances::absent)
    built.angle_scale = 1.0 + scale * cut_normal(random);

  const std::array<bool, 8> far{false, is_far[0], is_far[1], is_far[2], is_far[2], is_far[3], false, is_far[4]};
  for (std::size_t i = 0; i < off.size(); ++i) {
    const Kind& kind = kinds()[i];
    if (kind.set) kind.set(built.finger, 1.0 + off[i]);
    built.numbers.push_back({.name = kind.name,
                             .declared = kind.declared,
                             .is = kind.set ? kind.declared * (1.0 + off[i]) : off[i],
                             .tolerance = share * kind.usual * (kind.declared == 0.0 ? 1.0 : kind.declared),
                             .far = far[i]});
  }
  if (off[curve] > 0.0) built.finger.curve_error = draw_curve(random, off[curve]);
  return built;
}

void set_number(const std::string& name, double factor, Finger& finger) {
  for (const Kind& kind : kinds()) {
    if (name != kind.name || !kind.set) continue;
    kind.set(finger, factor);
    return;
  }
  throw std::out_of_range("declared number: must be one with a factor; got " + name);
}

}  // namespace truth::laboratory
