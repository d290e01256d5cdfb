#include "coilwright/text/json/object_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

#include "coilwright/text/json/json_pointer.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::text {
namespace {

// "gap_m" or "gap" where "gap_mm" is asked for.
bool differs_in_unit_only(std::string_view key, std::string_view asked) {
  return key != asked && units::split_unit(asked).has_value() && units::quantity_of(key) == units::quantity_of(asked);
}

InputError at_key(const Node& object, std::string_view key, std::string rule) {
  return InputError({.file = object.file(), .place = object.pointer() + pointer_step(key), .rule = std::move(rule)});
}

}  // namespace

ObjectReader::ObjectReader(Node node) : node_(std::move(node)) {
  node_.expect_object();
}

std::optional<Node> ObjectReader::find(std::string_view key) {
  asked_for_.emplace(key);
  return node_.find(key);
}

std::optional<Node> ObjectReader::find_not_null(std::string_view key) {
  auto node = find(key);
  if (node && node->is_null()) return std::nullopt;
  return node;
}

std::optional<Node> ObjectReader::find_in_any_unit(std::string_view key) {
  const auto wanted = units::split_unit(key);
  for (const std::string& present : node_.keys()) {
    const auto name = units::split_unit(present);
    if (name && wanted && name->quantity == wanted->quantity && name->unit.dimension == wanted->unit.dimension)
      return find(present);
  }
  return find(key);
}

Node ObjectReader::at_in_any_unit(std::string_view key) {
  auto node = find_in_any_unit(key);
  if (!node) throw missing(key);
  return *std::move(node);
}

Node ObjectReader::at(std::string_view key, std::span<const std::string_view> words) {
  auto node = find(key);
  if (!node) throw missing(key, words);
  return *std::move(node);
}

std::string ObjectReader::one_of(std::initializer_list<std::string_view> keys) {
  std::vector<std::string> listed;
  std::string found;
  for (const std::string_view key : keys) {
    listed.push_back(in_quotes(key));
    if (!find(key)) continue;
    if (!found.empty()) {
      throw at_key(node_, key, fmt::format("cannot stand beside {}", in_quotes(found)));
    }
    found = key;
  }
  if (!found.empty()) return found;
  for (const std::string& key : node_.keys()) {
    for (const std::string_view asked : keys) {
      if (differs_in_unit_only(key, asked)) throw unknown(key);
    }
    const std::vector<std::string> candidates(keys.begin(), keys.end());
    if (!asked_for_.contains(key) && !did_you_mean(key, candidates).empty()) throw unknown(key);
  }
  throw node_.error_without_value(fmt::format("needs one of {}", fmt::join(listed, ", ")));
}

double ObjectReader::number_or(std::string_view key, double otherwise, const Rule& rule) {
  return optional_number(key, rule).value_or(otherwise);
}

double ObjectReader::quantity_or(std::string_view key, double otherwise, const Rule& rule) {
  return optional_quantity(key, rule).value_or(otherwise);
}

std::optional<double> ObjectReader::optional_number(std::string_view key, const Rule& rule) {
  const auto node = find(key);
  return node ? std::optional(node->number(rule)) : std::nullopt;
}

std::optional<double> ObjectReader::optional_quantity(std::string_view key, const Rule& rule) {
  const auto node = find(key);
  return node ? std::optional(node->quantity(rule)) : std::nullopt;
}

std::string ObjectReader::text_or(std::string_view key, std::string otherwise) {
  const auto node = find(key);
  if (node) return node->text();
  return otherwise;
}

std::string ObjectReader::name() {
  const auto node = find("name");
  return node ? node->name() : std::string();
}

void ObjectReader::literal(std::string_view key, std::string_view expected) {
  (void)choice<bool>(key, {{expected, true}});
}

void ObjectReader::finish() const {
  for (const std::string& key : node_.keys()) {
    if (asked_for_.contains(key)) continue;
    const bool for_others = key == comment_key || (key == schema_key && node_.pointer().empty());
    if (!for_others) throw unknown(key);
    (void)node_.find(key)->text();
  }
}

InputError ObjectReader::missing(std::string_view key, std::span<const std::string_view> legal) const {
  std::vector<std::string> strangers;
  const std::vector<std::string> wanted{std::string(key)};
  for (const std::string& present : node_.keys()) {
    if (asked_for_.contains(present)) continue;
    if (differs_in_unit_only(present, key) || !radius_or_diameter(present, wanted).empty()) return unknown(present);
    strangers.push_back(present);
  }
  // Not all keys have been asked for yet, so the near one may be legal in its own right: a question, not a verdict.
  const std::vector<std::string> near = nearest_words(key, strangers);
  std::string rule = "is missing";
  if (!legal.empty()) rule += ": it " + must_be_one_of(std::vector<std::string>(legal.begin(), legal.end()));
  if (!near.empty()) rule += fmt::format("; is {} meant to be it?", in_quotes(near.front()));
  return at_key(node_, key, std::move(rule));
}

InputError ObjectReader::unknown(const std::string& key) const {
  std::vector<std::string> absent, all;
  for (const std::string& asked : asked_for_) {
    all.push_back(in_quotes(asked));
    if (node_.find(asked)) continue;
    if (differs_in_unit_only(key, asked)) {
      return at_key(node_, key, fmt::format("unknown key; did you mean {}?", in_quotes(asked)));
    }
    absent.push_back(asked);
  }
  const std::string suggestion = did_you_mean(key, absent);
  if (!suggestion.empty()) return at_key(node_, key, "unknown key" + suggestion);
  return at_key(node_, key, fmt::format("unknown key; the keys here are {}", fmt::join(all, ", ")));
}

}  // namespace coilwright::text
