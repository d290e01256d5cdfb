#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/problem/options.hpp"
#include "coilwright/sizing/problem/problem.hpp"
#include "coilwright/sizing/study/scatter.hpp"

namespace coilwright::sizing {

/// Values between two bounds, in the unit of the variable's name; with a step, only those of its grid.
struct Interval {
  double lower{};
  double upper{};
  double step{};  ///< 0: every value, or every whole number
};

/// Values of a list, ascending, in the unit of the variable's name; for a parameter that is a choice their indices in
/// any order.
struct Choice {
  std::vector<double> values;
};

/// A number of the design that varies.
struct ParameterVariable {
  const actuator::Parameter* parameter{};  ///< never nullptr
  std::variant<Interval, Choice> range;
};

/// The current in every coil, if it varies.
struct CurrentVariable {
  std::variant<Interval, Choice> range;  ///< A
};

/// A row of coils and magnets, and its name in files: "C", "coil -magnet coil".
struct NamedLayout {
  std::string name;
  actuator::Layout layout;
};

/// The row of coils and magnets, if it varies.
struct LayoutVariable {
  std::string name = "layout";  ///< "configuration", "layout" or "polarity", by the kind of its values
  std::vector<NamedLayout> values;
};

/// A variable "configuration" with these values.
[[nodiscard]] LayoutVariable configuration_variable(std::vector<actuator::Configuration> values);

/// A number outside the design, if it varies: a setting of the system that the study's quantities build from the
/// actuator.
struct SettingVariable {
  std::string name;  ///< as in simulation::Settings, which has its values; ends with its unit
  double base{};     ///< value at which the search begins, in the unit of the name
  std::variant<Interval, Choice> range;
};
using StudyVariable = std::variant<ParameterVariable, CurrentVariable, LayoutVariable, SettingVariable>;

/// A variable that moves one of actuator::parameters(). Throws std::invalid_argument if no parameter has that name, and
/// for an interval for a parameter that is a choice.
[[nodiscard]] ParameterVariable parameter_variable(std::string_view name, std::variant<Interval, Choice> range);

/// The name of a variable as files write it: "gap_mm", "current_A", "configuration".
[[nodiscard]] std::string name_of(const StudyVariable& variable);

/// The variable of the search, in the unit of its name; for lists and layouts it is the index of the value.
[[nodiscard]] Variable search_variable(const StudyVariable& variable);

/// Number of values of a variable; empty for a continuous one.
[[nodiscard]] std::optional<std::size_t> value_count(const StudyVariable& variable);

/// A value of a variable as files write it: a number, the name of a layout, or one of a parameter's names.
using VariableValue = std::variant<double, std::string_view>;

/// The value of a variable at a coordinate of the search.
[[nodiscard]] VariableValue value_at(const StudyVariable& variable, double coordinate);

/// The coordinate of the search at which a variable has that value, bit by bit; absent if it never has it.
[[nodiscard]] std::optional<double> coordinate_of(const StudyVariable& variable, const VariableValue& value);

/// The coordinate of a number in a range: the number itself or, in a list, the index of the nearest.
[[nodiscard]] double coordinate_near(double value, const std::variant<Interval, Choice>& range);

/// The coordinate of the search at which a variable has that value or, for a number, the nearest one. Absent for a word
/// that the variable does not have, and if one of the two is a word and the other a number.
[[nodiscard]] std::optional<double> nearest_coordinate(const StudyVariable& variable, const VariableValue& value);

/// The argument of Parameter::set at a coordinate of the search: a number in the unit of the variable's name, or the
/// index of a word.
[[nodiscard]] double number_at(const ParameterVariable& variable, double coordinate);

/// A quantity to make small or large.
struct StudyObjective {
  simulation::ResultQuantity quantity;  ///< of the study's table or the program's own
  Sense sense = Sense::maximise;
  std::optional<simulation::ResultQuantity> of_build{};  ///< the quantity of one build behind a statistic
};

/// A quantity that must not pass a limit, in the unit of its name.
struct Limit {
  /// The side of the limit on which the quantity must stay.
  enum class Side { at_most, at_least };
  simulation::ResultQuantity quantity;
  Side side = Side::at_most;
  double value{};
  std::optional<simulation::ResultQuantity> of_build{};  ///< as for an objective
};

/// The quantity of one build to which an objective or a limit refers.
template <class Wanted>
[[nodiscard]] const simulation::ResultQuantity& of_one_build(const Wanted& wanted) {
  return wanted.of_build ? *wanted.of_build : wanted.quantity;
}

/// "mass_g <= 70".
[[nodiscard]] std::string name_of(const Limit& limit);

/// Distance of a value from its limit, in the unit of the quantity; negative if it breaks the limit.
[[nodiscard]] double margin(const Limit& limit, double value);

/// The scale of a limit, by which margins of different limits are divided to compare them: the magnitude of the limit
/// or, for a limit of 0, the scale of its quantity. In the unit of the quantity, > 0.
[[nodiscard]] double scale_of(const Limit& limit);

/// The current is a variable of the study.
struct VariedCurrent {};

/// The current is the same in every design.
struct FixedCurrent {
  double current{};  ///< A
};

/// The current is a share of the chassis ampacity of the design's wire.
struct ShareOfLimit {
  double share{};  ///< > 0
};

/// The question of a search: the numbers of a design that vary, its objectives and its limits.
struct Study {
  std::string name;
  actuator::Design base;  ///< actuator with its calibration; variables are set on a copy of it
  std::variant<VariedCurrent, FixedCurrent, ShareOfLimit, DrivenCurrent> current;
  /// The drive and the use of the designs. `current` decides the current, and the duty if that is driven. `cases` are
  /// as stated; poses_of_use() gives those that the study asks for.
  actuator::OperatingPoint operating{};
  std::vector<StudyVariable> variables;
  std::vector<StudyObjective> objectives;
  std::vector<Limit> limits;
  SearchOptions search;
  /// Designs that a search evaluates right after the study's own actuator, each a coordinate for each variable.
  std::vector<std::vector<double>> starts{};
  /// The scatter between builds, if the study states one; its statistics are among the quantities.
  std::optional<Spread> spread{};
  /// The pulsed supply, if the study states one. A design whose current it cannot give has no performance.
  std::optional<StudyDriver> driver{};
  /// All quantities that results list. Each is computed for every design.
  simulation::QuantityTable quantities = simulation::standard_quantities();
};

/// The poses to which a study's objectives and limits belong, and in which it is therefore held: that of the free
/// finger alone for a study that asks for a speed and no grasp force. Both poses if none of its quantities has one.
[[nodiscard]] actuator::HeldCases poses_of_use(const Study& study);

}  // namespace coilwright::sizing
