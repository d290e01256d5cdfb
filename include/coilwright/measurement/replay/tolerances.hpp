#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coilwright::measurement::replay {

/// The names of tolerances that are no JSON pointers: docs/formats-dataset.md, "Tolerances".
[[nodiscard]] std::vector<std::string_view> tolerance_names();

/// What a person says of the accuracy of one declared number.
struct NamedTolerance {
  /// A JSON pointer to a number of the actuator file, or one of tolerance_names().
  std::string name;
  double deviation{};  ///< one standard deviation, in the unit of the name; >= 0, and 0 for a number that is exact
};

/// What a person says of the accuracy of the declared numbers.
struct Tolerances {
  bool others_exact{};                  ///< whether numbers that are not named are exact; otherwise they have defaults
  std::vector<NamedTolerance> named{};  ///< each name once

  /// Every declared number is exact.
  [[nodiscard]] static Tolerances exact() { return {.others_exact = true}; }
};

/// A tolerance that the model cannot have. what() is the rule that it breaks: "must be > 0, because ...".
class ToleranceFault : public std::invalid_argument {
 public:
  /// Of the number `name`, whose `value` breaks `rule`.
  ToleranceFault(std::string name, const std::string& rule, std::string value = {})
      : std::invalid_argument(rule), name_(std::move(name)), value_(std::move(value)) {}
  /// Of the number, as in Tolerances::named.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// The deviation as it was given; empty where the name itself is at fault.
  [[nodiscard]] const std::string& value() const noexcept { return value_; }

 private:
  std::string name_;
  std::string value_;
};

}  // namespace coilwright::measurement::replay
