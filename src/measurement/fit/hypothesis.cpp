#include "measurement/fit/hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coilwright::measurement::fit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Faces that are off by more than three tolerances are not the declared ones: either there are none, and nothing draws
// the number back, or they are elsewhere, and the records say where. A prior without an end would hold faces that
// nobody made just beside the motion, where they are in the way of every other number of the fit.
constexpr double farthest_pull = 3.0;

// A typical change of an effect's number: its distance from the value that means that the effect is absent, at the
// start of the fit.
double scale_of(const actuator::EffectParameter& parameter, double start) {
  const double from_absent = std::abs(start - parameter.absent.value_or(0.0));
  if (from_absent > 0.0 && std::isfinite(from_absent)) return from_absent;
  return start != 0.0 ? std::abs(start) : 1.0;
}

}  // namespace

Hypothesis::Hypothesis(const replay::DeclaredModel& declared, std::vector<actuator::Effect> effects)
    : declared_(&declared), effects_(std::move(effects)) {
  for (const replay::CalibrationParameter& number : declared.calibration)
    parameters_.push_back({.key = number.key,
                           .lower = number.lower,
                           .upper = number.upper,
                           .scale = number.scale,
                           .declared = number.declared,
                           .tolerance = number.tolerance ? number.tolerance->deviation : infinity,
                           .farthest = number.other_start ? farthest_pull : infinity});
  for (const actuator::Effect& effect : effects_) {
    EffectParameters placed{.first = size()};
    const auto numbers = effect.kind->parameters();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!numbers[i].choices.empty()) continue;
      placed.numbers.push_back(i);
      parameters_.push_back({.key = std::string(numbers[i].key),
                             .lower = numbers[i].lower,
                             .upper = numbers[i].upper,
                             .scale = numbers[i].deviation.value_or(scale_of(numbers[i], effect.values[i])),
                             .declared = numbers[i].absent.value_or(0.0),
                             .tolerance = numbers[i].deviation.value_or(infinity)});
    }
    effect_parameters_.push_back(std::move(placed));
  }
}

Eigen::VectorXd Hypothesis::scales() const {
  Eigen::VectorXd out(size());
  for (Eigen::Index i = 0; i < size(); ++i) out[i] = parameters_[static_cast<std::size_t>(i)].scale;
  return out;
}

Eigen::VectorXd Hypothesis::clamped(Eigen::VectorXd values) const {
  for (Eigen::Index i = 0; i < size(); ++i) {
    const FitParameter& parameter = parameters_[static_cast<std::size_t>(i)];
    values[i] = std::clamp(values[i], parameter.lower, parameter.upper);
  }
  return values;
}

Eigen::VectorXd Hypothesis::start() const {
  Eigen::VectorXd out(size());
  Eigen::Index at = 0;
  for (const replay::CalibrationParameter& number : declared_->calibration)
    out[at++] = number.start.value_or(number.declared);
  for (std::size_t e = 0; e < effects_.size(); ++e)
    for (const std::size_t number : effect_parameters_[e].numbers) out[at++] = effects_[e].values[number];
  return clamped(std::move(out));
}

std::vector<actuator::Effect> Hypothesis::effects_at(const Eigen::VectorXd& values) const {
  std::vector<actuator::Effect> out = effects_;
  for (std::size_t e = 0; e < out.size(); ++e)
    for (std::size_t i = 0; i < effect_parameters_[e].numbers.size(); ++i)
      out[e].values[effect_parameters_[e].numbers[i]] =
          values[effect_parameters_[e].first + static_cast<Eigen::Index>(i)];
  return out;
}

bool Hypothesis::is_declared(Eigen::Index parameter) const {
  return static_cast<std::size_t>(parameter) < declared_->calibration.size();
}

bool Hypothesis::is_nominal(Eigen::Index parameter) const {
  return is_declared(parameter) && !declared_->calibration[static_cast<std::size_t>(parameter)].calibrated;
}

Eigen::VectorXd Hypothesis::prior_residuals(const Eigen::VectorXd& values, double model_error) const {
  std::vector<double> out;
  for (Eigen::Index i = 0; i < size(); ++i)
    if (const FitParameter& parameter = parameters_[static_cast<std::size_t>(i)]; parameter.has_prior())
      out.push_back((is_declared(i) ? model_error : 1.0) * parameter.distance(values[i]));
  return Eigen::Map<const Eigen::VectorXd>(out.data(), static_cast<Eigen::Index>(out.size()));
}

Eigen::MatrixXd Hypothesis::prior_jacobian(const Eigen::VectorXd& values, double model_error) const {
  const auto rows = std::ranges::count_if(parameters_, &FitParameter::has_prior);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(rows, size());
  Eigen::Index row = 0;
  for (Eigen::Index i = 0; i < size(); ++i)
    if (const FitParameter& parameter = parameters_[static_cast<std::size_t>(i)]; parameter.has_prior())
      out(row++, i) =
          parameter.is_pulled(values[i]) ? -(is_declared(i) ? model_error : 1.0) / parameter.tolerance : 0.0;
  return out;
}

std::span<const double> Hypothesis::calibration_in(const Eigen::VectorXd& values) const {
  return {values.data(), declared_->calibration.size()};
}

actuator::ModelSpec Hypothesis::spec_at(const Eigen::VectorXd& values) const {
  actuator::ModelSpec spec = declared_->build(calibration_in(values));
  for (actuator::Effect& effect : effects_at(values)) spec.effects.push_back(std::move(effect));
  return spec;
}

actuator::Model Hypothesis::model_at(const Eigen::VectorXd& values) const {
  return actuator::Model(spec_at(values));
}

}  // namespace coilwright::measurement::fit
