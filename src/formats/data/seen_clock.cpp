#include "formats/data/seen_clock.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using Range = std::pair<double, double>;
// Days since 1900 of spreadsheets, since the year 0 of MATLAB, and of astronomers, in this age.
constexpr std::array<Range, 3> day_numbers = {Range{2e4, 8e4}, Range{6.9e5, 8e5}, Range{2.4e6, 2.5e6}};
constexpr double fastest_camera = 5e-4, slowest_camera = 0.5;  // s
constexpr double fastest_plain_sensor = 5e-5;                  // s; below, a slow clock in hours is as likely
constexpr double fastest_sensor = 5e-6;                        // s

constexpr std::array<std::string_view, 4> second_words = {"seconds", "secs", "sec", "s"};
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> part_words = {{{"nanoseconds", "ns"},
                                                                                       {"nanosecs", "ns"},
                                                                                       {"nanosec", "ns"},
                                                                                       {"nsecs", "ns"},
                                                                                       {"nsec", "ns"},
                                                                                       {"ns", "ns"},
                                                                                       {"microseconds", "us"},
                                                                                       {"usecs", "us"},
                                                                                       {"usec", "us"},
                                                                                       {"us", "us"},
                                                                                       {"msec", "ms"},
                                                                                       {"ms", "ms"}}};

bool is_whole(double value) {
  return value == std::floor(value);
}

double seconds_of(std::string_view suffix) {
  return units::to_si(1.0, *std::ranges::find(units::all_units(), suffix, &units::Unit::suffix));
}

// What stands before the word at the end of a name, in lower case; nothing where another word stands there.
std::optional<std::string> before(const std::string& name, std::string_view word) {
  std::string lower = name;
  std::ranges::transform(lower, lower.begin(), [](unsigned char letter) { return std::tolower(letter); });
  if (!lower.ends_with(word)) return std::nullopt;
  lower.resize(lower.size() - word.size());
  const bool in_a_word = !lower.empty() && std::isalpha(static_cast<unsigned char>(lower.back())) != 0;
  return in_a_word ? std::nullopt : std::optional(lower);
}

}  // namespace

std::vector<std::string_view> clock_units(const SeenColumn& column) {
  const std::vector<double>& values = column.values;
  const double first = values.empty() ? 0.0 : values.front();
  if (first > 1e17) return {"ns"};
  if (first > 1e14) return {"us"};
  if (first > 1e11) return {"ms"};
  const double step = values.size() > 1 ? (values.back() - first) / static_cast<double>(values.size() - 1) : 0.0;
  if (column.counts) return {};
  if (std::ranges::all_of(values, is_whole) && step >= 1.0 && first < 1e8)
    return {step > 100.0 ? std::string_view("us") : std::string_view("ms")};
  const bool day_number =
      std::ranges::any_of(day_numbers, [&](const Range& range) { return range.first < first && first < range.second; });
  if (day_number && step < fastest_camera) return {"day"};
  if (step >= fastest_plain_sensor || step <= 0.0) return {"s"};
  std::vector<std::string_view> out;
  if (step >= fastest_sensor) out.emplace_back("s");
  for (const std::string_view unit : {"min", "h", "day"})
    if (step * seconds_of(unit) > fastest_camera && step * seconds_of(unit) < slowest_camera) out.push_back(unit);
  return out.empty() ? std::vector<std::string_view>{"s"} : out;
}

std::optional<SplitClock> split_clock(std::span<SeenColumn> columns) {
  for (SeenColumn& seconds : columns)
    for (SeenColumn& part : columns)
      for (const std::string_view second : second_words)
        for (const auto& [word, unit] : part_words) {
          const auto name = before(seconds.source, second), other = before(part.source, word);
          if (&seconds == &part || !name || name != other || seconds.values.empty()) continue;
          const double size = seconds_of(unit);
          const auto is_part = [size](double value) { return value >= 0.0 && value * size < 1.0; };
          if (std::ranges::all_of(seconds.values, is_whole) && std::ranges::all_of(part.values, is_part))
            return SplitClock{.seconds = &seconds, .part = &part, .unit = unit};
        }
  return std::nullopt;
}

}  // namespace coilwright::formats
