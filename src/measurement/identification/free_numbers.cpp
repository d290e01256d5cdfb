#include "measurement/identification/free_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "measurement/fit/fit.hpp"
#include "measurement/fit/parallel.hpp"

namespace coilwright::measurement::identification {
namespace {

// Of the noise, at the sample that moves most; what a fit's difference by a ten-thousandth of a typical change shall
// move at least.
constexpr double seen = 1e-2;
constexpr double share_of_step = 1e-4;

// A fit's residuals and local numbers where `values` are.
std::optional<fit::Fit> at(std::span<const replay::PreparedRun> runs, const replay::DeclaredModel& declared,
                           const Eigen::VectorXd& values, const fit::Fit* beside = nullptr) {
  const fit::Hypothesis hypothesis(declared, {});
  fit::FitRequest request{.hypothesis = &hypothesis, .runs = runs, .start = values, .local_numbers_from = beside};
  if (beside != nullptr) request.effort.iterations = 0;
  return fit::evaluate_at(request);
}

// The change of a number that moves the records by a hundred times their noise, as far as its declared change shows
// less; nothing where no change is seen.
std::optional<double> seen_change(std::span<const replay::PreparedRun> runs, const replay::DeclaredModel& declared,
                                  const fit::Fit& here, std::size_t number) {
  constexpr double largest = 1e6;
  const replay::CalibrationParameter& known = declared.calibration[number];
  for (double factor = 1.0; factor <= largest; factor *= 10.0) {
    Eigen::VectorXd values = here.values;
    double& value = values[static_cast<Eigen::Index>(number)];
    const double step = factor * share_of_step * known.scale;
    value += value + step <= known.upper ? step : -step;
    const auto there = at(runs, declared, values, &here);
    if (!there) return std::nullopt;
    const double change = (there->stacked_residuals - here.stacked_residuals).cwiseAbs().maxCoeff();
    if (change >= seen) return step / share_of_step * (seen / change);
  }
  return std::nullopt;
}

}  // namespace

replay::DeclaredModel with_free_numbers_of_records(std::span<const replay::PreparedRun> runs,
                                                   const replay::DeclaredModel& declared) {
  replay::DeclaredModel out = declared;
  auto here = at(runs, declared, fit::Hypothesis(declared, {}).start());
  if (!here) return out;
  for (std::size_t i = 0; i < out.calibration.size(); ++i) {
    replay::CalibrationParameter& number = out.calibration[i];
    if (number.tolerance) continue;
    const auto change = seen_change(runs, declared, *here, i);
    if (!change) continue;
    number.scale = std::max(number.scale, *change);
    const bool is_size = number.lower >= 0.0 && number.lower <= share_of_step * number.scale;
    if (!is_size) continue;
    constexpr std::array shares{0.01, 0.1, 1.0, 10.0, 100.0};
    std::array<std::optional<fit::Fit>, shares.size()> fits;
    fit::in_parallel(shares.size(), [&](std::size_t k) {
      Eigen::VectorXd values = here->values;
      values[static_cast<Eigen::Index>(i)] = std::clamp(shares[k] * *change, number.lower, number.upper);
      fits[k] = at(runs, declared, values);
    });
    for (auto& each : fits)
      if (each && each->objective() < here->objective()) here = std::move(each);
    number.start = here->values[static_cast<Eigen::Index>(i)];
  }
  return out;
}

}  // namespace coilwright::measurement::identification
