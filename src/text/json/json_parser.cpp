#include "text/json/json_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <unordered_set>
#include <utility>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/json_pointer.hpp"
#include "coilwright/text/one_line.hpp"

namespace coilwright::text {
namespace {

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n');
  const std::size_t column = before.size() - (line_start == std::string_view::npos ? 0 : line_start + 1) + 1;
  return fmt::format("line {}, column {}", line, column);
}

// nlohmann's "[json.exception.parse_error.101] parse error at line 1, column 8: syntax error while parsing value -
// invalid literal; last read: '...'" without the parts that we say in our own way.
std::string essence(std::string_view message) {
  constexpr std::string_view column = "column ";
  const std::size_t place = message.find(column);
  const std::size_t start = place == std::string_view::npos ? place : message.find(": ", place);
  if (start != std::string_view::npos) message.remove_prefix(start + 2);
  const std::size_t last_read = message.find("; last read: '");
  if (last_read == std::string_view::npos) return std::string(message);
  std::string short_message(message.substr(0, last_read));
  const std::size_t expected = message.rfind("; expected ");
  if (expected != std::string_view::npos && expected > last_read) short_message += message.substr(expected);
  return short_message;
}

// Whether the word around `offset` is a way to write NaN or Infinity.
bool is_in_a_non_finite_number(std::string_view text, std::size_t offset) {
  const auto in_word = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  while (offset > 0 && in_word(text[offset - 1])) --offset;
  if (text[offset] == '+') ++offset;
  constexpr std::array<std::string_view, 6> words = {"NaN", "nan", "NAN", "Inf", "inf", "INF"};
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view word) { return text.substr(offset).starts_with(word); });
}

// What a hand that writes JSON now and then does where the parser stumbles; empty where it is nothing of that kind.
std::string_view usual_slip(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return {};
  if (text[offset] == '/') return R"( (JSON has no comments: write a text under the key "comment"))";
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool at_number = is_digit(text[offset]);
  while (at_number && offset > 0 && is_digit(text[offset - 1])) --offset;
  const std::size_t before = offset == 0 ? std::string_view::npos : text.find_last_not_of(" \t\r\n", offset - 1);
  if (before == std::string_view::npos || text[before] != ',') return {};
  if (at_number && before + 1 == offset && before > 0 && is_digit(text[before - 1]))
    return " (is a decimal written with a comma? JSON has a point)";
  if (text[offset] == '}' || text[offset] == ']') return " (a comma stands before it)";
  return {};
}

// Builds the value from nlohmann's events. The events rather than its own tree, because the tree silently keeps the
// last of two equal keys.
class Builder : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  [[nodiscard]] Json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { throw fail("must be JSON text"); }

  bool start_object(std::size_t) override { return open(Json::Object{}); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::Array{}); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    Level& level = levels_.back();
    level.key = value;
    if (!level.keys.insert(value).second) throw fail("duplicate key");
    return true;
  }

  // `position` counts the characters read, the offending one included.
  bool parse_error(std::size_t position, const std::string& last_token, const nlohmann::detail::exception& e) override {
    constexpr int number_overflow = 406;
    if (e.id == number_overflow) {
      const std::size_t open = levels_.size();
      throw InputError({.file = file_,
                        .place = open == 0 ? "/" : next_pointer(),
                        .rule = "must be a finite number (at most 1.8e308)",
                        .value = one_line(last_token)});
    }
    const std::size_t offset = position == 0 ? 0 : position - 1;
    std::string rule = fmt::format("is not JSON: {}{}", essence(e.what()), usual_slip(text_, offset));
    if (offset >= text_.size()) {
      rule = text_.empty() ? "is empty: it must hold a JSON value" : "ends before its JSON value is complete";
    } else if (is_in_a_non_finite_number(text_, offset)) {
      rule = "must be a finite number: JSON has no NaN and no Infinity";
    }
    throw InputError({.file = file_, .place = line_and_column(text_, offset), .rule = rule});
  }

 private:
  struct Level {
    Json* value;
    std::string key{};  // of the member that comes next, when the value is an object
    std::unordered_set<std::string> keys{};
  };

  std::string next_pointer() const {
    std::string pointer;
    for (const Level& level : levels_) {
      const auto* array = std::get_if<Json::Array>(&level.value->content());
      // On the way down, the element in progress is already the last of its array; at the end it comes next.
      const bool last = &level == &levels_.back();
      pointer += pointer_step(array ? std::to_string(array->size() - (last ? 0 : 1)) : level.key);
    }
    return pointer.empty() ? "/" : pointer;
  }

  InputError fail(std::string rule) const {
    return InputError({.file = file_, .place = next_pointer(), .rule = std::move(rule)});
  }

  // Makes room for the next value, null as yet.
  Json& next() {
    if (++count_ > json_value_limit) throw fail(fmt::format("must hold at most {} values", json_value_limit));
    if (levels_.empty()) return root_;
    Level& level = levels_.back();
    if (auto* array = std::get_if<Json::Array>(&level.value->content())) return array->emplace_back();
    return std::get<Json::Object>(level.value->content()).emplace_back(level.key, Json()).second;
  }

  template <class Value>
  bool add(Value value) {
    next().content() = std::move(value);
    return true;
  }

  template <class Container>
  bool open(Container empty) {
    if (levels_.size() == json_depth_limit) {
      throw fail(fmt::format("must be nested at most {} deep", json_depth_limit));
    }
    // The address stays good: the container around it grows only after this one is closed.
    Json& value = next();
    value.content() = std::move(empty);
    levels_.push_back({.value = &value});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::string& file_;
  Json root_;
  std::vector<Level> levels_;
  std::size_t count_{0};
};

}  // namespace

Json parse_json_value(std::string_view text, const std::string& file) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (text.size() > json_size_limit) {
    throw InputError({.file = file, .rule = fmt::format("must not be larger than {} MB", json_size_limit / 1'000'000)});
  }
  // Of a text in Latin letters every other byte of UTF-16 is NUL, with or without a byte order mark.
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
      (text.size() > 1 && (text[0] == '\0') != (text[1] == '\0')))
    throw InputError({.file = file,
                      .rule =
                          "must be UTF-8, and is UTF-16: save it anew as UTF-8 (in an editor, or by iconv -f UTF-16 "
                          "-t UTF-8)"});
  // nlohmann takes a NUL byte for the end of the text and would not see what comes after it.
  if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
    throw InputError({.file = file, .place = line_and_column(text, nul), .rule = "is not JSON: holds a NUL byte"});
  }
  Builder builder(text, file);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace coilwright::text
