#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/text/variant.hpp"

namespace coilwright::text {

/// A JSON value, to be written or as it was read (Document, Node). Keys stay in the order in which they were set,
/// numbers are written with the fewest digits that read back as the same double, and invalid JSON (NaN, Infinity, a key
/// set twice) is refused.
///
///     auto result = Json::object({{"mass_g", 12.5}, {"binding", Json::array({"current_limit_A"})}});
///     result.set("joint_angles_deg", Json::numbers(angles));
class Json {
 public:
  /// A key and its value.
  using Member = std::pair<std::string, Json>;
  using Array = std::vector<Json>;     ///< elements of an array
  using Object = std::vector<Member>;  ///< in the order of the file
  /// The kinds of values. Numbers that were read are doubles.
  using Content = Variant<std::nullptr_t, bool, double, std::string, Array, Object, std::int64_t>;

  Json() : content_(nullptr) {}  ///< null
  /// A JSON value from a C++ value.
  ///@{
  Json(std::nullptr_t) : content_(nullptr) {}
  Json(std::same_as<bool> auto value) : content_(value) {}
  Json(double value) : content_(value) {}
  template <std::integral Integer>
  requires(!std::same_as<Integer, bool>) Json(Integer value) : content_(static_cast<std::int64_t>(value)) {}
  Json(std::string value) : content_(std::move(value)) {}
  Json(std::string_view value) : content_(std::string(value)) {}
  Json(const char* value) : content_(std::string(value)) {}
  ///@}
  /// The value, or null where there is none.
  template <class Value>
  Json(const std::optional<Value>& value) : content_(nullptr) {
    if (value) *this = Json(*value);
  }

  /// An object with these members. Throws std::invalid_argument if a key occurs twice.
  [[nodiscard]] static Json object(std::vector<Member> members = {});
  /// An array of these elements.
  [[nodiscard]] static Json array(std::vector<Json> elements = {});
  /// An array of numbers.
  [[nodiscard]] static Json numbers(std::span<const double> values);
  /// An array of the results of `of` for each element of a range.
  template <std::ranges::input_range Range, class Of = std::identity>
  [[nodiscard]] static Json list(const Range& range, Of of = {}) {
    Json out = array();
    for (const auto& each : range) out.add(Json(std::invoke(of, each)));
    return out;
  }
  /// A member with an SI value (a temperature: degrees Celsius) under a key that ends in its unit, converted to that
  /// unit.
  [[nodiscard]] static Member quantity(std::string key, double value);
  /// A member with several such values.
  [[nodiscard]] static Member quantities(std::string key, std::span<const double> values);

  /// Adds a member to an object. Throws std::invalid_argument if the object has the key.
  Json& set(std::string key, Json value);
  /// Adds a member made before: `set(Json::quantity("mass_g", mass))`.
  Json& set(Member member) { return set(std::move(member.first), std::move(member.second)); }
  /// Adds an element to an array.
  Json& add(Json value);

  [[nodiscard]] const Content& content() const noexcept { return content_; }  ///< The content of the value.
  [[nodiscard]] Content& content() noexcept { return content_; }  ///< The content of the value, which can be changed.

  /// The JSON text: two spaces for each level, an array of plain values on one line if it fits, a line end at the end.
  /// Text that is not UTF-8 is replaced by the replacement character. Throws std::invalid_argument with the JSON
  /// pointer of a number that is not finite.
  [[nodiscard]] std::string text() const;

 private:
  Content content_;
};

/// The number, or null if it is absent or not finite.
[[nodiscard]] Json number_or_null(const std::optional<double>& value);

/// The text, or null if it is empty.
[[nodiscard]] Json text_or_null(std::string_view text);

}  // namespace coilwright::text
