#include "formats/data/seen_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include "coilwright/text/number.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

bool looks_like_stamp(const std::string& field) {
  return std::ranges::count(field, ':') >= 1 && field.find_first_of("0123456789") != std::string::npos;
}

struct QuantityWords {
  Quantity quantity;
  std::string_view words;
};

// In lower case; a word is looked up as a whole.
constexpr std::array quantity_words = {
    QuantityWords{Quantity::time,
                  "t|time|times|timestamp|stamp|datetime|zeit|temps|tiempo|tempo|clock|millis|micros|elapsed|uhrzeit"},
    QuantityWords{Quantity::current, "current|i|strom|courant|corriente|corrente|icoil|curr|amps"},
    QuantityWords{Quantity::voltage, "voltage|u|spannung|vcoil|tension"},
    QuantityWords{Quantity::angle,
                  "angle|angles|winkel|theta|\xce\xb8|phi|\xcf\x86|alpha|\xce\xb1|bending|bend|rotation|pitch|angulo|"
                  "\xc3\xa1ngulo|encoder"},
    QuantityWords{Quantity::rate, "omega|\xcf\x89|gyro"},
    QuantityWords{Quantity::torque, "torque|drehmoment|moment"},
    QuantityWords{Quantity::force, "force|kraft|load"},
    QuantityWords{Quantity::temperature, "temperature|temp|temperatur"},
    QuantityWords{Quantity::duty, "duty|pwm"},
    QuantityWords{Quantity::position, "x|y"},
    QuantityWords{Quantity::other, "likelihood|score|confidence|frame|coords|index|sample|comment|track"}};

struct UnitWords {
  std::string_view suffix;
  std::string_view words;
};

constexpr std::string_view setpoint_words =
    "set|setpoint|target|command|commanded|cmd|desired|reference|ref|soll|sollwert";

// At the end of a name: units that are not ours, and readings before any scale.
constexpr std::string_view strange_words =
    "rev|revs|turn|turns|gon|cycles|raw|adc|ticks|steps|counts|lsb|frame|frames|picture|pictures|sample|samples|rows";

// As people write units, beside our suffixes.
constexpr std::array unit_words = {UnitWords{"s", "sec|secs|second|seconds|Sekunden"},
                                   UnitWords{"ms", "msec|millis|milliseconds"},
                                   UnitWords{"us", "\xc2\xb5s|\xce\xbcs|usec|micros|microseconds"},
                                   UnitWords{"ns", "nsec|nanosec|nanoseconds"},
                                   UnitWords{"min", "minute|minutes|Minuten"},
                                   UnitWords{"h", "hr|hrs|hour|hours|Stunden"},
                                   UnitWords{"day", "days|Tage"},
                                   UnitWords{"A", "amp|Amp|amps|Ampere|A."},
                                   UnitWords{"V", "Volt|volt|volts|Volts"},
                                   UnitWords{"deg", "\xc2\xb0|\xc2\xba|degree|degrees|Grad"},
                                   UnitWords{"deg_s", "deg/s|\xc2\xb0/s"},
                                   UnitWords{"rad_s", "rad/s"},
                                   UnitWords{"Nm", "N m|N*m"},
                                   UnitWords{"Nmm", "N mm"},
                                   UnitWords{"degC",
                                             "\xc2\xb0"
                                             "C|C"},
                                   UnitWords{"pct", "%|percent"}};

Quantity quantity_meant_by(std::string_view word) {
  for (const QuantityWords& each : quantity_words)
    if (text::is_one_of(word, each.words)) return each.quantity;
  return Quantity::none;
}

Quantity of_dimension(std::string_view suffix) {
  constexpr std::array<std::pair<std::string_view, Quantity>, 9> table = {{{"time", Quantity::time},
                                                                           {"current", Quantity::current},
                                                                           {"voltage", Quantity::voltage},
                                                                           {"angle", Quantity::angle},
                                                                           {"angular rate", Quantity::rate},
                                                                           {"torque", Quantity::torque},
                                                                           {"force", Quantity::force},
                                                                           {"temperature", Quantity::temperature},
                                                                           {"ratio", Quantity::duty}}};
  for (const units::Unit& unit : units::all_units())
    if (unit.suffix == suffix)
      for (const auto& [dimension, quantity] : table)
        if (unit.dimension == dimension) return quantity;
  return Quantity::none;
}

std::string_view suffix_of(std::string_view text) {
  for (const UnitWords& each : unit_words)
    if (text::is_one_of(text, each.words)) return each.suffix;
  const auto same = std::ranges::find(units::all_units(), text, &units::Unit::suffix);
  return same != units::all_units().end() && of_dimension(same->suffix) != Quantity::none ? same->suffix
                                                                                          : std::string_view{};
}

// What stands in the last brackets, if it is a short word as units are.
std::string word_in_brackets(std::string_view name) {
  constexpr std::size_t longest = 6;
  const std::size_t start = name.find_last_of("[({"), end = name.find_last_of("])}");
  if (start == std::string_view::npos || end == std::string_view::npos || end <= start + 1) return {};
  const std::string_view word = name.substr(start + 1, end - start - 1);
  const auto is_letter = [](char letter) { return std::isalpha(static_cast<unsigned char>(letter)) != 0; };
  return word.size() <= longest && std::ranges::all_of(word, is_letter) ? std::string(word) : std::string();
}

