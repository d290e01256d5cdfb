#include "measurement/replay/input_noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "coilwright/measurement/signals/noise_level.hpp"
#include "measurement/replay/command_shape.hpp"
#include "measurement/signals/whittaker_smoother.hpp"

namespace coilwright::measurement::replay {
namespace {

constexpr double least_share = 0.003;  // of the range: less is the resolution of a logger
constexpr double most_alike = 0.2;     // of the neighbours: more, and the column is a command
constexpr double edge_deviations = 8.0;
constexpr double edge_over_median = 4.0;  // times the median step of an input that moves all the time
constexpr std::size_t fewest_samples_of_level = 40;
constexpr std::size_t shortest_level = 3;  // samples on each side of an edge

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// What levels must differ by on both sides of an edge: more than the noise makes of them, and more than an input that
// moves from sample to sample (a chirp) does in as many samples as lie between the two medians. Cut at its steepest
// parts, a chirp of 8 s would have hundreds of pieces with errors of their own.
double least_edge(const std::vector<double>& values, double sigma) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) steps.push_back(std::abs(values[i] - values[i - 1]));
  const double moves =
      std::max(0.0, median(std::move(steps)) - sigma);  // 0 where it rests: noise alone makes 0.95 sigma
  return std::max(edge_deviations * sigma, edge_over_median * static_cast<double>(shortest_level) * moves);
}

// First samples after an edge: the medians of the levels on both sides differ by more than `least`.
std::vector<std::size_t> edges_of(const std::vector<double>& values, double least) {
  std::vector<std::size_t> out;
  for (std::size_t i = shortest_level; i + shortest_level <= values.size(); ++i) {
    const auto at = [&](std::size_t k) { return values.begin() + static_cast<std::ptrdiff_t>(k); };
    const double before = median({at(i - shortest_level), at(i)});
    const double after = median({at(i), at(i + shortest_level)});
    if (std::abs(after - before) < least) continue;
    // Of the places beside one another that qualify, the largest single step is the edge.
    if (!out.empty() && i - out.back() < 2 * shortest_level) {
      if (std::abs(values[i] - values[i - 1]) > std::abs(values[out.back()] - values[out.back() - 1])) out.back() = i;
    } else {
      out.push_back(i);
    }
  }
  return out;
}

struct SmoothColumn {
  std::vector<double> values{};
  double sigma{};
  std::vector<InputError> errors{};
};

std::optional<SmoothColumn> smoothed(const std::vector<double>& times, const std::vector<double>& values) {
  if (values.size() < fewest_samples_of_level) return std::nullopt;
  std::size_t alike = 0;
  for (std::size_t i = 1; i < values.size(); ++i) alike += values[i] == values[i - 1] ? 1 : 0;
  if (static_cast<double>(alike) > most_alike * static_cast<double>(values.size())) return std::nullopt;
  data::Run record;
  record.kind = data::RunKind::transient;
  record.times = times;
  record.channels = {{.name = "input", .kind = data::ChannelKind::torque, .values = values}};
  const signals::NoiseLevel level = signals::noise_of(record, record.channels.front());
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (level.sigma < least_share * (*most - *least)) return std::nullopt;
  const ReadingNoise noise{.sigma = level.sigma, .freedom = level.freedom};
  std::vector<std::size_t> starts{0};
  // A fast sine is as steep as an edge: it is one command, and no pieces.
  if (!command_shape(times, values, noise))
    for (const std::size_t edge : edges_of(values, least_edge(values, level.sigma))) starts.push_back(edge);
  starts.push_back(values.size());
  std::vector<signals::SampledSegment> segments;
  for (std::size_t s = 0; s + 1 < starts.size(); ++s)
    segments.push_back({.times = std::span(times).subspan(starts[s], starts[s + 1] - starts[s]),
                        .values = std::span(values).subspan(starts[s], starts[s + 1] - starts[s])});
  const double penalty = signals::best_penalty(segments, level.sigma);
  SmoothColumn out{.sigma = level.sigma};
  for (const signals::SampledSegment& segment : segments) {
    if (const auto shape = command_shape(segment.times, segment.values, noise)) {
      for (Eigen::Index k = 0; k < shape->basis.cols(); ++k) {
        InputError error{.first = out.values.size()};
        for (const double value : shape->basis.col(k)) error.shape.push_back(level.sigma * value);
        out.errors.push_back(std::move(error));
      }
      out.values.insert(out.values.end(), shape->values.begin(), shape->values.end());
      continue;
    }
    constexpr std::size_t fewest_for_third_differences = 4;
    if (segment.values.size() < fewest_for_third_differences) {
      out.values.insert(out.values.end(), segment.values.begin(), segment.values.end());
      continue;
    }
    const std::vector<double> smooth = signals::smoothed(segment.times, segment.values, penalty);
    out.values.insert(out.values.end(), smooth.begin(), smooth.end());
  }
  return out;
}

}  // namespace

std::optional<CleanInput> without_noise(const data::Run& run) {
  if (run.inputs.empty() || run.times_of_inputs().size() != run.inputs.size()) return std::nullopt;
  CleanInput out{.rows = run.inputs};
  for (std::size_t column = 0; column < run.inputs.front().size(); ++column) {
    std::vector<double> values;
    for (const std::vector<double>& row : run.inputs) values.push_back(row[column]);
    auto smooth = smoothed(run.times_of_inputs(), values);
    if (!smooth) continue;
    out.sigma = std::max(out.sigma, smooth->sigma);
    for (InputError& error : smooth->errors) {
      error.column = column;
      out.errors.push_back(std::move(error));
    }
    for (std::size_t i = 0; i < values.size(); ++i) out.rows[i][column] = smooth->values[i];
  }
  if (out.sigma == 0.0) return std::nullopt;
  return out;
}

}  // namespace coilwright::measurement::replay
