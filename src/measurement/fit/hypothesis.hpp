#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::fit {

/// A number that a fit moves.
struct FitParameter {
  std::string key{};         ///< with its unit, as reports write it
  double denominator = 1.0;  ///< SI value = value in the key's unit / denominator
  double lower{};            ///< SI, may be infinite
  double upper{};
  double scale{};  ///< size of a usual change, SI; > 0
};

/// What may be missing: the declared model with some effects, their numbers and the calibration open.
///
/// Its parameter vector is the calibration, then the numbers of each effect in turn, but for those that are one of a
/// few choices, which belong to the hypothesis itself.
class Hypothesis {
 public:
  /// Refers to `declared`. `effects` carry the values from which a fit starts.
  Hypothesis(const replay::DeclaredModel& declared, std::vector<actuator::Effect> effects);

  [[nodiscard]] const replay::DeclaredModel& declared() const noexcept { return *declared_; }
  [[nodiscard]] const std::vector<actuator::Effect>& effects() const noexcept { return effects_; }
  [[nodiscard]] const std::vector<FitParameter>& parameters() const noexcept { return parameters_; }
  [[nodiscard]] Eigen::Index size() const noexcept { return static_cast<Eigen::Index>(parameters_.size()); }
  /// Sizes of usual changes, one per parameter.
  [[nodiscard]] Eigen::VectorXd scales() const;
  /// `values` moved inside the bounds.
  [[nodiscard]] Eigen::VectorXd clamped(Eigen::VectorXd values) const;
  /// Calibration as declared, effects at their starts.
  [[nodiscard]] Eigen::VectorXd start() const;
  /// The effects with the numbers of `values`.
  [[nodiscard]] std::vector<actuator::Effect> effects_at(const Eigen::VectorXd& values) const;
  /// The calibration in `values`.
  [[nodiscard]] std::span<const double> calibration_in(const Eigen::VectorXd& values) const;
  /// Index of the first parameter of effect `i` in the vector, and how many of its numbers are there.
  struct Share {
    Eigen::Index first{};
    std::vector<std::size_t> numbers{};  ///< which of the kind's parameters they are
  };
  [[nodiscard]] const Share& share(std::size_t i) const noexcept { return shares_[i]; }
  /// All that makes the model. Throws std::invalid_argument where the calibration makes none.
  [[nodiscard]] actuator::ModelSpec spec_at(const Eigen::VectorXd& values) const;
  /// The model. Throws std::invalid_argument where the values make none.
  [[nodiscard]] actuator::Model model_at(const Eigen::VectorXd& values) const;

 private:
  const replay::DeclaredModel* declared_;
  std::vector<actuator::Effect> effects_;
  std::vector<FitParameter> parameters_;
  std::vector<Share> shares_;
};

}  // namespace coilwright::measurement::fit
