#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// What values a parameter may take in a file; a length is shortest_length to longest_length, a share -1 to 1.
enum class ParameterRule { positive, length, not_negative, at_least_one, share, any };

/// One number of a Design as files write it: the one table that the reader, the writer and a study's variables share.
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
  /// Whether the design needs it said: a share of the current, or which of several numbers names the wire. nullptr:
  /// always.
  bool (*needed)(const Design&) = nullptr;
  /// Of what it is one of several names: "the wire". Of those of a section a file gives one. Empty: of nothing.
  std::string_view one_name_of{};

  /// The names that files write where it is a choice among them, value by index. Empty for a number.
  [[nodiscard]] std::span<const std::string_view> names() const {
    return name_list == nullptr ? std::span<const std::string_view>() : name_list();
  }
};

/// Every number of a Design, section by section.
[[nodiscard]] std::span<const Parameter> parameters();

/// What is wrong about giving `one` beside `other`, which its words name: a line without its end, or nothing.
[[nodiscard]] std::optional<std::string> conflict_between(const Parameter& one, const Parameter& other);

/// The value of a parameter that has names for one of them; nothing for any other text.
[[nodiscard]] std::optional<double> value_named(const Parameter& parameter, std::string_view name);

/// The parameter of that name; nullptr if there is none.
[[nodiscard]] const Parameter* find_parameter(std::string_view name);

}  // namespace coilwright::actuator
