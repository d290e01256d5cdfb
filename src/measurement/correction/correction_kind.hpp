#pragma once

#include <string>

#include "coilwright/actuator/model/described_effect.hpp"
#include "measurement/correction/correction_basis.hpp"

namespace coilwright::measurement::correction {

/// A correction as a fit takes it: an effect whose numbers are the coefficients of a basis, each with a normal prior of
/// standard deviation `deviation` about zero. In no catalogue: no search tries it. Must outlive every effect,
/// hypothesis and fit that refers to it.
class CorrectionKind final : public actuator::EffectKind {
 public:
  /// `scale`: torque of a coefficient of 1, N m, > 0; `deviation` > 0.
  CorrectionKind(CorrectionBasis basis, double scale, double deviation);

  [[nodiscard]] std::string_view id() const override { return "torque_correction"; }
  [[nodiscard]] actuator::Stage stage() const override { return actuator::Stage::chain; }
  [[nodiscard]] std::string_view description() const override;
  [[nodiscard]] std::string_view equation() const override;
  [[nodiscard]] std::string_view source() const override;
  [[nodiscard]] std::span<const actuator::EffectParameter> parameters() const override { return parameters_; }
  [[nodiscard]] std::vector<std::vector<double>> starts(const actuator::RigScale& scale) const override;
  [[nodiscard]] std::unique_ptr<const actuator::EffectTerm> build(std::span<const double> values,
                                                                  actuator::ModelSpec& spec) const override;

  [[nodiscard]] const CorrectionBasis& basis() const noexcept { return basis_; }
  /// The correction with these coefficients.
  [[nodiscard]] actuator::TorqueCorrection correction(std::span<const double> values) const;
  /// The effect with all coefficients zero.
  [[nodiscard]] actuator::Effect none() const;

 private:
  CorrectionBasis basis_;
  double scale_;
  std::vector<std::string> keys_;
  std::vector<actuator::EffectParameter> parameters_;
};

}  // namespace coilwright::measurement::correction
