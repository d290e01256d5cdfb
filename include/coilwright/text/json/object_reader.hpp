#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "coilwright/text/json/node.hpp"

namespace coilwright::text {

/// The key that tells an editor the JSON Schema of a document. Readers skip it, and writers do not write it.
inline constexpr std::string_view schema_key = "$schema";

/// A key for a remark in any object, because JSON has no comments. Readers skip it, and writers do not write it.
inline constexpr std::string_view comment_key = "comment";

/// Reads the keys of one JSON object, each requested once, and at the end refuses those that were not requested.
///
///     const auto coil = read_object(node, [](ObjectReader& in) {
///       return Coil::Spec{.radius = in.quantity("radius_mm", positive), .turns = in.integer("turns", at_least(1))};
///     });
///
/// Each accessor throws InputError as Node does, and also if a required key is missing; a key of the same quantity with
/// another unit is then named as the mistake (`unknown key "gap_m"; did you mean "gap_mm"?`).
class ObjectReader {
 public:
  /// Reads `node`. Throws InputError if it is not an object.
  explicit ObjectReader(Node node);

  /// The value under a required key; where it is to be one of `words`, its absence is told with them.
  [[nodiscard]] Node at(std::string_view key, std::span<const std::string_view> words = {});
  /// The value under an optional key.
  [[nodiscard]] std::optional<Node> find(std::string_view key);
  /// The value under an optional key; null counts as absent.
  [[nodiscard]] std::optional<Node> find_not_null(std::string_view key);
  /// The value under the key, or under one that differs from it only in the unit: "h_m" if "h_mm" is requested.
  [[nodiscard]] std::optional<Node> find_in_any_unit(std::string_view key);
  /// The same for a required key.
  [[nodiscard]] Node at_in_any_unit(std::string_view key);
  /// The one key of `keys` that the object has. Throws if it has none or more than one.
  [[nodiscard]] std::string one_of(std::initializer_list<std::string_view> keys);

  /// A number as it is written.
  [[nodiscard]] double number(std::string_view key, const Rule& rule = finite) { return at(key).number(rule); }
  /// A number as it is written, or `otherwise` if the key is absent.
  [[nodiscard]] double number_or(std::string_view key, double otherwise, const Rule& rule = finite);
  /// A number in the unit of the key, returned in SI.
  [[nodiscard]] double quantity(std::string_view key, const Rule& rule = finite) { return at(key).quantity(rule); }
  /// A number in the unit of the key, returned in SI; `otherwise`, which is in SI, if the key is absent.
  [[nodiscard]] double quantity_or(std::string_view key, double otherwise, const Rule& rule = finite);
  /// A number as it is written, if the key exists.
  [[nodiscard]] std::optional<double> optional_number(std::string_view key, const Rule& rule = finite);
  /// A number in SI, if the key exists.
  [[nodiscard]] std::optional<double> optional_quantity(std::string_view key, const Rule& rule = finite);
  /// A whole number.
  template <class Integer = int>
  [[nodiscard]] Integer integer(std::string_view key, const Rule& rule = finite) {
    return at(key).integer<Integer>(rule);
  }
  /// A whole number, or `otherwise` if the key is absent.
  template <class Integer = int>
  [[nodiscard]] Integer integer_or(std::string_view key, Integer otherwise, const Rule& rule = finite) {
    const auto node = find(key);
    return node ? node->integer<Integer>(rule) : otherwise;
  }
  /// A text.
  [[nodiscard]] std::string text(std::string_view key) { return at(key).text(); }
  /// A text, or `otherwise` if the key is absent.
  [[nodiscard]] std::string text_or(std::string_view key, std::string otherwise);
  /// The Node::name() under "name"; empty if the key is absent.
  [[nodiscard]] std::string name();
  /// A path; a relative one counts from the folder of the document.
  [[nodiscard]] std::filesystem::path path(std::string_view key) { return at(key).path(); }
  /// Requires this text under the key: `{"format": "lumped-model/1"}`.
  void literal(std::string_view key, std::string_view expected);

  /// The value of one of the listed words.
  template <class Value>
  [[nodiscard]] Value choice(std::string_view key, std::initializer_list<std::pair<std::string_view, Value>> words) {
    std::vector<std::string_view> legal;
    for (const auto& [word, value] : words) legal.push_back(word);
    return at(key, legal).choice<Value>(words);
  }
  /// The value of one of the listed words, or `otherwise` if the key is absent.
  template <class Value>
  [[nodiscard]] Value choice_or(std::string_view key, Value otherwise,
                                std::initializer_list<std::pair<std::string_view, Value>> words) {
    const auto node = find(key);
    return node ? node->choice<Value>(words) : otherwise;
  }

  /// The elements of an array.
  [[nodiscard]] std::vector<Node> elements(std::string_view key, Length length = {}) {
    return at(key).elements(length);
  }
  /// The numbers of an array, as they are written.
  [[nodiscard]] std::vector<double> numbers(std::string_view key, Length length = {}, const Rule& rule = finite) {
    return at(key).numbers(length, rule);
  }
  /// The numbers of an array, in SI.
  [[nodiscard]] std::vector<double> quantities(std::string_view key, Length length = {}, const Rule& rule = finite) {
    return at(key).quantities(length, rule);
  }
  /// Three numbers, in SI.
  [[nodiscard]] std::array<double, 3> vector(std::string_view key, const Rule& rule = finite) {
    return at(key).vector(rule);
  }

  /// The object itself, for errors of the reader's own, and for keys that are names (claim these with at()).
  [[nodiscard]] const Node& node() const noexcept { return node_; }

  /// Throws InputError at the first key that was not requested, and suggests the one that was probably meant. Accepts a
  /// text under `comment_key`, and one under `schema_key` at the root of a document.
  void finish() const;

 private:
  // `legal`: the words of which it must be one, where there are such.
  [[nodiscard]] InputError missing(std::string_view key, std::span<const std::string_view> legal = {}) const;
  [[nodiscard]] InputError unknown(const std::string& key) const;

  Node node_;
  std::set<std::string, std::less<>> asked_for_;
};

/// Reads an object by `read(ObjectReader&)` and then calls finish(). A std::invalid_argument of a checking constructor
/// becomes an InputError at the object.
template <class Read>
auto read_object(const Node& node, Read&& read) {
  ObjectReader reader(node);
  try {
    if constexpr (std::is_void_v<decltype(read(reader))>) {
      std::forward<Read>(read)(reader);
      reader.finish();
    } else {
      auto result = std::forward<Read>(read)(reader);
      reader.finish();
      return result;
    }
  } catch (const std::invalid_argument& mistake) {
    throw node.error_without_value(mistake.what());
  }
}

}  // namespace coilwright::text
