#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// The rule for values of a parameter in a file. A length is from shortest_length to longest_length, a share from -1 to
/// 1.
enum class ParameterRule { positive, length, not_negative, at_least_one, share, any };

/// One number of a Design as files write it. Reader, writer and the variables of a study share this table.
struct Parameter {
  std::string_view
      section;            ///< object of the actuator file: "coil", "body", "bottom_layer_silicone", "calibration" ...
  std::string_view key;   ///< key in that object, its unit (units::to_memory) at its end
  std::string_view name;  ///< name among all parameters, unit at its end: what a study's variable is called
  bool whole{};           ///< a whole number, or the index of a name
  ParameterRule rule{};
  double (*get)(const Design&) = nullptr;                      ///< SI
  void (*set)(Design&, double) = nullptr;                      ///< SI
  std::span<const std::string_view> (*name_list)() = nullptr;  ///< see names(); nullptr for a number
  /// Whether the file has to state the parameter for this design (a share of the current, one of several numbers for
  /// the wire). nullptr: always.
  bool (*needed)(const Design&) = nullptr;
  /// The thing for which this parameter is one of several names, such as "the wire". A file gives one name of each
  /// thing in a section. Empty: none.
  std::string_view one_name_of{};

  /// The words that files write for a parameter that is a choice, by value. Empty for a number.
  [[nodiscard]] std::span<const std::string_view> names() const {
    return name_list == nullptr ? std::span<const std::string_view>() : name_list();
  }
};

/// Every number of a Design, section by section.
[[nodiscard]] std::span<const Parameter> parameters();

/// Describes why `one` cannot stand beside `other`, which the words name: a line without its end. Absent if it can.
[[nodiscard]] std::optional<std::string> conflict_between(const Parameter& one, const Parameter& other);

/// The value that a word stands for; absent if the parameter does not have that word.
[[nodiscard]] std::optional<double> value_named(const Parameter& parameter, std::string_view name);

/// The parameter of that name; nullptr if there is none.
[[nodiscard]] const Parameter* find_parameter(std::string_view name);

}  // namespace coilwright::actuator
