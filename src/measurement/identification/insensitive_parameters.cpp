#include "measurement/identification/insensitive_parameters.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

namespace coilwright::measurement::identification {
namespace {

// Half of the way is left out fourteen times: 45 degrees to 0.003.
constexpr int halvings = 14;
// Of chi-square: as much as an optimum is known to.
constexpr double notable = 0.1;

}  // namespace

std::vector<InsensitiveParameter> insensitive_parameters(std::span<const replay::PreparedRun> runs,
                                                         const FittedHypothesis& fitted) {
  std::vector<InsensitiveParameter> out;
  const auto chi_square_at = [&](Eigen::Index number, double value) {
    Eigen::VectorXd values = fitted.fit.values;
    values[number] = value;
    auto there = fit::evaluate_at({.hypothesis = &fitted.hypothesis,
                                   .runs = runs,
                                   .start = values,
                                   .local_numbers_from = &fitted.fit,
                                   .effort = {.iterations = 0}});
    return there ? there->chi_square : std::numeric_limits<double>::infinity();
  };
  for (Eigen::Index i = 0; i < fitted.hypothesis.size(); ++i) {
    const fit::FitParameter& parameter = fitted.hypothesis.parameters()[static_cast<std::size_t>(i)];
    if (!parameter.has_prior() || parameter.is_pulled(fitted.fit.values[i])) continue;
    if (!fitted.fit.jacobian.col(i).isZero(0.0)) continue;
    const double most = chi_square_at(i, fitted.fit.values[i]) + notable;
    double idle = fitted.fit.values[i];
    double notable_at = parameter.declared;
    for (int step = 0; step < halvings; ++step) {
      const double middle = 0.5 * (idle + notable_at);
      (chi_square_at(i, middle) <= most ? idle : notable_at) = middle;
    }
    out.push_back({.index = i, .nearest = idle});
  }
  return out;
}

double probability_of_declared_numbers(const FittedHypothesis& fitted, std::span<const InsensitiveParameter> idle) {
  double squares = fitted.fit.prior_chi_square;
  for (const InsensitiveParameter& each : idle) {
    const fit::FitParameter& parameter = fitted.hypothesis.parameters()[static_cast<std::size_t>(each.index)];
    const double whole = (parameter.declared - each.nearest) / parameter.tolerance;
    const double counted = parameter.distance(fitted.fit.values[each.index]);
    squares += whole * whole - counted * counted;
  }
  return probability_of_distance(fitted.hypothesis, squares);
}

}  // namespace coilwright::measurement::identification
