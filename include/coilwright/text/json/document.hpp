#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "coilwright/text/json/node.hpp"
#include "coilwright/text/variant.hpp"

namespace coilwright::text {

/// Bounds on a JSON input, far above any study and low enough that a wrong file is refused at once.
inline constexpr std::size_t json_size_limit = 16'000'000;  ///< bytes of text
inline constexpr std::size_t json_value_limit = 1'000'000;  ///< numbers, texts, arrays and objects together
inline constexpr std::size_t json_depth_limit = 64;         ///< arrays and objects inside each other

/// A value without parts.
using PlainValue = Variant<bool, double, std::string>;

/// A JSON text that has been read. Its nodes are valid as long as it lives.
class Document {
 public:
  ~Document();
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;

  /// The root value of the document.
  [[nodiscard]] Node root() const;
  /// A copy with other values at some JSON pointers (RFC 6901). Each must lead to a number, a text, true or false, or
  /// to a key that its object lacks. Throws std::invalid_argument if one does not.
  [[nodiscard]] Document with_values(const std::map<std::string, PlainValue>& values) const;

 private:
  struct Content;
  explicit Document(std::unique_ptr<const Content> content);
  friend Document parse_json(std::string_view text, std::string file);

  std::unique_ptr<const Content> content_;
};

/// Reads a JSON file strictly: UTF-8 (a byte order mark is skipped), no duplicate keys, no NaN or Infinity, no number
/// beyond a double, no comments, nothing after the value, and within the bounds above (the size is checked before
/// anything is read). Throws InputError.
[[nodiscard]] Document read_json(const std::filesystem::path& path);

/// Parses JSON from a text in memory; errors call it `file`.
[[nodiscard]] Document parse_json(std::string_view text, std::string file);

}  // namespace coilwright::text
