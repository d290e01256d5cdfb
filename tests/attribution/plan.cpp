#include "attribution/plan.hpp"

#include <array>
#include <string>
#include <utility>

#include "truth/hidden_effects.hpp"
#include "truth/random.hpp"

namespace attribution {
namespace {

constexpr std::array sequence = {Category::one, Category::nothing, Category::one,
                                 Category::two, Category::one,     Category::outsider};

// In the order in which the sequence was drawn first; two of the second list have entered the catalogue since.
const std::vector<std::string>& first_catalogue() {
  static const std::vector<std::string> ids{
      "driver_deadband", "driver_saturation",   "current_offset",     "coil_heating",
      "coil_lag",        "force_gain",          "magnet_heating",     "off_axis_force",
      "coil_coil_force", "static_attraction",   "back_emf",           "joint_asymmetry",
      "rest_angle",      "stiffness_hardening", "viscoelastic_creep", "hysteresis",
      "dry_friction",    "quadratic_drag",      "end_stop",           "added_mass",
      "base_tilt",       "measurement_delay",   "angle_scale",        "angle_offset"};
  return ids;
}

const std::vector<std::string>& first_outsiders() {
  static const std::vector<std::string> ids{"shaken_base",   "drifting_stiffness", "mullins_softening",
                                            "random_cable",  "mount_compliance",   "loose_contact",
                                            "torque_ripple", "mains_hum",          "frozen_frames"};
  return ids;
}

// The n-th of an infinite sequence that contains each id once per round, in an order that is drawn for every round.
std::string in_turn(std::vector<std::string> all, int n, std::uint64_t seed) {
  const int size = static_cast<int>(all.size());
  truth::Random random(seed + 1000003u * static_cast<std::uint64_t>(n / size));
  for (int i = size - 1; i > 0; --i) std::swap(all[i], all[random.below(i + 1)]);
  return all[n % size];
}

std::vector<std::string> pair(truth::Random& random) {
  std::vector<std::string> all = first_catalogue();
  std::erase(all, "coil_coil_force");
  const int size = static_cast<int>(all.size());
  const int first = random.below(size);
  const int second = (first + 1 + random.below(size - 1)) % size;
  return {all[first], all[second]};
}

}  // namespace

std::string_view name_of(Category category) {
  switch (category) {
    case Category::one:
      return "one";
    case Category::nothing:
      return "nothing";
    case Category::two:
      return "two";
    case Category::outsider:
      return "outsider";
  }
  return "";
}

std::vector<Case> plan(int first, int count, std::uint64_t seed) {
  std::vector<Case> cases;
  for (int number = first; number < first + count; ++number) {
    const int place = number % static_cast<int>(sequence.size());
    const int round = number / static_cast<int>(sequence.size());
    truth::Random random(seed * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(number));
    Case next{.number = number, .category = sequence[place], .request = {}};
    next.request.seed = random.seed();
    switch (next.category) {
      case Category::one:
        next.request.hidden = {in_turn(first_catalogue(), 3 * round + place / 2, seed)};
        next.request.find_confounders = true;
        break;
      case Category::two:
        next.request.hidden = pair(random);
        break;
      case Category::outsider:
        next.request.hidden = {in_turn(first_outsiders(), round, seed)};
        if (!truth::hidden_kind(next.request.hidden[0]).outsider()) {
          next.category = Category::one;
          next.request.find_confounders = true;
        }
        break;
      case Category::nothing:
        break;
    }
    cases.push_back(std::move(next));
  }
  return cases;
}

}  // namespace attribution
