#include "cli/options.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>

#include "coilwright/text/argument.hpp"
#include "coilwright/text/number.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"

namespace coilwright::cli {
namespace {

std::string got(std::string_view argument) {
  return "; got " + text::in_quotes(argument);
}

constexpr int most_threads = 1024;

// As TBB counts them: those that this process may run on, which hardware_concurrency does not heed. At least one.
int cores() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof(allowed), &allowed) == 0) return CPU_COUNT(&allowed);
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));  // more than the set can hold
}

}  // namespace

CLI::Validator number_rule(const text::Rule& rule) {
  const auto complaint = [rule](std::string& argument) -> std::string {
    const std::optional<double> value = text::number_in(argument);
    if (!value) return "must be a finite number" + got(argument);
    return rule.allows(*value) ? std::string() : rule.text() + got(argument);
  };
  return CLI::Validator(complaint, "");
}

CLI::Validator whole_number_rule(const text::Rule& rule) {
  const auto rewrite = [rule](std::string& argument) -> std::string {
    const std::optional<double> value = text::number_in(argument);
    if (!value || *value != std::floor(*value)) return "must be a whole number" + got(argument);
    const std::optional<std::int64_t> exact = text::number_in<std::int64_t>(argument);
    // 9007199254740993 is not a double, and the one next to it may be allowed.
    const bool rounded = exact && static_cast<double>(*exact) == *value && static_cast<std::int64_t>(*value) != *exact;
    if (!rule.allows(*value) || rounded) return rule.text() + got(argument);
    argument = fmt::format("{:.0f}", *value);
    return {};
  };
  return CLI::Validator(rewrite, "");
}

CLI::Validator word_rule(std::vector<std::string> words) {
  const auto complaint = [words = std::move(words)](std::string& argument) -> std::string {
    if (std::ranges::count(words, argument) > 0) return {};
    return fmt::format("{}{}; got {}", text::must_be_one_of(words), text::did_you_mean(argument, words),
                       text::in_quotes(argument));
  };
  return CLI::Validator(complaint, "");
}

CLI::Validator file_rule() {
  const auto complaint = [](std::string& argument) {
    return argument == "-" ? std::string("must be a file, which is read twice; got \"-\", standard input")
                           : std::string();
  };
  return CLI::Validator(complaint, "");
}

CLI::Validator not_empty() {
  return CLI::Validator([](std::string& name) { return std::string(name.empty() ? "must not be empty" : ""); }, "");
}

CLI::Option* add_flag(CLI::App& command, const std::string& name, bool& value, const std::string& text) {
  return command.add_flag(name, value, text)->disable_flag_override();
}

CLI::Option* add_json_option(CLI::App& command, bool& json, const std::string& instead) {
  return add_flag(command, "--json", json, "Print JSON instead of " + instead);
}

void add_threads_option(CLI::App& command, int& threads, const std::string& what) {
  command
      .add_option_function<int>(
          "--threads", [&threads](int asked) { threads = std::min(asked, cores()); },
          what + ", at most the number of cores (default 0: one for each core)")
      ->transform(whole_number_rule(text::Rule::between(0, most_threads)));
}

void require_names_once(std::span<const std::string> arguments) {
  const auto name_of = [](std::string_view argument) { return argument.substr(0, argument.find('=')); };
  for (std::size_t i = 0; i < arguments.size(); ++i)
    for (std::size_t earlier = 0; earlier < i; ++earlier)
      if (name_of(arguments[earlier]) == name_of(arguments[i]))
        throw text::argument_error(arguments[i], "must not be there twice: " + arguments[earlier] + " sets it too");
}

}  // namespace coilwright::cli
