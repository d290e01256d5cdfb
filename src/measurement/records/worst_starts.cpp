#include "measurement/records/worst_starts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace coilwright::measurement::records {

bool is_worst_at_start(const replay::PreparedRun& prepared, std::span<const std::vector<double>> predictions) {
  constexpr std::size_t at_start = 15;
  constexpr double far = 3.0;
  const data::Run& run = *prepared.run;
  if (!prepared.is_motion() || run.start != data::Start::measured) return false;
  for (std::size_t c = 0; c < run.channels.size(); ++c) {
    double first = 0.0;
    double rest = 0.0;
    std::size_t firsts = 0;
    std::size_t rests = 0;
    for (std::size_t i = 0; i < predictions[c].size(); ++i) {
      if (prepared.is_set_aside(c, i)) continue;
      const double left = (run.channels[c].values[i] - predictions[c][i]) / prepared.noise[c].sigma;
      (i < at_start ? first : rest) += left * left;
      ++(i < at_start ? firsts : rests);
    }
    if (firsts == 0 || rests == 0) continue;
    const double of_first = std::sqrt(first / static_cast<double>(firsts));
    if (of_first >= far && of_first >= far * std::sqrt(rest / static_cast<double>(rests))) return true;
  }
  return false;
}

std::vector<data::Warning> worst_starts(std::span<const std::string> runs) {
  if (runs.empty()) return {};
  std::string alike;
  if (runs.size() > 1) alike = fmt::format(", and so in {}", fmt::join(runs.subspan(1), ", "));
  return {
      {.run = runs.front(),
       .text = fmt::format("what is left over is worst at the start{}: it is not as the first samples say, as where "
                           "the input jumps at t = 0. \"start\": \"free\" lets the fit find it",
                           alike)}};
}

}  // namespace coilwright::measurement::records
