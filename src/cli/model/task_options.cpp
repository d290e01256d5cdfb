#include "cli/model/task_options.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "coilwright/units/unit.hpp"

namespace coilwright::cli {

CLI::Option* add_row_option(CLI::App& command, const text::RowFacts& row, const std::optional<double>& usual,
                            std::function<void(double)> set) {
  const auto unit = units::split_unit(row.key);
  std::string name = fmt::format("--{}", unit ? unit->quantity : row.key);
  std::ranges::replace(name, '_', '-');
  std::string help(row.meaning);
  if (unit) {
    name += fmt::format("-{}", unit->unit.suffix);
    std::string shown(unit->unit.suffix);
    std::ranges::replace(shown, '_', '/');
    help.insert(std::min(help.find_first_of(";:"), help.size()), ", " + shown);
  }
  const auto otherwise = text::usual_of(row, usual);
  if (!row.words.empty()) {
    const std::vector<std::string> words(row.words.begin(), row.words.end());
    if (otherwise) help = with_default(help, words[static_cast<std::size_t>(*otherwise)]);
    const auto set_word = [words, set = std::move(set)](const std::string& word) {
      set(static_cast<double>(std::ranges::find(words, word) - words.begin()));
    };
    return command.add_option_function<std::string>(name, set_word, help)->check(word_rule(words));
  }
  if (otherwise) help = with_default(help, *otherwise);
  const auto set_number = [key = row.key, set = std::move(set)](double value) { set(units::to_memory(value, key)); };
  CLI::Option* option = command.add_option_function<double>(name, set_number, help);
  if (row.whole) return option->transform(whole_number_rule(row.rule))->type_name("INT");
  return option->check(number_rule(row.rule))->required(row.need == text::Need::required);
}

}  // namespace coilwright::cli
