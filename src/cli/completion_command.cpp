#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command_descriptions.hpp"
#include "cli/command_tree.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"

namespace coilwright::cli {
namespace {

struct TypedCommand {
  std::string typed;  // "rig camera"; empty: the program itself
  const CLI::App* command;
};

void collect(const CLI::App& command, const std::string& typed, std::vector<TypedCommand>& all) {
  all.push_back({.typed = typed, .command = &command});
  for (const std::string& name : command_names(command))
    collect(*command.get_subcommand(name), fmt::format("{} {}", typed, name), all);
}

std::string option_words(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options_of(command))
    for (std::string& name : names_of(*option)) names.push_back(std::move(name));
  return fmt::format("{}", fmt::join(names, " "));
}

// What may stand right behind a command: one below it, or a word of a few. Behind `help`, any command.
std::string first_words(const TypedCommand& each, const CLI::App& app) {
  std::vector<std::string> words = command_names(each.typed == "help" ? app : *each.command);
  for (const CLI::Option* place : places_of(*each.command))
    for (std::string& word : words_of(*place)) words.push_back(std::move(word));
  return fmt::format("{}", fmt::join(words, " "));
}

// What --set takes: each number of a design with its =, and each name of what has names.
std::vector<std::string> design_words() {
  std::vector<std::string> words;
  for (const char* letter : {"A", "B", "C", "D"}) words.push_back(fmt::format("configuration={}", letter));
  for (const actuator::Parameter& parameter : actuator::parameters()) {
    if (parameter.names().empty()) words.push_back(fmt::format("{}=", parameter.name));
    for (const std::string_view name : parameter.names()) words.push_back(fmt::format("{}={}", parameter.name, name));
  }
  return words;
}

// What --effect begins with: each effect, up to its first number.
std::vector<std::string> effect_words() {
  std::vector<std::string> words;
  for (const actuator::EffectKind* kind : actuator::standard_effects().kinds()) {
    const auto numbers = kind->parameters();
    words.push_back(numbers.empty() ? std::string(kind->id()) : fmt::format("{}:{}=", kind->id(), numbers.front().key));
  }
  return words;
}

// What may stand behind an option.
std::vector<std::string> values_of(const CLI::Option& option) {
  const std::string name = names_of(option).back();
  if (name == "--set") return design_words();
  if (name == "--effect") return effect_words();
  return words_of(option);
}

// The lines of one command in the functions below.
CompletionLines lines_of(const TypedCommand& each, const CLI::App& app) {
  CompletionLines out;
  out.words = fmt::format("    \"{}\") options=\"{}\" first=\"{}\" ;;\n", each.typed, option_words(*each.command),
                          first_words(each, app));
  for (const CLI::Option* option : options_of(*each.command))
    if (const std::vector<std::string> known = values_of(*option); !known.empty())
      out.values +=
          fmt::format("    \"{} {}\") values=\"{}\" ;;\n", each.typed, names_of(*option).back(), fmt::join(known, " "));
  return out;
}

// Functions that bash and zsh take alike.
std::string functions(const CLI::App& app) {
  CompletionLines all = lines_of({.typed = {}, .command = &app}, app);
  for (const CommandDescription& each : descriptions(app)) {
    all.words += each.completion.words;
    all.values += each.completion.values;
  }
  return "_coilwright_words() {\n  case \"$1\" in\n" + all.words + "    *) return 1 ;;\n  esac\n}\n" +
         "_coilwright_values() {\n  case \"$1 $2\" in\n" + all.values + "  esac\n}\n";
}

constexpr std::string_view bash_head =
    "# Completion of coilwright for bash. Source it, or install it as share/bash-completion/completions/coilwright.\n";
constexpr std::string_view bash_function = R"(
_coilwright() {
  # bash takes words apart at = and :, and replaces what stands behind the last of them.
  local typed="${COMP_WORDS[COMP_CWORD]}" current="${COMP_WORDS[COMP_CWORD]}" kept i=$COMP_CWORD
  while ((i > 1)) && [[ $current == [=:]* || ${COMP_WORDS[i-1]} == [=:] ]]; do
    ((i--))
    current="${COMP_WORDS[i]}$current"
  done
  local before="${COMP_WORDS[i-1]}"
  if [[ $current == --*=* ]]; then
    before="${current%%=*}"
    current="${current#*=}"
  fi
  [[ $typed == [=:] ]] && typed=""
  kept="${current%"$typed"}"
  local command="" options="" first="" values="" words="" at=1
  _coilwright_words ""
  for ((i = 1; i < COMP_CWORD; i++)); do
    _coilwright_words "${command:+$command }${COMP_WORDS[i]}" || break
    command="${command:+$command }${COMP_WORDS[i]}"
    at=$((i + 1))
  done
  _coilwright_values "$command" "$before"
  if [[ -n $values ]]; then
    words=$values
  elif [[ $current == -* ]]; then
    words=$options
  elif ((COMP_CWORD == at)); then
    words=$first
  fi
  if [[ -n $words ]]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
    [[ ${COMPREPLY[*]} == *[=:] ]] && compopt -o nospace 2>/dev/null
    COMPREPLY=("${COMPREPLY[@]#"$kept"}")
  else
    COMPREPLY=($(compgen -f -- "$current"))
  fi
}
complete -o filenames -F _coilwright coilwright
)";

constexpr std::string_view zsh_head =
    "#compdef coilwright\n"
    "# Completion of coilwright for zsh. Install it as _coilwright in a folder of fpath.\n";
constexpr std::string_view zsh_function = R"(
_coilwright() {
  local current="$words[CURRENT]" before="$words[CURRENT-1]"
  local command="" options="" first="" values="" at=2 i
  _coilwright_words ""
  for ((i = 2; i < CURRENT; i++)); do
    _coilwright_words "${command:+$command }$words[i]" || break
    command="${command:+$command }$words[i]"
    at=$((i + 1))
  done
  _coilwright_values "$command" "$before"
  if [[ -n $values ]]; then
    local -a all=(${=values})
    compadd -- ${all:#*=}
    compadd -S '' -- ${(M)all:#*=}
  elif [[ $current == -* ]]; then
    compadd -- ${=options}
  elif ((CURRENT == at)) && [[ -n $first ]]; then
    compadd -- ${=first}
  else
    _files
  fi
}
if [[ $funcstack[1] == _coilwright ]]; then _coilwright "$@"; else compdef _coilwright coilwright; fi
)";

}  // namespace

CompletionLines completion_of(const CLI::App& command, const CLI::App& app) {
  std::vector<TypedCommand> all;
  collect(command, command.get_name(), all);
  CompletionLines out;
  for (const TypedCommand& each : all) {
    const CompletionLines lines = lines_of(each, app);
    out.words += lines.words;
    out.values += lines.values;
  }
  return out;
}

void add_completion_command(CLI::App& app, Outcome&) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("completion", "Print what a shell needs to complete commands and options");
  command->add_option("SHELL", *shell, "One of bash, zsh")->required()->check(word_rule({"bash", "zsh"}));
  command->footer("Example:\n  source <(coilwright completion bash)");
  command->callback([shell, &app] {
    const bool zsh = *shell == "zsh";
    std::cout << (zsh ? zsh_head : bash_head) << functions(app) << (zsh ? zsh_function : bash_function);
  });
}

}  // namespace coilwright::cli
