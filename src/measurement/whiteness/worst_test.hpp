#pragma once

#include <algorithm>
#include <string>

namespace coilwright::measurement::whiteness {

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

}  // namespace coilwright::measurement::whiteness
