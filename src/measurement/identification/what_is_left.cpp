#include "measurement/identification/what_is_left.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coilwright::measurement::identification {
namespace {

constexpr double least_deviation = 0.02;
constexpr double deviation_ratio = 1.6;
constexpr double shortest = 2.0;  // samples
constexpr double length_ratio = 2.0;
constexpr int coloured_shares = 10;

// Even in the logarithm.
std::vector<double> lengths_between(double least, double longest) {
  const double span = std::log(std::max(longest, least * length_ratio) / least);
  const auto cells = static_cast<int>(std::ceil(span / std::log(length_ratio)));
  std::vector<double> out;
  for (int i = 0; i < cells; ++i) out.push_back(least * std::exp(span * (i + 0.5) / cells));
  return out;
}

}  // namespace

std::vector<WhatIsLeft> all_that_may_be_left(const RangeOfWhatIsLeft& range) {
  const std::vector<double> lengths = lengths_between(std::max(shortest, range.shortest), range.longest / 3.0);
  const auto count = static_cast<double>(lengths.size());
  const bool may_be_coloured = range.longest_colour > shortest;
  std::vector<WhatIsLeft> out{{.log_prior = (may_be_coloured ? -2.0 : -1.0) * std::numbers::ln2}};
  const double each = 0.5 * 2.0 / std::numbers::pi * std::log(deviation_ratio) / count;
  for (const double length : lengths)
    for (double deviation = least_deviation; deviation <= range.largest_deviation; deviation *= deviation_ratio)
      out.push_back({.missing = {.deviation = deviation, .length = length},
                     .colour = {.deviation = deviation, .length = length},
                     .log_prior = std::log(each * deviation / (1.0 + deviation * deviation))});
  if (!may_be_coloured) return out;
  const std::vector<double> colours = lengths_between(shortest, std::min(range.longest_colour, range.longest / 3.0));
  const double log_prior = std::log(0.25 / (coloured_shares * static_cast<double>(colours.size())));
  for (const double length : colours)
    for (int i = 0; i < coloured_shares; ++i) {
      const double share = (i + 0.5) / coloured_shares;
      out.push_back(
          {.colour = {.deviation = std::sqrt(share), .length = length, .white = 1.0 - share}, .log_prior = log_prior});
    }
  return out;
}

}  // namespace coilwright::measurement::identification
