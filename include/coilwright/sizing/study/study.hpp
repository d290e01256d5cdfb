#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/design.hpp"
#include "coilwright/actuator/parameters.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/problem/options.hpp"
#include "coilwright/sizing/problem/problem.hpp"

namespace coilwright::sizing {

/// A number of the design between two bounds, in the unit of the parameter's name; with a step: on that grid only.
struct Interval {
  double lower{};
  double upper{};
  double step{};  ///< 0: continuous, or every whole number
};

/// A number of the design out of a list, ascending, in the unit of the parameter's name.
struct Choice {
  std::vector<double> values;
};

/// What varies.
struct ParameterVariable {
  const actuator::Parameter* parameter{};  ///< never nullptr
  std::variant<Interval, Choice> range;
};
struct CurrentVariable {
  std::variant<Interval, Choice> range;  ///< A
};
struct ConfigurationVariable {
  std::vector<actuator::Configuration> values;
};
using StudyVariable = std::variant<ParameterVariable, CurrentVariable, ConfigurationVariable>;

/// The name of a variable as files write it: "gap_mm", "current_A", "configuration".
[[nodiscard]] std::string name_of(const StudyVariable& variable);

/// The variable as a search moves it: in the unit of its name, or, for lists and configurations, the index of the
/// value.
[[nodiscard]] Variable search_variable(const StudyVariable& variable);

/// Number of values a variable has; nothing for a continuous one.
[[nodiscard]] std::optional<std::size_t> value_count(const StudyVariable& variable);

/// A value of a variable as files write it: a number, or the letter of a configuration.
using VariableValue = std::variant<double, std::string_view>;

/// The value behind a search's coordinate.
[[nodiscard]] VariableValue value_at(const StudyVariable& variable, double coordinate);

struct StudyObjective {
  simulation::ResultQuantity quantity;  ///< of the study's table or the program's own
  Sense sense = Sense::maximise;
};

/// A quantity that must not pass a limit, in the unit of its name.
struct Limit {
  enum class Side { at_most, at_least };
  simulation::ResultQuantity quantity;
  Side side = Side::at_most;
  double value{};
};

/// "mass_g <= 70".
[[nodiscard]] std::string name_of(const Limit& limit);

/// How far inside its limit a value lies, in the unit of the quantity: negative outside.
[[nodiscard]] double margin(const Limit& limit, double value);

/// What a margin is divided by where limits are compared with each other: the magnitude of the limit or, for a limit of
/// 0, the scale of its quantity. In the unit of the quantity, > 0.
[[nodiscard]] double scale_of(const Limit& limit);

/// How the current of a design is set.
struct VariedCurrent {};  ///< a variable sets it
struct FixedCurrent {
  double current{};  ///< A
};
struct ShareOfLimit {
  double share{};  ///< of the gauge's chassis ampacity; > 0
};

/// A question about designs: what may vary, what is wanted, what is not allowed.
struct Study {
  std::string name;
  actuator::Design base;  ///< with its calibration; variables are set on a copy of it
  std::variant<VariedCurrent, FixedCurrent, ShareOfLimit> current;
  double duty = 1.0;
  std::vector<StudyVariable> variables;
  std::vector<StudyObjective> objectives;
  std::vector<Limit> limits;
  SearchOptions search;
  /// What results list of a design, beside objectives and limits.
  simulation::QuantityTable quantities = simulation::standard_quantities();
};

}  // namespace coilwright::sizing
