#include "formats/data/column_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <utility>
#include <vector>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

struct Word {
  std::string_view word;
  Quantity quantity;
};

// In lower case; a word is looked up as a whole.
constexpr std::array quantity_words = {Word{"t", Quantity::time},
                                       Word{"time", Quantity::time},
                                       Word{"times", Quantity::time},
                                       Word{"timestamp", Quantity::time},
                                       Word{"stamp", Quantity::time},
                                       Word{"datetime", Quantity::time},
                                       Word{"zeit", Quantity::time},
                                       Word{"temps", Quantity::time},
                                       Word{"tiempo", Quantity::time},
                                       Word{"tempo", Quantity::time},
                                       Word{"clock", Quantity::time},
                                       Word{"millis", Quantity::time},
                                       Word{"micros", Quantity::time},
                                       Word{"elapsed", Quantity::time},
                                       Word{"uhrzeit", Quantity::time},
                                       Word{"current", Quantity::current},
                                       Word{"i", Quantity::current},
                                       Word{"strom", Quantity::current},
                                       Word{"courant", Quantity::current},
                                       Word{"corriente", Quantity::current},
                                       Word{"corrente", Quantity::current},
                                       Word{"icoil", Quantity::current},
                                       Word{"curr", Quantity::current},
                                       Word{"amps", Quantity::current},
                                       Word{"voltage", Quantity::voltage},
                                       Word{"u", Quantity::voltage},
                                       Word{"spannung", Quantity::voltage},
                                       Word{"vcoil", Quantity::voltage},
                                       Word{"tension", Quantity::voltage},
                                       Word{"angle", Quantity::angle},
                                       Word{"angles", Quantity::angle},
                                       Word{"winkel", Quantity::angle},
                                       Word{"theta", Quantity::angle},
                                       Word{"\xce\xb8", Quantity::angle},
                                       Word{"phi", Quantity::angle},
                                       Word{"\xcf\x86", Quantity::angle},
                                       Word{"alpha", Quantity::angle},
                                       Word{"\xce\xb1", Quantity::angle},
                                       Word{"bending", Quantity::angle},
                                       Word{"bend", Quantity::angle},
                                       Word{"rotation", Quantity::angle},
                                       Word{"pitch", Quantity::angle},
                                       Word{"angulo", Quantity::angle},
                                       Word{"\xc3\xa1ngulo", Quantity::angle},
                                       Word{"encoder", Quantity::angle},
                                       Word{"omega", Quantity::rate},
                                       Word{"\xcf\x89", Quantity::rate},
                                       Word{"gyro", Quantity::rate},
                                       Word{"torque", Quantity::torque},
                                       Word{"drehmoment", Quantity::torque},
                                       Word{"moment", Quantity::torque},
                                       Word{"force", Quantity::force},
                                       Word{"kraft", Quantity::force},
                                       Word{"load", Quantity::force},
                                       Word{"temperature", Quantity::temperature},
                                       Word{"temp", Quantity::temperature},
                                       Word{"temperatur", Quantity::temperature},
                                       Word{"duty", Quantity::duty},
                                       Word{"pwm", Quantity::duty},
                                       Word{"x", Quantity::position},
                                       Word{"y", Quantity::position},
                                       Word{"likelihood", Quantity::other},
                                       Word{"score", Quantity::other},
                                       Word{"confidence", Quantity::other},
                                       Word{"frame", Quantity::other},
                                       Word{"coords", Quantity::other},
                                       Word{"index", Quantity::other},
                                       Word{"sample", Quantity::other},
                                       Word{"comment", Quantity::other},
                                       Word{"track", Quantity::other}};

constexpr std::array<std::string_view, 11> setpoint_words = {
    "set", "setpoint", "target", "command", "commanded", "cmd", "desired", "reference", "ref", "soll", "sollwert"};

// At the end of a name: units that are not ours, and readings before any scale.
constexpr std::array<std::string_view, 12> strange_words = {"rev", "revs", "turn",  "turns", "gon",    "cycles",
                                                            "raw", "adc",  "ticks", "steps", "counts", "lsb"};

// As people write units, and as our names end in them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 56> unit_words = {{
    {"s", "s"},
    {"sec", "s"},
    {"secs", "s"},
    {"second", "s"},
    {"seconds", "s"},
    {"Sekunden", "s"},
    {"ms", "ms"},
    {"msec", "ms"},
    {"millis", "ms"},
    {"milliseconds", "ms"},
    {"us", "us"},
    {"\xc2\xb5s", "us"},
    {"\xce\xbcs", "us"},
    {"usec", "us"},
    {"micros", "us"},
    {"ns", "ns"},
    {"nsec", "ns"},
    {"A", "A"},
    {"amp", "A"},
    {"Amp", "A"},
    {"amps", "A"},
    {"Ampere", "A"},
    {"mA", "mA"},
    {"V", "V"},
    {"Volt", "V"},
    {"volt", "V"},
    {"volts", "V"},
    {"Volts", "V"},
    {"mV", "mV"},
    {"deg", "deg"},
    {"\xc2\xb0", "deg"},
    {"\xc2\xba", "deg"},
    {"degree", "deg"},
    {"degrees", "deg"},
    {"Grad", "deg"},
    {"rad", "rad"},
    {"mrad", "mrad"},
    {"deg/s", "deg_s"},
    {"\xc2\xb0/s", "deg_s"},
    {"rad/s", "rad_s"},
    {"N", "N"},
    {"mN", "mN"},
    {"Nm", "Nm"},
    {"N m", "Nm"},
    {"N*m", "Nm"},
    {"Nmm", "Nmm"},
    {"N mm", "Nmm"},
    {"mNm", "mNm"},
    {"\xc2\xb0"
     "C",
     "degC"},
    {"degC", "degC"},
    {"C", "degC"},
    {"K", "K"},
    {"%", "pct"},
    {"pct", "pct"},
    {"percent", "pct"},
    {"A.", "A"},
}};

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
  const auto found = std::ranges::find(unit_words, text, &std::pair<std::string_view, std::string_view>::first);
  if (found != unit_words.end()) return found->second;
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

ColumnWords words_of(std::string_view name) {
  ColumnWords out;
  std::string_view rest = name;
  out.unit = unit_in(rest);
  if (out.unit.empty()) out.strange_unit = word_in_brackets(name);
  const std::vector<std::string> words = words_in(rest);
  // What instruments call the axis of time.
  if (words.size() > 1 && words[0] == "x" && (words[1] == "value" || words[1] == "axis")) out.quantity = Quantity::time;
  if (out.unit.empty() && !words.empty() && std::ranges::find(strange_words, words.back()) != strange_words.end())
    out.strange_unit = words.back();
  for (const std::string& word : words) {
    int number{};
    const auto [stop, status] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (status == std::errc() && stop == word.data() + word.size()) {
      out.number = number;
      continue;
    }
    const auto found = std::ranges::find(quantity_words, word, &Word::word);
    if (found != quantity_words.end() && out.quantity == Quantity::none) out.quantity = found->quantity;
    out.commanded = out.commanded || std::ranges::find(setpoint_words, word) != setpoint_words.end();
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
