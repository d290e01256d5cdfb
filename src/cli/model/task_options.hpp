#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "coilwright/formats/systems/task_numbers.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {

/// Adds the number of that key as an option: "cell_capacity_mAh" is --cell-capacity-mAh. `task` must outlive `command`.
template <class Task>
CLI::Option* add_number_of(CLI::App& command, const std::vector<formats::BlockNumber<Task>>& numbers,
                           std::string_view key, Task& task, const std::string& text) {
  using Number = formats::BlockNumber<Task>;
  const Number number = *std::ranges::find(numbers, key, &Number::key);
  const std::string_view quantity = units::quantity_of(key);
  std::string name = "--" + std::string(quantity);
  std::ranges::replace(name, '_', '-');
  if (quantity != key) name += "-" + std::string(key.substr(quantity.size() + 1));
  const auto set = [number, &task](double value) { number.set(task, value * units::to_memory(1.0, number.key)); };
  if (number.kind == Number::Kind::whole_step)
    return command.add_option_function<int>(name, set, text)->transform(whole_number_rule(number.rule));
  return command.add_option_function<double>(name, set, text)
      ->check(number_rule(number.rule))
      ->required(number.kind == Number::Kind::required);
}

}  // namespace coilwright::cli
