#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace coilwright::text {

/// A JSON value to be written: keys stay in the order in which they were set, numbers are written with the fewest
/// digits that read back as the same double, and what is no JSON (NaN, Infinity, a key set twice) is refused.
///
///     auto result = Json::object({{"mass_g", 12.5}, {"binding", Json::array({"current_limit_A"})}});
///     result.set("joint_angles_deg", Json::numbers(angles));
class Json {
 public:
  /// A key and its value.
  using Member = std::pair<std::string, Json>;

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

  /// Throws std::invalid_argument when a key is there twice.
  [[nodiscard]] static Json object(std::vector<Member> members = {});
  /// An array of these elements.
  [[nodiscard]] static Json array(std::vector<Json> elements = {});
  /// An array of numbers.
  [[nodiscard]] static Json numbers(std::span<const double> values);

  /// Adds a member to an object. Throws std::invalid_argument when the key is there already.
  Json& set(std::string key, Json value);
  /// Adds an element to an array.
  Json& add(Json value);

  /// The JSON text: two spaces a level, an array of plain values on one line if it fits, a line end at the end.
  /// Text that is not UTF-8 has the replacement character in its place.
  /// Throws std::invalid_argument with the JSON pointer of a number that is not finite.
  [[nodiscard]] std::string text() const;

 private:
  friend class JsonText;
  using Array = std::vector<Json>;
  using Object = std::vector<Member>;
  std::variant<std::nullptr_t, bool, double, std::int64_t, std::string, Array, Object> content_;
};

}  // namespace coilwright::text
