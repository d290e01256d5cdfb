#include "coilwright/actuator/parts/hinge_pair_parts.hpp"

#include <stdexcept>

#include "coilwright/magnetics/pair_curve.hpp"

namespace coilwright::actuator {

using magnetics::Curve;

std::shared_ptr<const Curve> HingePairParts::curve(magnetics::Fidelity fidelity, const Curve::Spec& range) const {
  return std::make_shared<const Curve>(
      magnetics::torque_curve(spec_.coil, spec_.magnet, spec_.geometry, fidelity, range));
}

std::shared_ptr<const Curve> HingePairParts::torque() const {
  if (computed_) return with_error(computed_->torque(), error_);
  if (spec_.fidelity == magnetics::Fidelity::exact) return exact_torque();
  if (spec_.line_of_centres_lower) {
    Curve::Spec wide = spec_.range;
    wide.lower = *spec_.line_of_centres_lower;
    try {
      return curve(spec_.fidelity, wide);
    } catch (const std::domain_error&) {
      // Not smooth that far for these parts.
    }
  }
  return curve(spec_.fidelity, spec_.range);
}

std::shared_ptr<const Curve> HingePairParts::exact_torque() const {
  const std::lock_guard lock(mutex_);
  if (!exact_ && computed_) exact_ = with_error(computed_->exact_torque(), error_);
  if (!exact_) exact_ = curve(magnetics::Fidelity::exact, spec_.range);
  return exact_;
}

}  // namespace coilwright::actuator
