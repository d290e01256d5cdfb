#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace coilwright::sizing {

/// A sum of doubles without rounding, which is therefore the same in any order and any division into parts. Immutable
/// inside; copies are cheap.
class ExactSum {
 public:
  ExactSum();  ///< 0
  /// Reads the sum from the output of text(). Throws std::invalid_argument for another text.
  explicit ExactSum(const std::string& text);

  void add(double value);           ///< finite
  void add(const ExactSum& other);  ///< adds all numbers of another sum

  /// The sum as a double, to within one unit of its last digit; infinite beyond the largest double.
  [[nodiscard]] double value() const;
  /// The sum in units of 2^-1074, a decimal integer.
  [[nodiscard]] std::string text() const;

 private:
  struct Integer;
  std::shared_ptr<const Integer> sum_;
};

}  // namespace coilwright::sizing
