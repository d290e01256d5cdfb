#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/text/rule.hpp"

namespace coilwright::cli {

/// For `app.add_option(...)->check(number_rule(text::positive))`: the argument must be a number as in our files (a
/// point, no NaN, no Infinity) that the rule allows. CLI11 by itself takes "nan" and "inf".
[[nodiscard]] CLI::Validator number_rule(const text::Rule& rule);

/// For `app.add_option(...)->transform(whole_number_rule(rule))`, where the number is stored as an integer: the
/// argument must be a whole number, which may be written as 2000 or 2e3, that the rule allows. CLI11 by itself says
/// of 2.5 that it could not be converted, and takes 010 for eight; here it is ten. `rule` has bounds of at most 2^53.
[[nodiscard]] CLI::Validator whole_number_rule(const text::Rule& rule);

/// For `app.add_option(...)->check(word_rule({"series", "parallel"}))`: the argument must be one of `words`. Its
/// refusal names them, the one that was probably meant and the argument.
[[nodiscard]] CLI::Validator word_rule(std::vector<std::string> words);

/// For an input that a command reads more than once, to check it and to copy it or its digest: "-", which is standard
/// input everywhere else, is refused.
[[nodiscard]] CLI::Validator file_rule();

/// For the name of a folder or a file that must be given.
[[nodiscard]] CLI::Validator not_empty();

/// Above 0, and not beyond `most`.
[[nodiscard]] constexpr text::Rule up_to(double most) {
  return text::positive.and_also(text::Rule::at_most(most));
}

/// An option with a number, which may be std::optional, that the rule allows.
template <class Number>
CLI::Option* add_number(CLI::App& command, const std::string& name, Number& value, const text::Rule& rule,
                        const std::string& text) {
  return command.add_option(name, value, text)->check(number_rule(rule));
}

/// The same of a whole number.
template <class Number>
CLI::Option* add_whole_number(CLI::App& command, const std::string& name, Number& value, const text::Rule& rule,
                              const std::string& text) {
  return command.add_option(name, value, text)->transform(whole_number_rule(rule));
}

/// An option with one of `words`.
template <class Text>
CLI::Option* add_word(CLI::App& command, const std::string& name, Text& value, std::vector<std::string> words,
                      const std::string& text) {
  return command.add_option(name, value, text)->check(word_rule(std::move(words)));
}

/// An option that is given or not: --json=false is refused.
CLI::Option* add_flag(CLI::App& command, const std::string& name, bool& value, const std::string& text);

/// --json of a command that else prints `instead`.
CLI::Option* add_json_option(CLI::App& command, bool& json, const std::string& instead = "a table");

/// --seed: what it is of, and its default.
void add_seed_option(CLI::App& command, auto& seed, const std::string& text) {
  add_whole_number(command, "--seed", seed, text::Rule::between(0, 9007199254740992.0), text);
}

/// --threads of a command: `what` is done at once, "Fits made at once". No result depends on it, so what exceeds the
/// cores that this process may run on counts as their number: more would only take turns, and TBB warns of some.
void add_threads_option(CLI::App& command, int& threads, const std::string& what);

/// Throws InputError if two arguments of the form name=value have one name: the second would win, and nobody would
/// know. `gap_mm=1.3: must not be there twice: gap_mm=1.2 sets it too`.
void require_names_once(std::span<const std::string> arguments);

}  // namespace coilwright::cli
