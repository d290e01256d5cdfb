#pragma once

#include <cstddef>
#include <vector>

#include "coilwright/sizing/problem/front.hpp"

namespace coilwright::sizing {

/// A corner up to which objective space is not dominated yet: everything strictly below it would be an improvement.
struct UpperBound {
  /// Marks a coordinate no front point bounds.
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Objectives corner;                  ///< +infinity where unbounded
  std::vector<std::size_t> definers;  ///< per objective the index of the point that bounds it, or `none`
  int failures = 0;                   ///< attempts below this corner that found nothing
};

/// The local upper bounds of a growing set of points: the maximal corners of the region the points do not dominate.
/// Klamroth, Lacour, Vanderpooten, Eur. J. Oper. Res. 245 (2015) 767 (redundancy elimination), any number of
/// objectives.
class UpperBounds {
 public:
  explicit UpperBounds(std::size_t objectives);

  /// Adds a point, named by `index`. Returns true if it lies strictly below a bound, i.e. extends the dominated region.
  bool add(const Objectives& point, std::size_t index);

  [[nodiscard]] const std::vector<UpperBound>& all() const { return bounds_; }

  /// Counts an attempt below bound `which` of `all()` that found nothing.
  void count_failure(std::size_t which) { ++bounds_[which].failures; }

 private:
  std::vector<UpperBound> bounds_;
};

}  // namespace coilwright::sizing
