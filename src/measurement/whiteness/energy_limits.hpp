#pragma once

namespace coilwright::measurement::whiteness {

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

}  // namespace coilwright::measurement::whiteness
