#include "coilwright/actuator/model/as_built.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/actuator/parts/hinge_pair_parts.hpp"

namespace coilwright::actuator {
namespace {

void spread(std::vector<Hinge>& hinges, double Hinge::*member, double ratio, const char* name) {
  if (!(ratio >= -2.0 && ratio <= 2.0))
    throw std::invalid_argument(fmt::format("{} must be from -2 to 2; got {}", name, ratio));
  for (std::size_t j = 0; j < hinges.size(); ++j) hinges[j].*member *= 1.0 + (j % 2 == 0 ? -0.5 : 0.5) * ratio;
}

void require_one_each(const std::vector<double>& factors, std::size_t parts, const char* name) {
  if (factors.size() != parts)
    throw std::invalid_argument(fmt::format("{}: one each, {} here; got {}", name, parts, factors.size()));
}

// Each has a coil beside it.
std::size_t magnets_of(const MagneticStage& magnetics) {
  int last = -1;
  for (const HingePair& pair : magnetics.hinge_pairs()) last = std::max(last, pair.magnet);
  return static_cast<std::size_t>(last + 1);
}

// Pairs that are alike share one curve, and share it still.
MagneticStage with_curve_error(const MagneticStage& magnetics, const TorqueCurveError& error) {
  std::vector<HingePair> pairs = magnetics.hinge_pairs();
  std::map<const magnetics::Curve*, std::shared_ptr<const magnetics::Curve>> curves;
  std::map<const HingePairParts*, std::shared_ptr<const HingePairParts>> parts;
  for (HingePair& pair : pairs) {
    auto& curve = curves[pair.torque_per_ampere.get()];
    if (!curve) curve = with_error(pair.torque_per_ampere, error);
    pair.torque_per_ampere = curve;
    if (!pair.parts) continue;
    auto& made_of = parts[pair.parts.get()];
    if (!made_of) made_of = std::make_shared<const HingePairParts>(pair.parts, error);
    pair.parts = made_of;
  }
  return {std::move(pairs), magnetics.distant_pairs()};
}

}  // namespace

ModelSpec as_built(ModelSpec spec, const AsBuilt& differences) {
  if (differences.joint_stiffness_ratio != 0.0)
    spread(spec.hinges, &Hinge::stiffness, differences.joint_stiffness_ratio, "joint_stiffness_ratio");
  if (differences.joint_damping_ratio != 0.0)
    spread(spec.hinges, &Hinge::damping, differences.joint_damping_ratio, "joint_damping_ratio");
  if (const std::vector<double>& factors = differences.joint_stiffness_factors; !factors.empty()) {
    require_one_each(factors, spec.hinges.size(), "joint_stiffness_factors");
    for (std::size_t j = 0; j < factors.size(); ++j) spec.hinges[j].stiffness *= factors[j];
  }
  if (const std::vector<double>& factors = differences.remanence_factors; !factors.empty()) {
    require_one_each(factors, magnets_of(spec.magnetics), "remanence_factors");
    spec.magnetics = spec.magnetics.with_magnet_strengths(factors);
  }
  if (differences.face_closing_shift != 0.0)
    for (Hinge& hinge : spec.hinges) hinge.contact.closing_angle += differences.face_closing_shift;
  if (differences.force_curve && !differences.force_curve->none())
    spec.magnetics = with_curve_error(spec.magnetics, *differences.force_curve);
  if (differences.torque_correction) spec.torque_correction = differences.torque_correction;
  return spec;
}

}  // namespace coilwright::actuator
