#include "coilwright/measurement/design_posterior.hpp"

#include <cmath>
#include <exception>
#include <new>
#include <optional>

#include "coilwright/actuator/design/effect_number.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/measurement/corrected_model.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::measurement {
namespace {

// Every number of a design that a fit may move, in the unit of its name.
std::vector<DesignPosterior::Number> numbers_of(const actuator::Design& design) {
  std::vector<DesignPosterior::Number> out;
  for (const actuator::Parameter& parameter : actuator::parameters())
    if (!parameter.whole)
      out.push_back(
          {.name = std::string(parameter.name), .value = units::from_memory(parameter.get(design), parameter.key)});
  for (const actuator::Effect& effect : design.effects)
    for (std::size_t i = 0; i < effect.values.size(); ++i)
      out.push_back({.name = actuator::effect_number_name(effect, i),
                     .value = units::from_memory(effect.values[i], effect.kind->parameters()[i].key)});
  return out;
}

// The numbers of a fit, the calibration first.
struct FittedNumbers {
  std::vector<double> calibration;
  std::vector<actuator::Effect> effects;

  double& operator[](Eigen::Index index) {
    auto place = static_cast<std::size_t>(index);
    if (place < calibration.size()) return calibration[place];
    place -= calibration.size();
    auto effect = effects.begin();
    for (; place >= effect->values.size(); ++effect) place -= effect->values.size();
    return effect->values[place];
  }
};

}  // namespace

DesignPosterior design_posterior(
    const Diagnosis& diagnosis,
    const std::function<actuator::Design(std::span<const double>, const std::vector<actuator::Effect>&)>& updated) {
  const FittedNumbers found{.calibration = calibration_of(diagnosis), .effects = effects_of(diagnosis)};
  const std::vector<DesignPosterior::Number> there = numbers_of(updated(found.calibration, found.effects));
  const auto count = static_cast<Eigen::Index>(there.size());
  // The numbers of the design with one of the fit displaced; nothing where they make no design.
  const auto displaced = [&](Eigen::Index index, double by) -> std::optional<Eigen::VectorXd> {
    FittedNumbers moved = found;
    moved[index] += by;
    try {
      const std::vector<DesignPosterior::Number> numbers = numbers_of(updated(moved.calibration, moved.effects));
      Eigen::VectorXd out(count);
      for (Eigen::Index i = 0; i < count; ++i) out[i] = numbers[static_cast<std::size_t>(i)].value;
      return out;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {
      return std::nullopt;
    }
  };
  const Eigen::MatrixXd& of_fit = diagnosis.covariance;
  Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(count, of_fit.cols());
  for (Eigen::Index index = 0; index < of_fit.cols(); ++index) {
    const double deviation = std::sqrt(of_fit(index, index));
    if (!(deviation > 0.0)) continue;
    constexpr double share = 0.1;
    const auto above = displaced(index, share * deviation);
    const auto below = displaced(index, -share * deviation);
    if (above && below) derivatives.col(index) = (*above - *below) / (2.0 * share * deviation);
  }
  const Eigen::MatrixXd covariance = derivatives * of_fit * derivatives.transpose();
  constexpr double rounding = 1e-9;  // of a number that the fit does not move
  std::vector<Eigen::Index> uncertain;
  for (Eigen::Index i = 0; i < count; ++i)
    if (std::sqrt(covariance(i, i)) > rounding * std::abs(there[static_cast<std::size_t>(i)].value))
      uncertain.push_back(i);
  DesignPosterior out{.numbers = {}, .correlation = covariance(uncertain, uncertain)};
  const Eigen::VectorXd deviations = out.correlation.diagonal().cwiseSqrt();
  for (std::size_t i = 0; i < uncertain.size(); ++i) {
    out.numbers.push_back(there[static_cast<std::size_t>(uncertain[i])]);
    out.numbers.back().sd = deviations[static_cast<Eigen::Index>(i)];
  }
  out.correlation = deviations.cwiseInverse().asDiagonal() * out.correlation * deviations.cwiseInverse().asDiagonal();
  // Rounding may take the correlation of two numbers that are one beyond 1.
  out.correlation = out.correlation.cwiseMax(-1.0).cwiseMin(1.0).eval();
  out.correlation.diagonal().setOnes();
  return out;
}

}  // namespace coilwright::measurement
