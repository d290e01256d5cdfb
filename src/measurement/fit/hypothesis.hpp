#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::fit {

/// A number that a fit varies.
struct FitParameter {
  std::string key{};  ///< with its unit, as reports write it
  double lower{};     ///< physical lower bound, SI; may be -infinity
  double upper{};     ///< physical upper bound, SI; may be infinity
  double scale{};     ///< typical change, SI; > 0
  /// Prior: normal about the declared value. Infinite for a number that is free.
  double declared{};
  double tolerance = std::numeric_limits<double>::infinity();
  /// The prior pulls no harder than so many tolerances away, and beyond not at all.
  double farthest = std::numeric_limits<double>::infinity();
  [[nodiscard]] bool has_prior() const { return std::isfinite(tolerance); }
  /// How far a value is from the declared one, in tolerances, as the prior counts it.
  [[nodiscard]] double distance(double value) const {
    return std::clamp((declared - value) / tolerance, -farthest, farthest);
  }
  [[nodiscard]] bool is_pulled(double value) const {
    return has_prior() && std::abs(declared - value) < farthest * tolerance;
  }
};

/// The declared model with additional effects, whose numbers are fitted together with the calibration.
///
/// Its parameter vector contains the calibration, then the numbers of each effect in turn. Numbers that are one of a
/// few choices are not among them: they belong to the hypothesis itself.
class Hypothesis {
 public:
  /// Refers to `declared`. `effects` carry the values from which a fit starts.
  Hypothesis(const replay::DeclaredModel& declared, std::vector<actuator::Effect> effects);

  [[nodiscard]] const replay::DeclaredModel& declared() const noexcept { return *declared_; }
  [[nodiscard]] const std::vector<actuator::Effect>& effects() const noexcept { return effects_; }
  [[nodiscard]] const std::vector<FitParameter>& parameters() const noexcept { return parameters_; }
  [[nodiscard]] Eigen::Index size() const noexcept { return static_cast<Eigen::Index>(parameters_.size()); }
  /// Typical changes, one per parameter.
  [[nodiscard]] Eigen::VectorXd scales() const;
  /// `values` clamped to the bounds.
  [[nodiscard]] Eigen::VectorXd clamped(Eigen::VectorXd values) const;
  /// Where a fit of the calibration starts, as declared unless CalibrationParameter::start says otherwise, and the
  /// numbers of the effects given to the constructor, clamped to the bounds.
  [[nodiscard]] Eigen::VectorXd start() const;
  /// The effects with the numbers in `values`.
  [[nodiscard]] std::vector<actuator::Effect> effects_at(const Eigen::VectorXd& values) const;
  /// The calibration in `values`.
  [[nodiscard]] std::span<const double> calibration_in(const Eigen::VectorXd& values) const;
  /// Where the numbers of one effect are in the parameter vector.
  struct EffectParameters {
    Eigen::Index first{};                ///< index of the first of them
    std::vector<std::size_t> numbers{};  ///< their indices among the parameters of the effect's kind
  };
  [[nodiscard]] const EffectParameters& parameters_of(std::size_t effect) const noexcept {
    return effect_parameters_[effect];
  }
  /// Numbers that only the tolerances of the declared model let move. They are the same ones in every hypothesis.
  [[nodiscard]] bool is_nominal(Eigen::Index parameter) const;
  /// FitParameter::distance of each number that has a prior; in their order. Those of declared numbers are times
  /// `model_error`: see PreparedRun::model_error.
  [[nodiscard]] Eigen::VectorXd prior_residuals(const Eigen::VectorXd& values, double model_error = 1.0) const;
  /// Their derivatives there: (numbers with a prior, size()).
  [[nodiscard]] Eigen::MatrixXd prior_jacobian(const Eigen::VectorXd& values, double model_error = 1.0) const;
  /// The specification of the model. Throws std::invalid_argument if the calibration makes no model.
  [[nodiscard]] actuator::ModelSpec spec_at(const Eigen::VectorXd& values) const;
  /// The model. Throws std::invalid_argument if the values make no model.
  [[nodiscard]] actuator::Model model_at(const Eigen::VectorXd& values) const;

 private:
  [[nodiscard]] bool is_declared(Eigen::Index parameter) const;

  const replay::DeclaredModel* declared_;
  std::vector<actuator::Effect> effects_;
  std::vector<FitParameter> parameters_;
  std::vector<EffectParameters> effect_parameters_;
};

}  // namespace coilwright::measurement::fit
