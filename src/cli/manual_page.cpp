#include "cli/manual_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>
#include <vector>

#include "cli/command_tree.hpp"
#include "coilwright/results/build_info.hpp"

namespace coilwright::cli {
namespace {

// A letter that troff takes for a command, and the dash that it would print as a hyphen.
std::string escaped(std::string_view text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\'')) out += "\\&";
  for (const char letter : text) {
    if (letter == '\\') {
      out += "\\e";
    } else if (letter == '-') {
      out += "\\-";
    } else {
      out += letter;
    }
  }
  return out;
}

std::string dashed(std::string name) {
  std::ranges::replace(name, ' ', '-');
  return name;
}

std::string synopsis(const CLI::App& command) {
  std::string text = fmt::format(".B {}\n", escaped(name_of(command)));
  for (const CLI::Option* place : places_of(command))
    text += place->get_required() ? fmt::format(".I {}\n", escaped(place->get_name(true)))
                                  : fmt::format("[\\fI{}\\fR]\n", escaped(place->get_name(true)));
  for (const CLI::Option* option : options_of(command))
    if (option->get_required()) text += fmt::format("\\fB{}\\fR \\fI...\\fR\n", escaped(names_of(*option).back()));
  return text + (command_names(command).empty() ? "[\\fIoptions\\fR]\n" : ".I command\n[\\fIarguments\\fR]\n");
}

std::string entry(const std::string& heading, std::string_view description) {
  return fmt::format(".TP\n{}\n{}\n", heading, escaped(description));
}

std::string arguments(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* place : places_of(command))
    text += entry("\\fI" + escaped(place->get_name(true)) + "\\fR", place->get_description());
  for (const CLI::Option* option : options_of(command)) {
    std::vector<std::string> names;
    for (const std::string& name : names_of(*option)) names.push_back("\\fB" + escaped(name) + "\\fR");
    const bool takes_one = option->get_items_expected_max() > 0;
    text += entry(fmt::format("{}{}", fmt::join(names, ", "), takes_one ? " \\fIvalue\\fR" : ""),
                  option->get_description());
  }
  return text;
}

// Paragraphs stay paragraphs, and what is set in by spaces is an example.
std::string notes(const std::string& footer) {
  std::istringstream lines(footer);
  std::string text = ".PP\n", line;
  bool literal = false;
  while (std::getline(lines, line)) {
    const bool example = line.starts_with("  ");
    if (example != literal) text += example ? ".PP\n.nf\n" : ".fi\n.PP\n";
    literal = example;
    text += line.empty() ? ".PP\n" : escaped(line) + "\n";
  }
  return text + (literal ? ".fi\n" : "");
}

}  // namespace

std::string manual_page_name(const CLI::App& command) {
  return dashed(name_of(command)) + ".1";
}

std::string manual_page(const CLI::App& command) {
  const std::string name = dashed(name_of(command));
  std::string title = name;
  std::ranges::transform(title, title.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  std::string text = fmt::format(".TH \"{}\" 1 \"\" \"coilwright {}\" \"Coilwright\"\n", title, results::version());
  text += fmt::format(".SH NAME\n{} \\- {}\n", escaped(name), escaped(command.get_description()));
  text += ".SH SYNOPSIS\n" + synopsis(command);
  text += ".SH OPTIONS\n" + arguments(command);
  if (const auto names = command_names(command); !names.empty()) {
    text += ".SH COMMANDS\n";
    for (const std::string& each : names)
      text += entry("\\fB" + escaped(each) + "\\fR", command.get_subcommand(each)->get_description());
  }
  if (const std::string footer = command.get_footer(); !footer.empty()) text += ".SH NOTES\n" + notes(footer);
  return text;
}

}  // namespace coilwright::cli
