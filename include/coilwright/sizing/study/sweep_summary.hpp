#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/sizing/study/exact_sum.hpp"
#include "coilwright/sizing/study/leaders.hpp"
#include "coilwright/sizing/study/sweep.hpp"

namespace coilwright::sizing {

/// The designs of a sweep that are kept as rows. For the others there are counts, the best of each configuration and
/// statistics of each quantity.
enum class Keep {
  all,
  feasible,  ///< designs that keep every limit
  front,     ///< designs that no other one beats in every objective, among the feasible ones
  best       ///< only the best of each configuration
};

/// The word of each in options and results.
inline constexpr std::array<std::pair<std::string_view, Keep>, 4> keep_words = {
    {{"all", Keep::all}, {"feasible", Keep::feasible}, {"front", Keep::front}, {"best", Keep::best}}};
/// The word of a choice: "all", "feasible", "front", "best".
[[nodiscard]] std::string_view name_of(Keep keep);

/// Statistics of a quantity over the designs of a sweep that have a value of it, in its unit.
struct QuantityTotal {
  std::size_t designs{};  ///< number of designs with a value
  ExactSum sum{};         ///< of their values
  double least{};         ///< least value; 0 without a design, as is the next
  double greatest{};

  void add(double value);                ///< of one more design
  void add(const QuantityTotal& other);  ///< adds the values of other designs
};

/// Counts of a sweep, or of a part of one.
struct SweepTotals {
  std::size_t designs{};                    ///< evaluated
  std::size_t ok{};                         ///< evaluated designs that keep every limit
  std::vector<QuantityTotal> quantities{};  ///< in the order of the study's table; empty if all rows are kept
};

/// The summary of a sweep, which takes in its designs one by one in their order. Its memory holds the best of each
/// configuration and, with Keep::front, the front. Summaries of parts of a sweep, taken in in the order of the parts,
/// give the bits of the whole.
class SweepSummary {
 public:
  /// Starts without a design and copies the problem.
  SweepSummary(const DesignProblem& problem, Keep keep);

  /// Considers the next design.
  void consider(const SweptDesign& design);
  /// Considers a part of the sweep: its totals, and the designs of its kept().
  void consider(const SweepTotals& totals, std::span<const SweptDesign> kept);

  /// Whether a design is one of the rows when it arrives; with Keep::front that is known only at the end.
  [[nodiscard]] bool is_row(const SweptDesign& design) const;

  [[nodiscard]] const SweepTotals& totals() const noexcept { return totals_; }
  [[nodiscard]] const Leaders& leaders() const noexcept { return leaders_; }
  /// The front so far, by index; of equal designs the first one. Empty unless Keep::front.
  [[nodiscard]] const std::vector<SweptDesign>& front() const noexcept { return front_; }
  /// Leaders and front, each design once, by index: all designs of a part that consider() needs.
  [[nodiscard]] std::vector<SweptDesign> kept() const;

 private:
  void keep(const SweptDesign& design);

  DesignProblem problem_;
  Problem searched_;
  Keep keep_;
  SweepTotals totals_;
  Leaders leaders_;
  std::vector<SweptDesign> front_;
};

}  // namespace coilwright::sizing
