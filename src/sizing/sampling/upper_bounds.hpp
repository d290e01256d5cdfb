#pragma once

#include <cstddef>
#include <vector>

#include "coilwright/sizing/problem/front.hpp"

namespace coilwright::sizing {

/// A corner of the part of objective space that is not dominated yet: every point strictly below it is an improvement.
struct UpperBound {
  /// Marks a coordinate that no point of the front bounds.
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Objectives corner;                  ///< all objectives minimised; +infinity where unbounded
  std::vector<std::size_t> definers;  ///< index of the point that bounds each coordinate, or `none`
  int failures = 0;                   ///< number of subproblems below this corner that found nothing
};

/// The local upper bounds of a growing set of points: the maximal corners of the region the points do not dominate.
/// For any number of objectives, by redundancy elimination: Klamroth, Lacour, Vanderpooten, Eur. J. Oper. Res. 245
/// (2015) 767.
class UpperBounds {
 public:
  explicit UpperBounds(std::size_t objectives);

  /// Adds a point with an index for `definers`. Returns whether it lies strictly below a bound and so extends the
  /// dominated region.
  bool add(const Objectives& point, std::size_t index);

  [[nodiscard]] const std::vector<UpperBound>& all() const { return bounds_; }

  /// Counts a subproblem below the bound at `index` of `all()` that found nothing.
  void count_failure(std::size_t index) { ++bounds_[index].failures; }

 private:
  std::vector<UpperBound> bounds_;
};

}  // namespace coilwright::sizing
