#include "coilwright/text/json/node.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <utility>

#include "coilwright/text/json/json_pointer.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/plausible.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::text {
namespace {

template <class Type>
const Type* as(const Json* value) {
  return std::get_if<Type>(&value->content());
}

// Where a rule has no end, the number's unit has.
Rule with_ends(const Rule& rule, const units::Unit& unit) {
  const double greatest = units::greatest_plausible(unit);
  Rule out = rule;
  if (!std::isfinite(rule.upper())) out = out.and_also(Rule::at_most(greatest));
  if (!std::isfinite(rule.lower())) out = out.and_also(Rule::at_least(-greatest));
  return out;
}

std::string length_rule(const Length& length) {
  const std::string_view elements = length.least == 1 ? "element" : "elements";
  if (length.least == length.most) return fmt::format("must have {} {}", length.least, elements);
  if (length.most == Length{}.most) return fmt::format("must have at least {} {}", length.least, elements);
  return fmt::format("must have {} to {} elements", length.least, length.most);
}

}  // namespace

Node::Node(const std::string& file, const Json& value, std::string pointer, std::string key)
    : file_(&file), value_(&value), pointer_(std::move(pointer)), key_(std::move(key)) {}

Node Node::child(const Json& value, std::string_view token, std::string key) const {
  return {*file_, value, pointer_ + pointer_step(token), std::move(key)};
}

Node::Kind Node::kind() const noexcept {
  // The kinds stand in the order of the variant's alternatives.
  return static_cast<Kind>(value_->content().index());
}

double Node::number(const Rule& rule) const {
  const double* value = as<double>(value_);
  if (value == nullptr) throw error("must be a number");
  if (!rule.allows(*value)) throw error(rule.text());
  return *value;
}

double Node::quantity(const Rule& rule) const {
  const auto name = units::split_unit(key_);
  assert(name && "a quantity's key must end in a unit");
  if (!name) return number(rule);
  return quantity_in(name->unit, rule);
}

double Node::quantity_in(const units::Unit& unit, const Rule& rule) const {
  const double value = number(rule);
  const Rule ended = with_ends(rule, unit);
  if (!ended.allows(value)) throw error(ended.text());
  return units::to_si(value, unit);
}

double Node::whole_number(const Rule& rule, double lowest, double highest) const {
  const double* value = as<double>(value_);
  if (value == nullptr) throw error("must be a whole number");
  // Beyond 2^53 a double no longer tells neighbouring integers apart.
  constexpr double exact = 9007199254740992.0;
  if (*value != std::floor(*value)) throw error("must be a whole number");
  if (!rule.allows(*value)) throw error(rule.text());
  const Rule range = Rule::between(std::max(lowest, -exact), std::min(highest, exact));
  if (!range.allows(*value)) throw error(range.text());
  return *value;
}

bool Node::boolean() const {
  const bool* value = as<bool>(value_);
  if (value == nullptr) throw error("must be true or false");
  return *value;
}

const std::string& Node::text() const {
  const std::string* value = as<std::string>(value_);
  if (value == nullptr) throw error("must be a text");
  return *value;
}

const std::string& Node::name() const {
  const std::string& name = text();
  if (one_line(name, name.size()) != name) throw error("must be one line without control characters");
  if (name.starts_with('=') || name.starts_with('@'))
    throw error(R"(must not begin with "=" or "@": a spreadsheet takes it for a formula)");
  return name;
}

std::filesystem::path Node::path() const {
  if (name().empty()) throw error("must be a path");
  return std::filesystem::path(*file_).parent_path() / text();
}

std::vector<Node> Node::elements(Length length) const {
  const auto* array = as<Json::Array>(value_);
  if (array == nullptr) throw error("must be an array");
  if (array->size() < length.least || array->size() > length.most) {
    throw error(length_rule(length));
  }
  std::vector<Node> nodes;
  nodes.reserve(array->size());
  for (const Json& element : *array) nodes.push_back(child(element, std::to_string(nodes.size()), key_));
  return nodes;
}

std::vector<double> Node::numbers(Length length, const Rule& rule) const {
  std::vector<double> values;
  for (const Node& element : elements(length)) values.push_back(element.number(rule));
  return values;
}

std::vector<double> Node::quantities(Length length, const Rule& rule) const {
  std::vector<double> values;
  for (const Node& element : elements(length)) values.push_back(element.quantity(rule));
  return values;
}

std::array<double, 3> Node::vector(const Rule& rule) const {
  const std::vector<Node> parts = elements(Length::exactly(3));
  const bool with_unit = units::split_unit(key_).has_value();
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = with_unit ? parts[i].quantity(rule) : parts[i].number(rule);
  }
  return values;
}

void Node::expect_object() const {
  if (kind() != Kind::object) throw error("must be an object");
}

std::vector<std::string> Node::keys() const {
  expect_object();
  std::vector<std::string> keys;
  for (const auto& [key, value] : *as<Json::Object>(value_)) keys.push_back(key);
  return keys;
}

std::vector<Node> Node::members() const {
  expect_object();
  std::vector<Node> nodes;
  for (const auto& [key, value] : *as<Json::Object>(value_)) nodes.push_back(child(value, key, key));
  return nodes;
}

std::optional<Node> Node::find(std::string_view key) const {
  expect_object();
  for (const auto& [name, value] : *as<Json::Object>(value_)) {
    if (name == key) return child(value, key, std::string(key));
  }
  return std::nullopt;
}

InputError Node::error(std::string rule) const {
  return InputError(
      {.file = *file_, .place = pointer_.empty() ? "/" : pointer_, .rule = std::move(rule), .value = shown()});
}

InputError Node::error_without_value(std::string rule) const {
  return InputError({.file = *file_, .place = pointer_.empty() ? "/" : pointer_, .rule = std::move(rule)});
}

InputError Node::wrong_word(const std::vector<std::string>& legal) const {
  if (kind() != Kind::text) return error("must be a text");
  // A format with another number is of another version, and not misspelt.
  const std::string meant = key_ == "format" ? "" : did_you_mean(text(), legal);
  return error(must_be_one_of(legal) + meant);
}

std::string Node::shown() const {
  switch (kind()) {
    case Kind::null:
      return "null";
    case Kind::boolean:
      return *as<bool>(value_) ? "true" : "false";
    case Kind::number:
      return fmt::format("{}", *as<double>(value_));
    case Kind::text:
      return "text " + in_quotes(*as<std::string>(value_));
    case Kind::array:
      return fmt::format("an array of {}", as<Json::Array>(value_)->size());
    case Kind::object:
      return "an object";
  }
  return {};
}

}  // namespace coilwright::text
