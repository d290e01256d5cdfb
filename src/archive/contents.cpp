#include "coilwright/archive/contents.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "archive/schema.hpp"

namespace coilwright::archive {
namespace {

// SQLite tells columns apart without the case of their letters.
std::string lower_case(std::string name) {
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

class ColumnNames {
 public:
  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int again = 2; !taken_.insert(lower_case(name)).second; ++again) name = fmt::format("{}_{}", wanted, again);
    return name;
  }

 private:
  std::set<std::string> taken_ = [] {
    std::set<std::string> taken(fixed_columns.begin(), fixed_columns.end());
    taken.insert({"checksum", "choice"});
    return taken;
  }();
};

std::string quoted_or_none(const std::string& text) {
  return text.empty() ? "none" : text;
}

std::string changes_text(const Contents& contents) {
  return contents.changes.empty() ? "no --set" : fmt::format("--set {}", fmt::join(contents.changes, " --set "));
}

std::string seed_text(const Contents& contents) {
  return contents.seed ? fmt::format("seed {}", *contents.seed) : "no seed";
}

void compare(std::vector<std::string>& out, const std::string& what, const std::string& found,
             const std::string& asked) {
  if (found != asked) out.push_back(fmt::format("{}{}, not {}", what, quoted_or_none(found), quoted_or_none(asked)));
}

void compare_programs(std::vector<std::string>& out, const Program& found, const Program& asked) {
  if (found != asked)
    out.push_back(fmt::format("coilwright {}, not {}, whose numbers may differ", name_of(found), name_of(asked)));
}

void compare_inputs(std::vector<std::string>& out, const Contents& found, const Contents& asked) {
  for (std::size_t i = 0; i < std::min(found.inputs.size(), asked.inputs.size()); ++i)
    if (found.inputs[i].sha256 != asked.inputs[i].sha256)
      out.push_back(fmt::format("{} with another content (SHA-256 {:.8}, not {:.8})", found.inputs[i].file,
                                found.inputs[i].sha256, asked.inputs[i].sha256));
  if (found.inputs.size() != asked.inputs.size())
    out.push_back(fmt::format("{} input files, not {}", found.inputs.size(), asked.inputs.size()));
}

std::set<std::string> names_of(const Contents& contents, Role role) {
  std::set<std::string> names;
  for (const Column& column : contents.columns)
    if (column.role == role) names.insert(column.name);
  return names;
}

}  // namespace

std::string name_of(const Program& program) {
  std::string text = program.version;
  if (program.commit.empty())
    text += " (commit unknown";
  else
    text += fmt::format(" (commit {:.7}", program.commit);
  if (!program.build.empty()) text += fmt::format(", build {:.7}", program.build);
  return text + ")";
}

std::string_view name_of(Role role) {
  switch (role) {
    case Role::variable:
      return "variable";
    case Role::objective:
      return "objective";
    case Role::constraint:
      return "constraint";
    case Role::quantity:
      return "quantity";
  }
  return "unknown";
}

std::vector<Column> columns_of(const sizing::Study& study) {
  std::vector<Column> columns;
  ColumnNames names;
  for (const sizing::StudyVariable& variable : study.variables) {
    const std::string name = sizing::name_of(variable);
    columns.push_back({.role = Role::variable, .name = name, .meaning = {}, .column = names.unique(name)});
  }
  for (std::size_t i = 0; i < study.objectives.size(); ++i)
    columns.push_back({.role = Role::objective,
                       .name = study.objectives[i].quantity.name,
                       .meaning = study.objectives[i].sense == sizing::Sense::maximise ? "maximise" : "minimise",
                       .column = names.unique(fmt::format("objective_{}", i + 1))});
  for (std::size_t i = 0; i < study.limits.size(); ++i)
    columns.push_back({.role = Role::constraint,
                       .name = sizing::name_of(study.limits[i]),
                       .meaning = {},
                       .column = names.unique(fmt::format("constraint_{}", i + 1))});
  for (const simulation::ResultQuantity& quantity : study.quantities)
    columns.push_back({.role = Role::quantity,
                       .name = quantity.name,
                       .meaning = std::string(quantity.meaning),
                       .column = names.unique(quantity.name)});
  return columns;
}

std::vector<std::string> differences(const Contents& found, const Contents& asked) {
  std::vector<std::string> out;
  compare(out, "command ", found.command, asked.command);
  compare_inputs(out, found, asked);
  compare(out, "", changes_text(found), changes_text(asked));
  compare(out, "algorithm ", found.algorithm, asked.algorithm);
  compare(out, "", seed_text(found), seed_text(asked));
  compare_programs(out, found.program, asked.program);
  if (out.empty() && (found.columns != asked.columns || found.physics != asked.physics))
    out.emplace_back("other columns or physics, though its inputs are the same");
  return out;
}

std::vector<std::string> differences_for_reuse(const Contents& found, const Contents& asked) {
  std::vector<std::string> out;
  compare_programs(out, found.program, asked.program);
  if (found.physics.actuator != asked.physics.actuator) out.emplace_back("another actuator");
  if (found.physics.operation != asked.physics.operation) out.emplace_back("another operating point");
  if (found.physics.systems != asked.physics.systems)
    out.emplace_back("another study of what is built from the actuator (gripper, crawler, driver, spread)");
  const std::set<std::string> known = names_of(found, Role::variable), wanted = names_of(asked, Role::variable);
  if (known != wanted)
    out.push_back(fmt::format("variables {}, not {}", fmt::join(known, ", "), fmt::join(wanted, ", ")));
  for (const Column& column : asked.columns) {
    if (column.role != Role::quantity) continue;
    const bool same = std::ranges::any_of(found.columns, [&](const Column& each) {
      return each.role == Role::quantity && each.name == column.name && each.meaning == column.meaning;
    });
    if (!same) out.push_back(fmt::format("no quantity {} as this study has it", column.name));
  }
  return out;
}

}  // namespace coilwright::archive
