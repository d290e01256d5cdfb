#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "coilwright/text/json/node.hpp"

namespace coilwright::text {

/// The key that tells an editor which JSON Schema a document follows. No reader uses it, and no writer writes it.
inline constexpr std::string_view schema_key = "$schema";

/// A key for people in any object: a text beside the numbers that it is about, JSON having no comments. No reader uses
/// it, and no writer writes it.
inline constexpr std::string_view comment_key = "comment";

/// Reads the keys of one JSON object, each asked for once, and at the end refuses the ones nobody asked for.
///
///     const auto coil = read_object(node, [](ObjectReader& in) {
///       return Coil::Spec{.radius = in.quantity("radius_mm", positive), .turns = in.integer("turns", at_least(1))};
///     });
///
/// Each accessor throws InputError as Node does, and also when a required key is missing: a key of the same quantity
/// with another unit is then named as the mistake (`unknown key "gap_m"; did you mean "gap_mm"?`).
class ObjectReader {
 public:
  /// Throws InputError when `node` is not an object.
  explicit ObjectReader(Node node);

  /// The value under a key that must be there.
  [[nodiscard]] Node at(std::string_view key);
  /// The value under a key that may be absent.
  [[nodiscard]] std::optional<Node> find(std::string_view key);
  /// The same, but null counts as absent.
  [[nodiscard]] std::optional<Node> find_not_null(std::string_view key);
  /// The value under the key, or under one that differs from it in the unit only: "h_m" where "h_mm" is asked for.
  [[nodiscard]] std::optional<Node> find_in_any_unit(std::string_view key);
  /// The same for a key that must be there.
  [[nodiscard]] Node at_in_any_unit(std::string_view key);
  /// The one key of `keys` that is there. Throws when none or more than one is.
  [[nodiscard]] std::string one_of(std::initializer_list<std::string_view> keys);

  /// A number as it is written.
  [[nodiscard]] double number(std::string_view key, const Rule& rule = finite) { return at(key).number(rule); }
  /// The same, or `otherwise` where the key is absent.
  [[nodiscard]] double number_or(std::string_view key, double otherwise, const Rule& rule = finite);
  /// In SI, the unit being the key's.
  [[nodiscard]] double quantity(std::string_view key, const Rule& rule = finite) { return at(key).quantity(rule); }
  /// `otherwise` is in SI.
  [[nodiscard]] double quantity_or(std::string_view key, double otherwise, const Rule& rule = finite);
  /// A number as it is written; nothing where the key is absent.
  [[nodiscard]] std::optional<double> optional_number(std::string_view key, const Rule& rule = finite);
  /// A number in SI; nothing where the key is absent.
  [[nodiscard]] std::optional<double> optional_quantity(std::string_view key, const Rule& rule = finite);
  /// A whole number.
  template <class Integer = int>
  [[nodiscard]] Integer integer(std::string_view key, const Rule& rule = finite) {
    return at(key).integer<Integer>(rule);
  }
  /// A whole number, or `otherwise` where the key is absent.
  template <class Integer = int>
  [[nodiscard]] Integer integer_or(std::string_view key, Integer otherwise, const Rule& rule = finite) {
    const auto node = find(key);
    return node ? node->integer<Integer>(rule) : otherwise;
  }
  /// A text.
  [[nodiscard]] std::string text(std::string_view key) { return at(key).text(); }
  /// A text, or `otherwise` where the key is absent.
  [[nodiscard]] std::string text_or(std::string_view key, std::string otherwise);
  /// The Node::name() under "name"; empty where the key is absent.
  [[nodiscard]] std::string name();
  /// A path; a relative one counts from the folder of the document.
  [[nodiscard]] std::filesystem::path path(std::string_view key) { return at(key).path(); }
  /// `{"format": "lumped-model/1"}`: the text must be this one.
  void literal(std::string_view key, std::string_view expected);

  /// The value of one of the listed words.
  template <class Value>
  [[nodiscard]] Value choice(std::string_view key, std::initializer_list<std::pair<std::string_view, Value>> words) {
    const auto node = find(key);
    if (node) return node->choice<Value>(words);
    std::vector<std::string> legal;
    for (const auto& [word, value] : words) legal.emplace_back(word);
    throw missing(key, legal);
  }
  /// The value of one of the listed words, or `otherwise` where the key is absent.
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

  /// The object itself: for errors of the reader's own, and for keys that are names (then claim them with at()).
  [[nodiscard]] const Node& node() const noexcept { return node_; }

  /// Throws InputError at the first key that was never asked for, suggesting the one that was probably meant. A text
  /// under `comment_key` is accepted, and one under `schema_key` at the root of a document.
  void finish() const;

 private:
  // `legal`: the words of which it must be one, where there are such.
  [[nodiscard]] InputError missing(std::string_view key, const std::vector<std::string>& legal = {}) const;
  [[nodiscard]] InputError unknown(const std::string& key) const;

  Node node_;
  std::set<std::string, std::less<>> asked_for_;
};

/// Reads an object by `read(ObjectReader&)` and then calls finish(). A std::invalid_argument out of a checking
/// constructor becomes an InputError at the object.
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
