#include "word_rule.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"

namespace coilwright::cli {

CLI::Validator word_rule(std::vector<std::string> words) {
  const auto complaint = [words = std::move(words)](std::string& argument) -> std::string {
    if (std::ranges::count(words, argument) > 0) return {};
    std::vector<std::string> shown;
    for (const std::string& word : words) shown.push_back(text::in_quotes(word));
    return fmt::format("must be one of {}{}; got {}", fmt::join(shown, ", "), text::did_you_mean(argument, words),
                       text::in_quotes(argument));
  };
  return CLI::Validator(complaint, "");
}

}  // namespace coilwright::cli
