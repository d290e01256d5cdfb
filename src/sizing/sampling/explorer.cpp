#include "sizing/sampling/explorer.hpp"

#include <cmath>
#include <utility>

#include "sizing/sampling/random.hpp"

namespace coilwright::sizing {
namespace {

// Attempts in a row that meet known designs, after which a call gives up.
constexpr int max_attempts = 64;
// Designs in a row that the problem excludes, after which one of them is proposed: enough to meet a two hundredth of
// the space.
constexpr int max_exclusions = 1024;

}  // namespace

Explorer::Explorer(const DesignSpace& space, std::uint64_t seed)
    : space_{space}, random_{seed}, probes_(space.dimension(), 2), promising_probes_(space.dimension(), 1) {
  if (space.dimension() == 0) return;
  sobol_.emplace(space.dimension());
  for (std::size_t axis = 0; axis < space.dimension(); ++axis) shift_.push_back(uniform(random_));
}

std::uint64_t Explorer::below(std::uint64_t count) {
  return random_() % count;
}

std::optional<UnitPoint> Explorer::sobol_point(const Samples& samples) {
  std::optional<UnitPoint> excluded;
  int known = 0;
  for (int attempt = 0; attempt < max_exclusions && known < max_attempts; ++attempt) {
    std::vector<double> unit(space_.dimension());
    for (std::size_t axis = 0; axis < unit.size(); ++axis) {
      const double shifted = static_cast<double>((*sobol_)()) * 0x1p-64 + shift_[axis];
      const double value = shifted - std::floor(shifted);
      // Every grid value gets an equal share of [0, 1), also the first and the last.
      const double spacing = space_.spacing(axis);
      unit[axis] = spacing > 0 ? std::floor(value * (std::round(space_.ceiling(axis) / spacing) + 1)) * spacing : value;
    }
    unit = space_.snapped(unit);
    const std::uint64_t combination = sobol_points_++ % space_.combinations();
    if (samples.knows(unit, combination)) {
      ++known;
      continue;
    }
    const bool usable = !samples.excludes(unit, combination);
    UnitPoint point{.unit = std::move(unit), .combination = combination};
    if (usable) return point;
    if (!excluded) excluded = std::move(point);
  }
  return excluded;
}

UnitPoint Explorer::recombined(const Samples& samples, const std::vector<std::size_t>& parents) {
  const Sample& base = samples[parents[below(parents.size())]];
  UnitPoint child{.unit = base.unit, .combination = base.combination};
  if (space_.combinations() > 1 && uniform(random_) < 0.3) {
    child.combination = below(space_.combinations());
    if (child.combination != base.combination) return child;
  }
  const std::size_t n = space_.dimension();
  if (n == 0) return child;
  if (space_.has_grid() && uniform(random_) < 0.4) {
    const std::size_t axis = below(n);
    const double spacing = space_.spacing(axis) > 0 ? space_.spacing(axis) : 0.02;
    const double steps = static_cast<double>(1 + below(3));
    child.unit[axis] += (below(2) == 0 ? -steps : steps) * spacing;
    child.unit = space_.snapped(child.unit);
    return child;
  }
  const Sample& plus = samples[parents[below(parents.size())]];
  const Sample& minus = samples[parents[below(parents.size())]];
  const double scale = 0.4 + 0.6 * uniform(random_);
  const std::size_t always = below(n);
  for (std::size_t axis = 0; axis < n; ++axis) {
    if (axis != always && uniform(random_) < 0.5) continue;
    // The jitter moves children also along an axis in which all parents agree.
    const double jitter = 0.02 * (uniform(random_) - 0.5) + (uniform(random_) < 0.05 ? uniform(random_) - 0.5 : 0.0);
    child.unit[axis] += scale * (plus.unit[axis] - minus.unit[axis]) + jitter;
  }
  child.unit = space_.snapped(child.unit);
  return child;
}

std::size_t Explorer::drawn_axis() {
  double sum = 0;
  for (std::size_t axis = 0; axis < probes_.size(); ++axis) sum += promising_probes_[axis] / probes_[axis];
  double drawn = uniform(random_) * sum;
  for (std::size_t axis = 0; axis < probes_.size(); ++axis) {
    drawn -= promising_probes_[axis] / probes_[axis];
    if (drawn < 0) return axis;
  }
  return probes_.size() - 1;
}

std::optional<Explorer::Probe> Explorer::probe(const Samples& samples, const std::vector<std::size_t>& parents) {
  for (int attempt = 0; attempt < max_attempts && !parents.empty() && space_.dimension() > 0; ++attempt) {
    const Sample& base = samples[parents[below(parents.size())]];
    Probe made{.point = {.unit = base.unit, .combination = base.combination}, .axis = drawn_axis()};
    made.point.unit[made.axis] = uniform(random_);
    made.point.unit = space_.snapped(made.point.unit);
    if (!samples.rules_out(made.point.unit, made.point.combination)) return made;
  }
  return std::nullopt;
}

void Explorer::count_probe(std::size_t axis, bool promising) {
  probes_[axis] += 1;
  promising_probes_[axis] += promising ? 1 : 0;
}

std::optional<UnitPoint> Explorer::evolved_point(const Samples& samples, const std::vector<std::size_t>& parents) {
  for (int attempt = 0; attempt < max_attempts && !parents.empty(); ++attempt) {
    UnitPoint child = recombined(samples, parents);
    if (!samples.rules_out(child.unit, child.combination)) return child;
  }
  return std::nullopt;
}

std::optional<UnitPoint> Explorer::next_of_grid(const Samples& samples) {
  for (; grid_points_ < space_.design_count(); ++grid_points_) {
    std::uint64_t rest = grid_points_;
    UnitPoint next{.unit = std::vector<double>(space_.dimension()), .combination = rest % space_.combinations()};
    rest /= space_.combinations();
    for (std::size_t axis = 0; axis < next.unit.size(); ++axis) {
      const auto levels = static_cast<std::uint64_t>(std::llround(space_.ceiling(axis) / space_.spacing(axis))) + 1;
      next.unit[axis] = static_cast<double>(rest % levels) * space_.spacing(axis);
      rest /= levels;
    }
    next.unit = space_.snapped(next.unit);
    if (samples.rules_out(next.unit, next.combination)) continue;
    ++grid_points_;
    return next;
  }
  return std::nullopt;
}

}  // namespace coilwright::sizing
