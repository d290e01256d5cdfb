#include "truth/confounders.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "truth/hidden_effects.hpp"

namespace truth {
namespace {

constexpr int draws = 6;        // of sign and shape of each kind
constexpr double probe = 0.02;  // share of the bound at which the strength of a draw is determined

double dot(const RecordedAngles& a, const RecordedAngles& b, const RecordedAngles& origin) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - origin[i]).dot(b[i] - origin[i]);
  return sum;
}

// Norm of `target` minus the best positive multiple of `rival`, rad; both after the fit of stiffness and damping.
double norm_beside(const RecordedAngles& target, const RecordedAngles& rival, const RecordedAngles& nominal) {
  const double square = dot(rival, rival, nominal);
  const double whole = dot(target, target, nominal);
  const double common = dot(target, rival, nominal);
  if (square <= 0.0 || common <= 0.0) return std::sqrt(whole);
  return std::sqrt(std::max(whole - common * common / square, 0.0));
}

}  // namespace

std::vector<std::string> confounders_of(const ConfounderRequest& request) {
  const Calibration calibration(request.camera, request.finger, request.runs, request.nominal);
  const RecordedAngles target = calibration.absorb(request.moved, request.nominal);
  const double size = total_difference(target, request.nominal);
  const AngleRange range = angle_range_of(request.finger, request.runs);

  std::vector<std::string> found;
  for (const HiddenKind& kind : hidden_kinds()) {
    if (kind.outsider() || kind.id == request.id) continue;
    Random random(1);
    for (int draw = 0; draw < (kind.numbers.empty() ? 1 : draws); ++draw) {
      UnmodelledEffects effects;
      const auto set_strength = kind.draw(random, range, effects);
      const auto calibrated_at = [&](double share) {
        set_strength(effects, share);
        return calibration.absorb(recorded_angles(request.camera, request.finger, effects, request.runs),
                                  request.nominal);
      };
      try {
        RecordedAngles rival = calibrated_at(probe);
        // Again at about the strength of the hidden effect: a stop or a saturation has another shape there.
        const double strength = total_difference(rival, request.nominal);
        if (!kind.numbers.empty() && strength > 0.0) rival = calibrated_at(std::min(probe * size / strength, 1.0));
        if (kind.numbers.empty()) {  // it has no strength
          if (total_difference(target, rival) >= visible * request.noise) continue;
        } else if (norm_beside(target, rival, request.nominal) >= visible * request.noise) {
          continue;
        }
      } catch (const std::runtime_error&) {
        continue;  // such a finger leaves its range of angles: it was not recorded
      }
      found.push_back(kind.id);
      break;
    }
  }
  return found;
}

}  // namespace truth
