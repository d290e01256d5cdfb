#include "sizing/sampling/samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coilwright::sizing {
namespace {

double squared_distance_to_segment(std::span<const double> point, std::span<const double> a, std::span<const double> b,
                                   const std::vector<double>& weights) {
  const auto w = [&](std::size_t i) { return weights.empty() ? 1.0 : weights[i]; };
  double along = 0, length = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    along += w(i) * (point[i] - a[i]) * (b[i] - a[i]);
    length += w(i) * (b[i] - a[i]) * (b[i] - a[i]);
  }
  const double fraction = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  double sum = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const double difference = point[i] - a[i] - fraction * (b[i] - a[i]);
    sum += w(i) * difference * difference;
  }
  return sum;
}

}  // namespace

double largest_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

Samples::Samples(const Problem& problem, std::vector<double> limits, const Archive* archive)
    : problem_{problem},
      archive_{archive},
      limits_{std::move(limits)},
      objective_count_{problem.objectives.size()},
      space_{problem.variables},
      bounds_{objective_count_} {}

Samples::Samples(const Samples& all, std::size_t objective)
    : problem_{all.problem_},
      archive_{all.archive_},
      only_{objective},
      limits_{all.limits_},
      objective_count_{1},
      space_{all.problem_.variables},
      bounds_{1} {
  for (Sample sample : all.samples_) {
    if (sample.evaluated) sample.values = {sample.values[objective]};
    add(std::move(sample));
  }
}

bool Samples::knows(std::span<const double> unit, std::uint64_t combination) const {
  return known_.contains(space_.point(unit, combination));
}

bool Samples::excludes(std::span<const double> unit, std::uint64_t combination) const {
  return archive_ != nullptr && archive_->excludes(space_.point(unit, combination));
}

bool Samples::rules_out(std::span<const double> unit, std::uint64_t combination) const {
  return knows(unit, combination) || (excluding_ && excludes(unit, combination));
}

Sample Samples::as_sample(const Record& record) const {
  const Evaluation& evaluation = record.evaluation;
  Sample sample{.point = record.point,
                .unit = space_.unit(record.point),
                .combination = space_.combination(record.point),
                .evaluated = evaluation.failure.empty(),
                .values = minimised(problem_, evaluation),
                .constraints = evaluation.constraints,
                .violation = evaluation.infeasibility};
  for (std::size_t i = 0; i < sample.constraints.size(); ++i) {
    sample.constraints[i] -= limits_[i];
    sample.violation += std::max(sample.constraints[i], 0.0);
  }
  if (only_ && sample.evaluated) sample.values = {sample.values[*only_]};
  return sample;
}

double Samples::add(const Record& record) {
  return add(as_sample(record));
}

double Samples::add(Sample sample) {
  if (!known_.insert(sample.point).second) return 0;
  excluding_ = excluding_ || (archive_ != nullptr && sample.evaluated && !archive_->excludes(sample.point));
  samples_.push_back(std::move(sample));
  if (!samples_.back().feasible()) return 0;
  ++feasible_count_;
  const Objectives& values = samples_.back().values;
  double gain = 0;
  for (const UpperBound& bound : bounds_.all()) {
    double product = 1;
    for (std::size_t i = 0; i < values.size() && product > 0; ++i) {
      const double range = front_.empty() ? 1.0 : frame_.nadir[i] - frame_.ideal[i];
      const double reference = front_.empty() ? values[i] + 1.0 : frame_.nadir[i] + 0.1 * range;
      product *= std::max(0.0, (std::min(bound.corner[i], reference) - values[i]) / range);
    }
    gain = std::max(gain, product);
  }
  if (bounds_.add(values, samples_.size() - 1)) update_front(samples_.size() - 1);
  return gain;
}

void Samples::update_front(std::size_t added) {
  std::erase_if(front_, [&](std::size_t i) { return dominates(samples_[added].values, samples_[i].values); });
  front_.push_back(added);
  frame_ = {.ideal = samples_[added].values, .nadir = samples_[added].values};
  for (const std::size_t i : front_) {
    for (std::size_t k = 0; k < objective_count_; ++k) {
      frame_.ideal[k] = std::min(frame_.ideal[k], samples_[i].values[k]);
      frame_.nadir[k] = std::max(frame_.nadir[k], samples_[i].values[k]);
    }
  }
  for (std::size_t k = 0; k < objective_count_; ++k) {
    if (frame_.nadir[k] <= frame_.ideal[k])
      frame_.nadir[k] = frame_.ideal[k] + std::max(1e-9, 1e-3 * std::abs(frame_.ideal[k]));
  }
}

double Samples::excess(const Objectives& values) const {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t index : front_) {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double range = frame_.nadir[k] - frame_.ideal[k];
      largest = std::max(largest, (values[k] - samples_[index].values[k]) / range);
    }
    least = std::min(least, largest);
  }
  return least;
}

std::vector<std::size_t> Samples::nearest(const Neighbourhood& where, Wanted wanted) const {
  std::vector<std::pair<double, std::size_t>> found;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    if (sample.combination != where.combination || sample.evaluated != (wanted == Wanted::evaluated)) continue;
    double distance = squared_distance_to_segment(sample.unit, where.a, where.b, where.weights);
    if (where.weighted_axis)
      distance += 8 * std::pow(sample.unit[*where.weighted_axis] - where.a[*where.weighted_axis], 2);
    found.emplace_back(distance, i);
  }
  std::vector<std::size_t> result;
  if (where.spacing == 0) {
    const std::size_t kept = std::min(where.count, found.size());
    std::ranges::partial_sort(found, found.begin() + static_cast<std::ptrdiff_t>(kept));
    for (std::size_t i = 0; i < kept; ++i) result.push_back(found[i].second);
    return result;
  }
  std::ranges::sort(found);
  for (const auto& entry : found) {
    if (result.size() == where.count) break;
    const std::size_t i = entry.second;
    const bool close = std::ranges::any_of(
        result, [&](std::size_t k) { return largest_difference(samples_[k].unit, samples_[i].unit) < where.spacing; });
    if (!close) result.push_back(i);
  }
  return result;
}

}  // namespace coilwright::sizing
