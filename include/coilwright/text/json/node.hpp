#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/rule.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::text {

/// The number of elements that an array must have.
struct Length {
  std::size_t least{0};
  std::size_t most{std::numeric_limits<std::size_t>::max()};

  /// Makes a length of this many elements. @{
  [[nodiscard]] static constexpr Length exactly(std::size_t count) { return {.least = count, .most = count}; }
  [[nodiscard]] static constexpr Length at_least(std::size_t count) { return {.least = count}; }
  [[nodiscard]] static constexpr Length from_to(std::size_t least, std::size_t most) {
    return {.least = least, .most = most};
  }
  ///@}
};

/// One value of a JSON document, and its place. A light view, valid as long as the Document lives. Every accessor
/// throws InputError with file, JSON pointer, rule and value if the value is of another type or breaks the rule. Rules
/// are in the unit of the file.
class Node {
 public:
  /// The kinds of JSON values.
  enum class Kind { null, boolean, number, text, array, object };

  [[nodiscard]] Kind kind() const noexcept;
  /// The value itself.
  [[nodiscard]] const Json& value() const noexcept { return *value_; }
  [[nodiscard]] bool is_null() const noexcept { return kind() == Kind::null; }
  [[nodiscard]] const std::string& file() const noexcept { return *file_; }
  /// The place of the value by RFC 6901: `/variables/gap_mm/upper`; empty for the root.
  [[nodiscard]] const std::string& pointer() const noexcept { return pointer_; }
  /// The key of the value; elements of an array have the key of their array.
  [[nodiscard]] const std::string& key() const noexcept { return key_; }

  /// The value as a plain number, without a unit.
  [[nodiscard]] double number(const Rule& rule = finite) const;
  /// The value as a number in the unit at the end of key(), returned in SI. The key must end in a unit of
  /// units::all_units().
  [[nodiscard]] double quantity(const Rule& rule = finite) const;
  /// The value as a number in `unit`, returned in SI, for values whose unit stands in a key above them, as in
  /// {"gap_mm": {"lower": 2, "upper": 5}}.
  [[nodiscard]] double quantity_in(const units::Unit& unit, const Rule& rule = finite) const;
  /// The value as a whole number that fits the type (10 and 10.0 are whole, 10.5 is not).
  template <class Integer = int>
  [[nodiscard]] Integer integer(const Rule& rule = finite) const {
    return static_cast<Integer>(whole_number(rule, static_cast<double>(std::numeric_limits<Integer>::min()),
                                             static_cast<double>(std::numeric_limits<Integer>::max())));
  }
  /// true or false.
  [[nodiscard]] bool boolean() const;
  /// A text.
  [[nodiscard]] const std::string& text() const;
  /// The value as a name, which may be printed, name a file and stand in cells of tables: a text of one line without
  /// control characters that no spreadsheet takes for a formula.
  [[nodiscard]] const std::string& name() const;
  /// The value as a path, to which the rules of a name apply; a relative one counts from the folder of the document.
  [[nodiscard]] std::filesystem::path path() const;
  /// One of the listed words.
  template <class Value>
  [[nodiscard]] Value choice(std::initializer_list<std::pair<std::string_view, Value>> words) const {
    return choice_among<Value>(words);
  }
  /// One of the words of a table of std::pair<std::string_view, Value>.
  template <class Value, class Words>
  [[nodiscard]] Value choice_among(const Words& words) const {
    std::vector<std::string> legal;
    for (const auto& [word, value] : words) {
      if (kind() == Kind::text && text() == word) return value;
      legal.emplace_back(word);
    }
    throw wrong_word(legal);
  }

  /// The elements of an array.
  [[nodiscard]] std::vector<Node> elements(Length length = {}) const;
  /// The elements of an array of numbers, each as number() gives it.
  [[nodiscard]] std::vector<double> numbers(Length length = {}, const Rule& rule = finite) const;
  /// The elements of an array of quantities, each as quantity() gives it.
  [[nodiscard]] std::vector<double> quantities(Length length = {}, const Rule& rule = finite) const;
  /// Three numbers in the unit of the key, in SI.
  [[nodiscard]] std::array<double, 3> vector(const Rule& rule = finite) const;

  /// The keys of an object, in the order of the file.
  [[nodiscard]] std::vector<std::string> keys() const;
  /// The values of an object, in the order of the file, for objects whose keys are names.
  [[nodiscard]] std::vector<Node> members() const;
  /// The value under `key` of an object; absent if there is none.
  [[nodiscard]] std::optional<Node> find(std::string_view key) const;
  /// Throws if the value is not an object.
  void expect_object() const;

  /// An error at this place that shows the value, for a reader with rules of its own.
  [[nodiscard]] InputError error(std::string rule) const;
  /// An error at this place that shows no value: `/coil: needs one of "current_A", "voltage_V"`.
  [[nodiscard]] InputError error_without_value(std::string rule) const;
  /// The value as an error shows it: `1.5`, `text "abc"`, `an array`.
  [[nodiscard]] std::string shown() const;

 private:
  friend class Document;
  Node(const std::string& file, const Json& value, std::string pointer, std::string key);
  [[nodiscard]] Node child(const Json& value, std::string_view token, std::string key) const;
  [[nodiscard]] double whole_number(const Rule& rule, double lowest, double highest) const;
  [[nodiscard]] InputError wrong_word(const std::vector<std::string>& legal) const;

  const std::string* file_;
  const Json* value_;
  std::string pointer_;
  std::string key_;
};

}  // namespace coilwright::text
