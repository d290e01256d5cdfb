#include "coilwright/text/json/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "coilwright/units/unit.hpp"

namespace coilwright::text {

Json Json::object(std::vector<Member> members) {
  Json json;
  json.content_ = Object{};
  for (Member& member : members) json.set(std::move(member.first), std::move(member.second));
  return json;
}

Json Json::array(std::vector<Json> elements) {
  Json json;
  json.content_ = std::move(elements);
  return json;
}

Json Json::numbers(std::span<const double> values) {
  return array({values.begin(), values.end()});
}

Json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

Json text_or_null(std::string_view text) {
  return text.empty() ? Json() : Json(text);
}

Json::Member Json::quantity(std::string key, double value) {
  const double in_unit = units::from_memory(value, key);
  return {std::move(key), in_unit};
}

Json::Member Json::quantities(std::string key, std::span<const double> values) {
  Json list = Json::list(values, [&](double value) { return units::from_memory(value, key); });
  return {std::move(key), std::move(list)};
}

Json& Json::set(std::string key, Json value) {
  assert(std::holds_alternative<Object>(content_));
  auto& members = std::get<Object>(content_);
  const bool there = std::any_of(members.begin(), members.end(), [&](const Member& each) { return each.first == key; });
  if (there) throw std::invalid_argument(fmt::format("key {} must not be set twice", key));
  members.emplace_back(std::move(key), std::move(value));
  return *this;
}

Json& Json::add(Json value) {
  assert(std::holds_alternative<Array>(content_));
  std::get<Array>(content_).push_back(std::move(value));
  return *this;
}

namespace {

// Lays out a value. The layout is ours, because nlohmann puts every element of an array on a line of its own; how a
// number or a text is spelt is nlohmann's.
class JsonText {
 public:
  [[nodiscard]] std::string take() { return std::move(text_); }

  void write(const Json& json, const std::string& pointer, std::size_t indent) {
    if (const auto* array = std::get_if<Json::Array>(&json.content())) {
      write_array(*array, pointer, indent);
    } else if (const auto* object = std::get_if<Json::Object>(&json.content())) {
      write_object(*object, pointer, indent);
    } else {
      text_ += plain(json, pointer);
    }
  }

 private:
  static constexpr std::size_t longest_line = 120;

  static bool is_plain(const Json& json) {
    return !std::holds_alternative<Json::Array>(json.content()) &&
           !std::holds_alternative<Json::Object>(json.content());
  }

  static std::string spelt(const nlohmann::json& value) {
    return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }

  static std::string plain(const Json& json, const std::string& pointer) {
    if (const auto* number = std::get_if<double>(&json.content())) {
      if (!std::isfinite(*number))
        throw std::invalid_argument(fmt::format("{} must be finite; got {}", pointer, *number));
      return spelt(*number);
    }
    if (const auto* integer = std::get_if<std::int64_t>(&json.content())) return spelt(*integer);
    if (const auto* boolean = std::get_if<bool>(&json.content())) return spelt(*boolean);
    if (const auto* text = std::get_if<std::string>(&json.content())) return spelt(*text);
    return spelt(nullptr);
  }

  void new_line(std::size_t indent) { text_.append(1, '\n').append(indent, ' '); }

  void write_array(const Json::Array& array, const std::string& pointer, std::size_t indent) {
    if (std::all_of(array.begin(), array.end(), is_plain)) {
      std::string line;
      for (std::size_t i = 0; i < array.size(); ++i) {
        line += (i == 0 ? "" : ", ") + plain(array[i], fmt::format("{}/{}", pointer, i));
      }
      if (indent + line.size() <= longest_line) {
        text_ += "[" + line + "]";
        return;
      }
    }
    text_ += '[';
    for (std::size_t i = 0; i < array.size(); ++i) {
      if (i > 0) text_ += ',';
      new_line(indent + 2);
      write(array[i], fmt::format("{}/{}", pointer, i), indent + 2);
    }
    new_line(indent);
    text_ += ']';
  }

  void write_object(const Json::Object& object, const std::string& pointer, std::size_t indent) {
    if (object.empty()) {
      text_ += "{}";
      return;
    }
    text_ += '{';
    for (std::size_t i = 0; i < object.size(); ++i) {
      if (i > 0) text_ += ',';
      new_line(indent + 2);
      text_ += spelt(object[i].first) + ": ";
      write(object[i].second, pointer + "/" + object[i].first, indent + 2);
    }
    new_line(indent);
    text_ += '}';
  }

  std::string text_;
};

}  // namespace

std::string Json::text() const {
  JsonText writer;
  writer.write(*this, "", 0);
  return writer.take() + "\n";
}

}  // namespace coilwright::text
