#include "report/diagnosis/diagnosis_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coilwright/report/simulation/text_table.hpp"

namespace coilwright::report {
namespace {

using formats::EstimateInUnit;

// Digits that a number bears whose interval is this wide: two of the half width's.
int digits_of(const EstimateInUnit& shown) {
  const double half_width = 0.5 * (shown.upper - shown.lower);
  if (!std::isfinite(half_width) || half_width <= 0.0 || std::abs(shown.value) <= half_width) return 3;
  const double places = std::floor(std::log10(std::abs(shown.value))) - std::floor(std::log10(half_width));
  return std::clamp(static_cast<int>(places) + 2, 3, 12);
}

std::string interval_text(const measurement::identification::Estimate& estimate, const EstimateInUnit& shown,
                          int digits) {
  if (!estimate.determined) return "not determined by these data";
  const bool lower = std::isfinite(shown.lower);
  const bool upper = std::isfinite(shown.upper);
  if (lower && upper) return fmt::format("{:.{}g} to {:.{}g} (95 %)", shown.lower, digits, shown.upper, digits);
  if (lower) return fmt::format("at least {} (95 %)", number_text(shown.lower));
  if (upper) return fmt::format("at most {} (95 %)", number_text(shown.upper));
  return "no bound on either side (95 %)";
}

// Values that the fits compared with the model.
std::size_t values_fitted(const measurement::Diagnosis& diagnosis) {
  std::size_t values = 0;
  for (const measurement::ErrorComparison& each : diagnosis.fit_errors) values += each.samples;
  return values;
}

}  // namespace

std::string number_text(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "none";
}

std::string in_unit_text(double value, const units::Unit& unit) {
  const std::string readable = readable_unit(unit.suffix);
  return number_text(units::from_si(value, unit)) + (readable.empty() ? "" : " " + readable);
}

std::vector<std::string> estimate_row(const measurement::identification::Estimate& estimate) {
  const EstimateInUnit shown = formats::in_unit(estimate);
  const int digits = digits_of(shown);
  return {estimate.key, fmt::format("{:.{}g}", shown.value, digits), interval_text(estimate, shown, digits)};
}

std::string moved_to_text(const measurement::MovedNumber& number) {
  const std::optional<double> from = formats::in_unit(number).idle_from;
  if (!from) return number_text(formats::in_unit(number.estimate).value);
  return fmt::format("{} {}", *number.idle_from < number.declared ? "below" : "above", number_text(*from));
}

std::string counted(std::size_t count, const char* one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

double over_noise(const measurement::Diagnosis& diagnosis, double chi_square) {
  const std::size_t values = values_fitted(diagnosis);
  return values > 0 ? std::sqrt(chi_square / static_cast<double>(values)) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace coilwright::report
