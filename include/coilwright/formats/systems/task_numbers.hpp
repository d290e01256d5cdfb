#pragma once

#include <string_view>
#include <type_traits>
#include <vector>

#include "coilwright/systems/crawl_quantities.hpp"
#include "coilwright/systems/gripper/quantities.hpp"
#include "coilwright/text/rule.hpp"

namespace coilwright::formats {

/// A number of what is built from an actuator. The one table that the reader of a study's block, the study's variables,
/// the options of a command and the words of Python share.
template <class Task>
struct BlockNumber {
  std::string_view key;                  ///< its unit at its end
  text::Rule rule;                       ///< in that unit
  double (*get)(const Task&) = nullptr;  ///< SI
  void (*set)(Task&, double) = nullptr;  ///< SI
  /// Settings may vary, and required ones must be in the block. The others are whole numbers, and how finely it is
  /// computed: no variables.
  enum class Kind { setting, required, whole_step, of_computation };
  Kind kind = Kind::setting;
};

/// A row of such a table. `number` is a lambda without captures that gives the number of a task, by reference.
template <class Task, class Number>
[[nodiscard]] BlockNumber<Task> block_number(std::string_view key, const text::Rule& rule, Number,
                                             typename BlockNumber<Task>::Kind kind = BlockNumber<Task>::Kind::setting) {
  return {.key = key,
          .rule = rule,
          .get = [](const Task& task) { return static_cast<double>(Number{}(task)); },
          .set =
              [](Task& task, double value) {
                auto& number = Number{}(task);
                number = static_cast<std::remove_reference_t<decltype(number)>>(value);
              },
          .kind = kind};
}

/// Above zero, and within what any hardware has.
constexpr text::Rule up_to(double most) {
  return text::positive.and_also(text::Rule::at_most(most));
}

/// Those of a crawling robot.
[[nodiscard]] std::vector<BlockNumber<systems::CrawlTask>> crawl_numbers();

/// Those of a gripper with fingers and an object as `base` has them. A height belongs to what has flat sides alone, a
/// place beside the axis to two fingers.
[[nodiscard]] std::vector<BlockNumber<systems::gripper::GripperTask>> grip_numbers(
    const systems::gripper::GripperTask& base);

/// The shape of that name; a sphere where none has it.
[[nodiscard]] systems::gripper::ObjectShape shape_named(std::string_view name);

}  // namespace coilwright::formats
