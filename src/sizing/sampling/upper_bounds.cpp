#include "sizing/sampling/upper_bounds.hpp"

#include <algorithm>
#include <limits>

namespace coilwright::sizing {
namespace {

bool strictly_below(const Objectives& a, const Objectives& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] >= b[i]) return false;
  }
  return true;
}

bool not_above(const Objectives& a, const Objectives& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] > b[i]) return false;
  }
  return true;
}

}  // namespace

UpperBounds::UpperBounds(std::size_t objectives)
    : bounds_{{.corner = Objectives(objectives, std::numeric_limits<double>::infinity()),
               .definers = std::vector<std::size_t>(objectives, UpperBound::none)}} {}

bool UpperBounds::add(const Objectives& point, std::size_t index) {
  const auto cut = std::stable_partition(bounds_.begin(), bounds_.end(),
                                         [&](const UpperBound& bound) { return !strictly_below(point, bound.corner); });
  if (cut == bounds_.end()) return false;
  const std::vector<UpperBound> parents(cut, bounds_.end());
  bounds_.erase(cut, bounds_.end());
  std::vector<UpperBound> children;
  for (const UpperBound& parent : parents) {
    for (std::size_t i = 0; i < point.size(); ++i) {
      UpperBound child = parent;
      child.corner[i] = point[i];
      child.definers[i] = index;
      child.failures = 0;
      children.push_back(std::move(child));
    }
  }
  // Keep the maximal corners only; of equal ones the first. The old bounds are maximal already, and no child can cover
  // one of them: it lies below its own parent.
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const Objectives& corner = children[i].corner;
    bool redundant =
        std::ranges::any_of(bounds_, [&](const UpperBound& bound) { return not_above(corner, bound.corner); });
    for (std::size_t k = 0; k < children.size() && !redundant; ++k) {
      if (k == i || !not_above(corner, children[k].corner)) continue;
      redundant = k < i || corner != children[k].corner;
    }
    if (!redundant) kept.push_back(i);
  }
  for (const std::size_t i : kept) bounds_.push_back(std::move(children[i]));
  return true;
}

}  // namespace coilwright::sizing
