#pragma once

#include <limits>
#include <string>

namespace coilwright::text {

/// The interval in which a number of an input file must lie, in the unit in which the file gives it.
class Rule {
 public:
  /// The rule "any finite number".
  [[nodiscard]] static constexpr Rule any() { return {unbounded_below, unbounded_above}; }
  /// The rule ">= lower".
  [[nodiscard]] static constexpr Rule at_least(double lower) { return {{lower, true}, unbounded_above}; }
  /// The rule "> lower".
  [[nodiscard]] static constexpr Rule above(double lower) { return {{lower, false}, unbounded_above}; }
  /// <= upper.
  [[nodiscard]] static constexpr Rule at_most(double upper) { return {unbounded_below, {upper, true}}; }
  /// < upper.
  [[nodiscard]] static constexpr Rule below(double upper) { return {unbounded_below, {upper, false}}; }
  /// The rule that includes both ends.
  [[nodiscard]] static constexpr Rule between(double lower, double upper) { return {{lower, true}, {upper, true}}; }

  /// Both rules together: `Rule::above(0).and_also(Rule::at_most(1))`.
  [[nodiscard]] constexpr Rule and_also(const Rule& other) const {
    const bool other_lower =
        other.lower_.value > lower_.value || (other.lower_.value == lower_.value && !other.lower_.included);
    const bool other_upper =
        other.upper_.value < upper_.value || (other.upper_.value == upper_.value && !other.upper_.included);
    return {other_lower ? other.lower_ : lower_, other_upper ? other.upper_ : upper_};
  }

  /// Whether a value keeps the rule.
  [[nodiscard]] constexpr bool allows(double value) const {
    return (value > lower_.value || (lower_.included && value == lower_.value)) &&
           (value < upper_.value || (upper_.included && value == upper_.value));
  }

  /// The lower end; minus infinity if there is none.
  [[nodiscard]] constexpr double lower() const { return lower_.value; }
  /// The upper end; infinity if there is none.
  [[nodiscard]] constexpr double upper() const { return upper_.value; }

  /// The rule in words: "must be > 0", "must be from 2 to 5", "must be > 0 and <= 1", "must be finite".
  [[nodiscard]] std::string text() const;

 private:
  struct End {
    double value;
    bool included;
  };
  static constexpr End unbounded_below{-std::numeric_limits<double>::infinity(), false};
  static constexpr End unbounded_above{std::numeric_limits<double>::infinity(), false};
  constexpr Rule(End lower, End upper) : lower_(lower), upper_(upper) {}

  End lower_;
  End upper_;
};

inline constexpr Rule finite = Rule::any();
inline constexpr Rule positive = Rule::above(0.0);
inline constexpr Rule non_negative = Rule::at_least(0.0);

}  // namespace coilwright::text
