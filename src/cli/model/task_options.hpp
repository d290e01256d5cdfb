#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <ranges>
#include <string>

#include "cli/options.hpp"
#include "coilwright/formats/systems/task_rows.hpp"

namespace coilwright::cli {

/// The explanation of an option with what counts without it: "Duration, s (default 2)".
[[nodiscard]] std::string with_default(const std::string& text, const auto& usual) {
  return fmt::format("{} (default {})", text, usual);
}

/// The option of a row, "--cell-capacity-mAh" of "cell_capacity_mAh"; its help ends with `usual`, what counts without
/// it.
/// `set` takes the number as in memory, or the place of the word.
CLI::Option* add_row_option(CLI::App& command, const text::RowFacts& row, const std::optional<double>& usual,
                            std::function<void(double)> set);

/// Adds the numbers of `rows` as options. `task` must outlive `command`.
template <std::ranges::input_range Rows, class Task>
void add_rows(CLI::App& command, const Rows& rows, Task& task) {
  for (const text::Row<Task>& row : rows)
    add_row_option(command, row, row.get(task), [set = row.set, &task](double value) { set(task, value); });
}

}  // namespace coilwright::cli
