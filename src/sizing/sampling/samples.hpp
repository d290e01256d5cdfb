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

/// One evaluated design as the search sees it.
struct Sample {
  std::vector<double> point;        ///< as it was evaluated
  std::vector<double> unit;         ///< coordinates in the unit cube
  std::uint64_t combination{};      ///< of categorical levels
  bool evaluated{};                 ///< false: failed
  Objectives values;                ///< minimised; empty if failed
  std::vector<double> constraints;  ///< value minus limit; empty if failed
  double violation{};               ///< sum of positive constraints, or infeasibility
  [[nodiscard]] bool feasible() const { return evaluated && violation == 0; }
};

/// Largest difference of a coordinate.
[[nodiscard]] double largest_difference(std::span<const double> a, std::span<const double> b);

/// Everything a search knows, in the order it learnt it (the same on any number of threads).
class Samples {
 public:
  /// `limits`: what each constraint may reach; 0 unless one is relaxed.
  Samples(const Problem& problem, std::vector<double> limits);

  /// Learns one design. Returns how much it improved on the front: the largest product of normalised distances below a
  /// former upper bound (the hypervolume gained, where that is one box); 0 if nothing.
  double add(const Record& record);

  /// A record in the search's terms, learnt or not.
  [[nodiscard]] Sample as_sample(const Record& record) const;

  [[nodiscard]] const DesignSpace& space() const { return space_; }
  [[nodiscard]] const Sample& operator[](std::size_t index) const { return samples_[index]; }
  [[nodiscard]] std::size_t size() const { return samples_.size(); }
  [[nodiscard]] std::size_t feasible_count() const { return feasible_count_; }
  /// Feasible, non-dominated samples, ascending.
  [[nodiscard]] const std::vector<std::size_t>& front() const { return front_; }
  [[nodiscard]] UpperBounds& bounds() { return bounds_; }
  [[nodiscard]] const UpperBounds& bounds() const { return bounds_; }
  /// Best and worst of each objective on the front; the range is never 0.
  [[nodiscard]] const FrontFrame& frame() const { return frame_; }
  [[nodiscard]] std::size_t objective_count() const { return objective_count_; }
  [[nodiscard]] std::size_t constraint_count() const { return limits_.size(); }

  /// Whether the design at legal unit coordinates is known.
  [[nodiscard]] bool knows(std::span<const double> unit, std::uint64_t combination) const;

  /// Which samples to look for.
  enum class Wanted { evaluated, failed };
  /// The surroundings of the segment from `a` to `b`.
  struct Neighbourhood {
    std::uint64_t combination{};
    std::span<const double> a, b;            ///< unit coordinates
    std::size_t count{};                     ///< samples at most
    double apart{};                          ///< none nearer than this to a nearer one, in the largest coordinate
    std::optional<std::size_t> stretched{};  ///< an axis in which distances count three times: level with `a` first
  };
  /// The samples of a combination nearest to a segment; nearest first, ties by index.
  [[nodiscard]] std::vector<std::size_t> nearest(const Neighbourhood& where, Wanted wanted) const;

 private:
  void update_front(std::size_t added);

  Problem problem_;
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
