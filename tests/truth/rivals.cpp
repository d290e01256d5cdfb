#include "truth/rivals.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "truth/hidden.hpp"

namespace truth {
namespace {

constexpr double visible = 6.0;  // standard deviations, all samples together
constexpr int draws = 6;         // of sign and shape
constexpr double probe = 0.02;   // of the bound: where the strength of a draw is measured

double dot(const Films& a, const Films& b, const Films& origin) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - origin[i]).dot(b[i] - origin[i]);
  return sum;
}

// What of `target` is left beside the best positive multiple of `rival`, both cleared of stiffness and damping, rad.
double left_beside(const Films& target, const Films& rival, const Films& nominal) {
  const double square = dot(rival, rival, nominal);
  const double whole = dot(target, target, nominal);
  const double common = dot(target, rival, nominal);
  if (square <= 0.0 || common <= 0.0) return std::sqrt(whole);
  return std::sqrt(std::max(whole - common * common / square, 0.0));
}

}  // namespace

std::vector<std::string> rivals_of(const Suspect& suspect) {
  const Calibration calibration(suspect.camera, suspect.finger, suspect.runs, suspect.nominal);
  const Films target = calibration.absorb(suspect.moved, suspect.nominal);
  const double size = whole_difference(target, suspect.nominal);
  const Reach reach = reach_of(suspect.finger, suspect.runs);

  std::vector<std::string> found;
  for (const HiddenKind& kind : hidden_kinds()) {
    if (kind.outsider || kind.id == suspect.id) continue;
    Random random(1);
    for (int draw = 0; draw < (kind.numbers.empty() ? 1 : draws); ++draw) {
      Quirks quirks;
      const auto set_strength = kind.draw(random, reach, quirks);
      const auto cleared_at = [&](double share) {
        set_strength(quirks, share);
        return calibration.absorb(film(suspect.camera, suspect.finger, quirks, suspect.runs), suspect.nominal);
      };
      try {
        Films rival = cleared_at(probe);
        // again where it is about as strong as the suspect: a stop or a saturation looks different there
        const double strength = whole_difference(rival, suspect.nominal);
        if (!kind.numbers.empty() && strength > 0.0) rival = cleared_at(std::min(probe * size / strength, 1.0));
        if (kind.numbers.empty()) {  // it is there as it is, no stronger
          if (whole_difference(target, rival) >= visible * suspect.noise) continue;
        } else if (left_beside(target, rival, suspect.nominal) >= visible * suspect.noise) {
          continue;
        }
      } catch (const std::runtime_error&) {
        continue;  // such a finger flies off: it is not what was filmed
      }
      found.push_back(kind.id);
      break;
    }
  }
  return found;
}

}  // namespace truth
