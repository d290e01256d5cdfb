#include "measurement/correction/correction_kind.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::measurement::correction {

CorrectionKind::CorrectionKind(CorrectionBasis basis, double scale, double deviation)
    : basis_(std::move(basis)), scale_(scale) {
  for (int i = 0; i < basis_.size(); ++i) keys_.push_back(fmt::format("coefficient_{}", i + 1));
  for (const std::string& key : keys_)
    parameters_.push_back({.key = key,
                           .text = "coefficient of a smooth torque",
                           .lower = -std::numeric_limits<double>::infinity(),
                           .upper = std::numeric_limits<double>::infinity(),
                           .absent = 0.0,
                           .deviation = deviation});
}

std::string_view CorrectionKind::description() const {
  return "a torque that no known effect explains";
}

std::string_view CorrectionKind::equation() const {
  return "q += smooth function of one or two of angle, rate and current";
}

std::string_view CorrectionKind::source() const {
  return "fitted to the records";
}

std::vector<std::vector<double>> CorrectionKind::starts(const actuator::RigScale& /*scale*/) const {
  return {std::vector<double>(parameters_.size(), *parameters_.front().deviation)};
}

std::unique_ptr<const actuator::EffectTerm> CorrectionKind::build(std::span<const double> values,
                                                                  actuator::ModelSpec& spec) const {
  spec.torque_correction = correction(values);
  return nullptr;
}

actuator::TorqueCorrection CorrectionKind::correction(std::span<const double> values) const {
  return basis_.correction(values, scale_);
}

actuator::Effect CorrectionKind::none() const {
  return {.kind = this, .values = std::vector<double>(parameters_.size(), 0.0)};
}

}  // namespace coilwright::measurement::correction
