#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/formats/systems/task_rows.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/json/rows.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

/// A number of a block that a study's variables may move.
struct BlockVariable {
  std::string name;  ///< "gripper_spacing_mm"
  text::Rule rule;   ///< in its unit
  double base{};     ///< what the block says, in its unit
};

/// What a block of a study brings.
struct SystemBlock {
  std::vector<simulation::ResultQuantity> quantities;
  std::vector<BlockVariable> variables;
  /// Throws std::invalid_argument where a study's actuator cannot be a part of it, whatever varies.
  std::function<void(const actuator::Design&)> require_suitable;
  /// Its drive, for a study whose current follows from it; empty if it has none.
  sizing::DrivenCurrent driven{};
  std::optional<sizing::StudyDriver> driver{};  ///< of the block of one
};

/// Names of what the function of quantities of a block gives, whatever its task.
template <class Task, auto Quantities>
[[nodiscard]] std::vector<std::string> names_of_quantities() {
  std::vector<std::string> names;
  for (const simulation::ResultQuantity& each : Quantities([](const simulation::Settings&) { return Task{}; }))
    names.push_back(each.name);
  return names;
}

/// Throws std::invalid_argument "needs an actuator without `what`" where a design that can be built has it.
inline void require_without(const actuator::Design& design, bool (*has)(const actuator::Model&),
                            std::string_view what) {
  const auto assembled = actuator::assemble(design);
  const auto* assembly = std::get_if<actuator::Assembly>(&assembled);
  if (assembly != nullptr && has(assembly->model))
    throw std::invalid_argument("needs an actuator without " + std::string(what));
}

/// "gripper_" and "spacing_mm".
inline std::string variable_name(std::string_view block, std::string_view key) {
  return std::string(block) + "_" + std::string(key);
}

/// The numbers of a block that may vary.
template <class Task>
std::vector<BlockVariable> variables_of(std::string_view block, std::span<const text::Row<Task>> rows,
                                        const Task& task) {
  std::vector<BlockVariable> out;
  for (const text::Row<Task>& row : rows)
    if (row.need != text::Need::fixed && !row.whole && row.words.empty())
      out.push_back({.name = variable_name(block, row.key),
                     .rule = row.rule,
                     .base = units::from_memory(row.get(task).value(), row.key)});
  return out;
}

/// The task of one design: the block's own, with the settings of that design.
template <class Task>
std::function<Task(const simulation::Settings&)> task_by(std::string_view block, std::span<const text::Row<Task>> rows,
                                                         Task task) {
  std::vector<std::pair<std::string, void (*)(Task&, double)>> setters;
  for (const text::Row<Task>& row : rows) setters.emplace_back(variable_name(block, row.key), row.set);
  return [setters = std::move(setters), task = std::move(task)](const simulation::Settings& settings) {
    Task out = task;
    if (settings.empty()) return out;
    for (const auto& [name, set] : setters)
      if (const auto found = settings.find(name); found != settings.end()) set(out, found->second);
    return out;
  };
}

/// The block "gripper" of a study: how fingers are mounted and what they lift. Its keys are in docs/formats.md.
[[nodiscard]] SystemBlock read_gripper_block(const text::Node& node);

/// The block "crawler" of a study: the ground, the cell, the pulses and the payload of a crawling robot. Its keys are
/// in docs/formats.md.
[[nodiscard]] SystemBlock read_crawler_block(const text::Node& node);

/// The block "driver" of a study: the pulsed supply of its coils. Its keys are in docs/formats-study.md.
[[nodiscard]] SystemBlock read_driver_block(const text::Node& node);

}  // namespace coilwright::formats
