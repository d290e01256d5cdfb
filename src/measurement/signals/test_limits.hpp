#pragma once

#include <algorithm>
#include <string>

namespace coilwright::measurement::signals {

/// Nominal probabilities with which white noise fails each kind of test, each divided among the tests of its kind
/// (Bonferroni). The tests of one kind overlap, so that fewer than one of two hundred sets fail in all.
namespace false_alarms {
inline constexpr double of_pooled_bands = 0.005;
inline constexpr double of_bands = 0.0015;
inline constexpr double of_pooled_lines = 0.001;
inline constexpr double of_lines = 0.001;
inline constexpr double of_blocks = 0.001;
}  // namespace false_alarms

/// A sum of squares of white noise over an estimated variance.
struct SumOfSquares {
  double count{};               ///< number of squares
  double degrees_of_freedom{};  ///< of the estimated variance; infinite if it is known
  double allowed_energy{};      ///< mean energy of structure that may be there in addition
};

/// The value that such a sum exceeds with the probability `chance` (Patnaik's approximation of the noncentral
/// distribution).
[[nodiscard]] double energy_limit(const SumOfSquares& sum, double chance);

/// Several such sums added: their distribution is taken as the gamma distribution of the same mean and variance.
class PooledEnergy {
 public:
  void add(double energy, const SumOfSquares& sum);
  [[nodiscard]] double energy() const { return energy_; }
  [[nodiscard]] double expected() const { return count_; }
  /// The value that white noise exceeds with the probability `chance`.
  [[nodiscard]] double limit(double chance) const;

 private:
  double energy_{}, count_{}, allowed_{}, mean_{}, variance_{};
};

/// Keeps the test with the largest excess over its expectation, relative to the excess that is allowed.
class WorstTest {
 public:
  /// `where` returns the text that names the test; it is called only if the test is the worst so far.
  template <typename Where>
  void consider(double energy, double expected, double limit, Where&& where) {
    const double excess = (energy - expected) / (limit - expected);
    if (excess <= ratio_ && !where_.empty()) return;
    ratio_ = std::max(excess, 0.0);
    where_ = where();
  }
  [[nodiscard]] double ratio() const { return ratio_; }
  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  double ratio_{};
  std::string where_;
};

}  // namespace coilwright::measurement::signals
