#include "formats/study/study_keys.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/text/argument.hpp"
#include "coilwright/text/json/json_pointer.hpp"
#include "coilwright/text/number.hpp"

namespace coilwright::formats {

namespace {

// By a JSON pointer: the others are of its actuator.
bool is_of_file(std::string_view change) {
  return change.starts_with('/');
}

void require_block(const text::Node& root, std::string_view pointer, const std::string& change) {
  const auto steps = text::pointer_steps(pointer);
  if (steps && !steps->empty() && is_block(steps->front()) && !root.find(steps->front()))
    throw text::argument_error(change,
                               fmt::format("must be of a block that the study has: it has no \"{}\"; write that "
                                           "block into it (coilwright schema study)",
                                           steps->front()));
}

// What of the study's own file a name without a pointer means: "duty" is "/operating_point/duty".
std::optional<std::string> pointer_of(const text::Node& root, std::string_view name) {
  if (const std::optional<std::string> of_block = block_pointer(name)) return of_block;
  using Kind = text::Node::Kind;
  for (const std::string& key : root.keys()) {
    const text::Node block = *root.find(key);
    const auto there = block.kind() == Kind::object ? block.find(name) : std::nullopt;
    if (there && there->kind() != Kind::object && there->kind() != Kind::array)
      return text::pointer_step(key) + text::pointer_step(name);
  }
  return std::nullopt;
}

// What stands there says what a value is read as; where nothing stands yet, its own spelling does, and the reader of
// the study what the key takes.
text::PlainValue value_for(const text::Document& document, const text::NameAndValue& assignment,
                           const std::string& change) {
  using Kind = text::Node::Kind;
  if (assignment.name == "/actuator")
    throw text::argument_error(change, "must not be changed: a study of another actuator is another file");
  require_block(document.root(), assignment.name, change);
  const auto steps = text::pointer_steps(assignment.name);
  const std::optional<text::Node> there = steps ? text::follow(document.root(), *steps) : std::nullopt;
  const bool is_truth = assignment.value == "true" || assignment.value == "false";
  if (there && there->kind() == Kind::boolean && !is_truth) throw text::argument_error(change, "must be true or false");
  if (there && there->kind() == Kind::number) return text::number_of(change, assignment.value);
  if (there && there->kind() == Kind::text) return std::string(assignment.value);
  if (is_truth) return assignment.value == "true";
  if (const std::optional<double> number = text::number_in(assignment.value)) return *number;
  return std::string(assignment.value);
}

}  // namespace

text::Document changed(text::Document document, const StudyChanges& changes) {
  std::map<std::string, text::PlainValue> values;
  for (const std::string& change : changes) {
    if (!is_of_file(change)) continue;
    const text::NameAndValue assignment = text::split_assignment(change, change, "/search/seed=3");
    values[std::string(assignment.name)] = value_for(document, assignment, change);
    try {
      (void)document.with_values(values);
    } catch (const std::invalid_argument&) {
      throw text::argument_error(
          change,
          "must lead to a number, a word, or true or false of the study, as /search/seed does; lists "
          "count from 0");
    }
  }
  return values.empty() ? std::move(document) : document.with_values(values);
}

actuator::Design changed(actuator::Design design, const sizing::Study& study, const text::Node& root,
                         const StudyChanges& changes) {
  for (const std::string& change : changes) {
    for (const sizing::StudyVariable& variable : study.variables)
      if (change.starts_with(name_of(variable) + '='))
        throw text::argument_error(
            change, fmt::format("must not set {}, which is a variable of this study", name_of(variable)));
    if (is_of_file(change)) continue;
    const std::string_view name = std::string_view(change).substr(0, change.find('='));
    const bool of_actuator = actuator::find_parameter(name) != nullptr || name == "configuration";
    if (const auto pointer = of_actuator ? std::nullopt : pointer_of(root, name)) {
      require_block(root, *pointer, change);
      throw text::argument_error(
          change, fmt::format("is not a number of a design but of the study's file: --set {}=VALUE", *pointer));
    }
    design = with_assignment(std::move(design), change);
  }
  return design;
}

}  // namespace coilwright::formats
