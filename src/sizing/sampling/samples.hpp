#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"
#include "sizing/problem/design_space.hpp"
#include "sizing/problem/point_hash.hpp"
#include "sizing/sampling/upper_bounds.hpp"

namespace coilwright::sizing {

/// One evaluated design in the coordinates of the search.
struct Sample {
  std::vector<double> point;        ///< variables, as they were evaluated
  std::vector<double> unit;         ///< coordinates in the unit cube
  std::uint64_t combination{};      ///< of categorical levels
  bool evaluated{};                 ///< false if the design could not be evaluated
  Objectives values;                ///< all minimised; empty if not evaluated
  std::vector<double> constraints;  ///< values minus limits; empty if not evaluated
  double violation{};               ///< sum of the positive constraints; if not evaluated, the infeasibility
  [[nodiscard]] bool feasible() const { return evaluated && violation == 0; }
};

/// Largest absolute difference of two points in a coordinate (Chebyshev distance).
[[nodiscard]] double largest_difference(std::span<const double> a, std::span<const double> b);

/// All designs that a search knows, in the order in which it learnt them, which does not depend on the number of
/// threads.
class Samples {
 public:
  /// `limits` is what each constraint may reach: 0, unless it is relaxed. `archive`, which must outlive it, tells of
  /// designs that the problem excludes; without one none is.
  Samples(const Problem& problem, std::vector<double> limits, const Archive* archive = nullptr);

  /// All that `all` knows, with the objective of this index alone: an end of its front is the best design here.
  Samples(const Samples& all, std::size_t objective);

  /// Learns one design. Returns its gain for the front: the largest product of its normalised distances below a former
  /// upper bound, which is the gained hypervolume where that is one box; 0 if it is known, infeasible or dominated.
  double add(const Record& record);

  /// A record in the coordinates of the search, whether it is known or not.
  [[nodiscard]] Sample as_sample(const Record& record) const;

  [[nodiscard]] const DesignSpace& space() const { return space_; }
  [[nodiscard]] const Sample& operator[](std::size_t index) const { return samples_[index]; }
  [[nodiscard]] std::size_t size() const { return samples_.size(); }
  [[nodiscard]] std::size_t feasible_count() const { return feasible_count_; }
  /// Indices of the feasible, non-dominated samples, in the order in which they were learnt.
  [[nodiscard]] const std::vector<std::size_t>& front() const { return front_; }
  [[nodiscard]] UpperBounds& bounds() { return bounds_; }
  [[nodiscard]] const UpperBounds& bounds() const { return bounds_; }
  /// Best and worst of each objective on the front; the range is never 0.
  [[nodiscard]] const FrontFrame& frame() const { return frame_; }
  [[nodiscard]] std::size_t objective_count() const { return objective_count_; }
  [[nodiscard]] std::size_t constraint_count() const { return limits_.size(); }

  /// How far objectives lie behind the front: the least, over the designs of the front, of the largest difference of an
  /// objective, relative to the front's range; negative in front of it.
  [[nodiscard]] double excess(const Objectives& values) const;

  /// Whether the design at legal unit coordinates is known.
  [[nodiscard]] bool knows(std::span<const double> unit, std::uint64_t combination) const;

  /// Whether the problem excludes the design at legal unit coordinates before it is evaluated.
  [[nodiscard]] bool excludes(std::span<const double> unit, std::uint64_t combination) const;

  /// Whether there is a reason not to evaluate it: it is known or, once a design is known that is not excluded, it is
  /// excluded. Until then an excluded design teaches where the others are.
  [[nodiscard]] bool rules_out(std::span<const double> unit, std::uint64_t combination) const;

  /// Which samples to select.
  enum class Wanted { evaluated, failed };
  /// Samples around the segment from `a` to `b`.
  struct Neighbourhood {
    std::uint64_t combination{};                 ///< only samples of this combination of levels
    std::span<const double> a, b;                ///< unit coordinates
    std::size_t count{};                         ///< largest number of samples
    double spacing{};                            ///< smallest `largest_difference` between two samples; 0: any
    std::vector<double> weights{};               ///< of squared distances along each axis; empty: all 1
    std::optional<std::size_t> weighted_axis{};  ///< distances from `a` along this axis count three times
  };
  /// The samples nearest to a segment, nearest first; of equal distances the one of lower index.
  [[nodiscard]] std::vector<std::size_t> nearest(const Neighbourhood& where, Wanted wanted) const;

 private:
  double add(Sample sample);
  void update_front(std::size_t added);

  Problem problem_;
  const Archive* archive_{};
  bool excluding_ = false;             // a design is known that is not excluded
  std::optional<std::size_t> only_{};  // objective; empty: all of the problem
  std::vector<double> limits_;
  std::size_t objective_count_;
  DesignSpace space_;
  std::vector<Sample> samples_;
  std::vector<std::size_t> front_;
  std::size_t feasible_count_ = 0;
  UpperBounds bounds_;
  FrontFrame frame_;
  std::unordered_set<std::vector<double>, PointHash> known_;
};

}  // namespace coilwright::sizing