// The unit in brackets, or after a slash or "in", or at the end; `name` keeps what stands before it.
std::string unit_in(std::string_view& name) {
  const auto cut = [&](std::size_t start, std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    const std::string_view unit = suffix_of(text);
    if (!unit.empty()) name = name.substr(0, start);
    return std::string(unit);
  };
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')'), std::pair('{', '}')}) {
    const std::size_t start = name.rfind(open), end = name.rfind(close);
    if (start == std::string_view::npos || end == std::string_view::npos || end < start) continue;
    if (std::string unit = cut(start, name.substr(start + 1, end - start - 1)); !unit.empty()) return unit;
  }
  if (const auto split = units::split_unit(name); split && of_dimension(split->unit.suffix) != Quantity::none) {
    std::string unit(split->unit.suffix);
    name = split->quantity;
    return unit;
  }
  for (const std::string_view mark : {" / ", " in ", "_", " ", "/"}) {
    const std::size_t start = name.find(mark);
    if (start == std::string_view::npos || start == 0) continue;
    const std::size_t last = mark == "/" || mark == " / " ? start : name.rfind(mark);
    if (std::string unit = cut(last, name.substr(last + mark.size())); !unit.empty()) return unit;
  }
  return std::string(suffix_of(name));
}

std::vector<std::string> words_in(std::string_view name) {
  std::vector<std::string> words(1);
  bool was_digit = false;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool digit = std::isdigit(byte) != 0;
    const bool letters = byte >= 0x80 || std::isalpha(byte) != 0;
    if ((!letters && !digit) || (digit != was_digit && !words.back().empty())) words.emplace_back();
    if (letters || digit) words.back() += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
    was_digit = digit;
  }
  std::erase(words, std::string());
  return words;
}

}  // namespace

SeenColumn seen_column(const text::CsvForm& form, std::size_t column) {
  const std::string& name = form.names[column];
  const bool unique = !name.empty() && std::ranges::count(form.names, name) == 1;
  SeenColumn out{.source = unique ? name : fmt::format("#{}", column + 1), .words = words_of(name)};
  std::size_t filled = 0, stamps = 0;
  constexpr std::size_t sparse = 10;  // an instrument's settings stand beside its first rows
  for (const auto& row : form.sample) {
    if (column >= row.size() || row[column].empty()) continue;
    std::string field = row[column];
    ++filled;
    if (form.decimal == ',') std::ranges::replace(field, ',', '.');
    if (field.starts_with('+')) field.erase(0, 1);
    if (field.ends_with(" sec")) field.resize(field.size() - 4);  // a duration of MATLAB
    if (const auto value = text::number_in(field))
      out.values.push_back(*value);
    else if (looks_like_stamp(field))
      ++stamps;
  }
  out.stamps = 2 * stamps > filled;
  out.text = (!out.stamps && 2 * out.values.size() <= filled) || sparse * filled < form.sample.size();
  out.increases = out.values.size() > 1 && std::ranges::is_sorted(out.values) && out.values.front() < out.values.back();
  out.counts = out.ticks = out.values.size() > 2;
  for (std::size_t i = 1; i < out.values.size(); ++i) {
    out.counts = out.counts && out.values[i] == out.values[i - 1] + 1.0;
    out.ticks = out.ticks && out.values[i] > out.values[i - 1] && out.values[i] == std::floor(out.values[i]);
  }
  return out;
}

ColumnWords words_of(std::string_view name) {
  ColumnWords out;
  std::string_view rest = name;
  out.unit = unit_in(rest);
  if (out.unit.empty()) out.strange_unit = word_in_brackets(name);
  const std::vector<std::string> words = words_in(rest);
  // What instruments call the axis of time.
  if (words.size() > 1 && words[0] == "x" && (words[1] == "value" || words[1] == "axis")) out.quantity = Quantity::time;
  if (out.unit.empty() && !words.empty() && text::is_one_of(words.back(), strange_words))
    out.strange_unit = words.back();
  for (const std::string& word : words) {
    if (const auto number = text::number_in<int>(word)) {
      out.number = number;
      continue;
    }
    if (out.quantity == Quantity::none) out.quantity = quantity_meant_by(word);
    out.commanded = out.commanded || text::is_one_of(word, setpoint_words);
    if (word == "millis") out.unit = "ms";
    if (word == "micros") out.unit = "us";
  }
  const Quantity by_unit = of_dimension(out.unit);
  if (out.quantity == Quantity::none) {
    out.quantity = by_unit;
    out.by_unit = true;
  }
  if (by_unit == Quantity::none || by_unit == out.quantity) return out;
  // An angle in volts is what its sensor gave; all else with another unit is what that unit says: "T (degC)".
  if (out.quantity == Quantity::angle && by_unit == Quantity::voltage)
    out.unit.clear();
  else
    out.quantity = by_unit;
  return out;
}

}  // namespace coilwright::formats
