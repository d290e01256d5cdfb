#include "measurement/identification/reached_limits.hpp"

#include "measurement/fit/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace coilwright::measurement::identification {
namespace {

// In tolerances, towards the side on which the number does nothing.
constexpr double apart = 0.5;
constexpr double first = -4.0;
constexpr double last = 12.0;

// The places of a number at which it is looked at, inside its bounds.
std::vector<double> places_of(const replay::CalibrationParameter& number) {
  const double way = std::copysign(number.tolerance->deviation, *number.other_start - number.declared);
  std::vector<double> out;
  for (double tolerances = first; tolerances <= last; tolerances += apart) {
    const double place = number.declared + tolerances * way;
    if (place >= number.lower && place <= number.upper) out.push_back(place);
  }
  return out;
}

// Where values have a least one between their neighbours that is below `limit`: the lowest few, the lowest first.
std::vector<std::size_t> lowest_minima(const std::vector<double>& values, double limit) {
  constexpr std::size_t most = 3;
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool falls_to = k == 0 || values[k] < values[k - 1];
    const bool rises_from = k + 1 == values.size() || values[k] <= values[k + 1];
    if (falls_to && rises_from && values[k] < limit) out.push_back(k);
  }
  std::ranges::stable_sort(out, {}, [&](std::size_t k) { return values[k]; });
  out.resize(std::min(out.size(), most));
  return out;
}

}  // namespace

std::vector<PlannedFit> from_reached_limits(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted) {
  std::vector<PlannedFit> out;
  const auto& numbers = fitted.hypothesis.declared().calibration;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i].other_start || !numbers[i].tolerance) continue;
    const std::vector<double> places = places_of(numbers[i]);
    const PlannedFit as_fitted{
        .hypothesis = fitted.hypothesis, .start = fitted.fit.values, .local_numbers_from = &fitted.fit};
    const auto at = [&](double place) {
      PlannedFit plan = as_fitted;
      plan.start[static_cast<Eigen::Index>(i)] = place;
      return plan;
    };
    std::vector<double> objectives(places.size(), std::numeric_limits<double>::infinity());
    fit::in_parallel(places.size(), [&](std::size_t k) {
      const PlannedFit plan = at(places[k]);
      // Local numbers follow by the derivatives of the fit: a place that is chosen is fitted with its own.
      fit::FitRequest request = fit_request_of(runs, plan);
      request.derivatives_from = &fitted.fit;
      request.updates_derivatives = true;
      const auto there = fit::evaluate_at(request);
      if (there) objectives[k] = there->objective();
    });
    for (const std::size_t k : lowest_minima(objectives, fitted.fit.objective())) out.push_back(at(places[k]));
  }
  return out;
}

}  // namespace coilwright::measurement::identification
