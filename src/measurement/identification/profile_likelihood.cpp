#include "measurement/identification/profile_likelihood.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "coilwright/algebra/minimum_norm.hpp"
#include "measurement/fit/scales.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {
namespace {

constexpr int largest_number_of_doublings = 8;

bool is_magnitude(const fit::FitParameter& parameter, double value) {
  return parameter.lower >= 0.0 && value > 0.0;
}

// How the other parameters follow one that is held, by the curvature at the optimum.
Eigen::VectorXd change_of_others(const FittedHypothesis& fitted, Eigen::Index parameter) {
  const Eigen::VectorXd scales = fit::scales_at(fitted.hypothesis, fitted.fit.values);
  const Eigen::MatrixXd normal = scales.asDiagonal() * fitted.fit.normal_matrix * scales.asDiagonal();
  const Eigen::VectorXd column = algebra::minimum_norm(normal, Eigen::VectorXd::Unit(scales.size(), parameter));
  Eigen::VectorXd out = Eigen::VectorXd::Zero(scales.size());
  if (!(column[parameter] > 0.0) || !column.allFinite()) return out;
  out = scales.cwiseProduct(column) / (column[parameter] * scales[parameter]);
  for (Eigen::Index i = 0; i < out.size(); ++i)
    if (fitted.fit.at_bound[static_cast<std::size_t>(i)]) out[i] = 0.0;
  return out;
}

}  // namespace

ProfileLikelihood::ProfileLikelihood(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                                     Eigen::Index parameter, double overdispersion)
    : runs_(runs),
      fitted_(fitted),
      parameter_(parameter),
      overdispersion_(overdispersion),
      last_values_(fitted.fit.values),
      best_values_(fitted.fit.values),
      best_chi_square_(fitted.fit.objective()) {
  const fit::FitParameter& number = fitted.hypothesis.parameters()[static_cast<std::size_t>(parameter)];
  lower_ = number.lower;
  upper_ = number.upper;
  scale_ = number.scale;
  logarithmic_ = is_magnitude(number, fitted.fit.values[parameter]);
  along_ = change_of_others(fitted, parameter);
}

double ProfileLikelihood::crossing(double direction, double deviation) {
  last_values_ = fitted_.fit.values;
  const double estimate = fitted_.fit.values[parameter_];
  const double centre = coordinate(estimate);
  const double bound = coordinate(direction > 0.0 ? upper_ : lower_);
  const double step = direction * first_step(estimate, deviation);
  double inside = centre;
  double inside_value = -chi_square_95;
  for (int i = 0; i < largest_number_of_doublings; ++i) {
    const double wanted = centre + step * std::pow(2.0, i);
    const double at = direction > 0.0 ? std::min(wanted, bound) : std::max(wanted, bound);
    const double value = above_limit(at);
    if (value >= 0.0) return value_at(root(inside, inside_value, at, value, 0.01 * std::abs(at - centre)));
    if (at == bound) break;
    inside = at;
    inside_value = value;
  }
  return std::copysign(std::numeric_limits<double>::infinity(), direction);
}

double ProfileLikelihood::coordinate(double value) const {
  return logarithmic_ ? std::log(value) : value;
}

double ProfileLikelihood::value_at(double coordinate) const {
  return logarithmic_ ? std::exp(coordinate) : coordinate;
}

double ProfileLikelihood::first_step(double estimate, double deviation) const {
  double step = 1.05 * normal_95 * deviation;
  if (!std::isfinite(step)) step = scale_;
  return logarithmic_ ? std::min(step / estimate, std::numbers::ln2) : step;
}

// The profile minus the 95 % limit; positive outside the interval.
double ProfileLikelihood::above_limit(double coordinate) {
  const double value = value_at(coordinate);
  Eigen::VectorXd start = last_values_ + (value - last_values_[parameter_]) * along_;
  start[parameter_] = value;
  fit::FitRequest request{.hypothesis = &fitted_.hypothesis,
                          .runs = runs_,
                          .start = fitted_.hypothesis.clamped(std::move(start)),
                          .local_numbers_from = &fitted_.fit,
                          .derivatives_from = &fitted_.fit,
                          .updates_derivatives = true,
                          .held_parameter = parameter_,
                          .effort = search_effort.profile};
  auto refitted = fit::fit(request);
  if (!refitted) return chi_square_95;  // a model that cannot be simulated is no explanation
  const auto above = [&](const fit::Fit& at) {
    return (at.objective() - fitted_.fit.objective()) / overdispersion_ - chi_square_95;
  };
  // The derivatives are those of the optimum, carried on from step to step. Outside the limit a fit that is stuck with
  // them would end the interval: they are taken anew as long as that helps. Not of a model that is far from the noise,
  // whose error no interval within it contains: on long records in windows that took minutes.
  const int turns = is_far_from_noise(fitted_) ? 0 : search_effort.most_profile_turns;
  for (int turn = 0; turn < turns && above(*refitted) >= 0.0; ++turn) {
    request.start = refitted->values;
    request.local_numbers_from = &*refitted;
    request.derivatives_from = nullptr;
    auto anew = fit::fit(request);
    if (!anew || anew->objective() >= refitted->objective()) break;
    const double gained = above(*refitted) - above(*anew);
    refitted = std::move(anew);
    if (gained < search_effort.better_optimum) break;
  }
  last_values_ = refitted->values;
  if (refitted->objective() < best_chi_square_) {
    best_chi_square_ = refitted->objective();
    best_values_ = refitted->values;
  }
  return above(*refitted);
}

double ProfileLikelihood::root(double inside, double inside_value, double outside, double outside_value,
                               double tolerance) {
  std::uintmax_t evaluations = 6;
  const auto function = [this](double coordinate) { return above_limit(coordinate); };
  const auto close = [&](double a, double b) { return std::abs(a - b) <= tolerance; };
  const auto [a, b] = inside < outside ? boost::math::tools::toms748_solve(function, inside, outside, inside_value,
                                                                           outside_value, close, evaluations)
                                       : boost::math::tools::toms748_solve(function, outside, inside, outside_value,
                                                                           inside_value, close, evaluations);
  return 0.5 * (a + b);
}

}  // namespace coilwright::measurement::identification
