#include "text/csv/csv_clock.hpp"

#include <cstdint>

#include "coilwright/text/number.hpp"
#include "text/csv/csv_fields.hpp"

namespace coilwright::text {
namespace {

constexpr double minute = 60.0;
constexpr double hour = 3600.0;
constexpr double day = 86400.0;
// Longer than any record. Beyond, a clock counts from a day in 1970, 1904 or at power-on, and its digits are needed.
constexpr double longest_record = 1e6;

bool is_digit(char letter) {
  return letter >= '0' && letter <= '9';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

// What follows the time: the half of the day, or a zone, which does not matter to a difference.
std::optional<double> half_day(std::string_view rest, double hours) {
  rest = trimmed(rest);
  if (rest.empty() || rest == "Z" || rest == "UTC" || rest == "GMT") return 0.0;
  const bool morning = rest == "AM" || rest == "am", evening = rest == "PM" || rest == "pm";
  if (morning || evening) return ((evening ? 12.0 : 0.0) - (hours == 12.0 ? 12.0 : 0.0)) * hour;
  const bool zone = (rest.front() == '+' || rest.front() == '-') && rest.size() >= 3 &&
                    rest.find_first_not_of("0123456789:", 1) == std::string_view::npos;
  return zone ? std::optional(0.0) : std::nullopt;
}

}  // namespace

std::optional<Stamp> stamp_in(std::string_view field) {
  field = trimmed(field);
  const std::size_t colon = field.find(':');
  if (colon == std::string_view::npos || colon == 0 || !is_digit(field[colon - 1])) return std::nullopt;
  const std::size_t start = colon >= 2 && is_digit(field[colon - 2]) ? colon - 2 : colon - 1;
  std::string_view date = trimmed(field.substr(0, start));
  if (date.ends_with('T')) date.remove_suffix(1);
  if (!date.empty() && date.find_first_of("0123456789") == std::string_view::npos) return std::nullopt;
  std::string_view rest = field.substr(colon + 1);
  if (rest.size() < 2 || !is_digit(rest[0]) || !is_digit(rest[1])) return std::nullopt;
  // A number of one or two digits before, and two after each colon.
  const auto first = number_in(field.substr(start, colon - start));
  const auto second = number_in(rest.substr(0, 2));
  rest.remove_prefix(2);
  const bool three = rest.size() >= 3 && rest[0] == ':' && is_digit(rest[1]) && is_digit(rest[2]);
  const auto third = three ? number_in(rest.substr(1, 2)) : std::optional(0.0);
  if (three) rest.remove_prefix(3);
  double part = 0.0;
  const bool fraction = rest.size() >= 2 && (rest[0] == '.' || rest[0] == ',' || rest[0] == ':') && is_digit(rest[1]);
  if (fraction) {
    std::size_t end = 1;
    while (end < rest.size() && is_digit(rest[end])) ++end;
    const std::string digits = "0." + std::string(rest.substr(1, end - 1));
    part = number_of(digits, '.').value_or(0.0);
    rest.remove_prefix(end);
  }
  if (!first || !second || !third) return std::nullopt;
  if (!three && fraction)  // minutes and seconds, as spreadsheets show a short time
    return trimmed(rest).empty() ? std::optional(Stamp{std::string(date), *first * minute + *second + part})
                                 : std::nullopt;
  const auto half = half_day(rest, *first);
  if (!half || *second >= 60.0 || *third > 60.0) return std::nullopt;
  return Stamp{std::string(date), *first * hour + *half + *second * minute + *third + part};
}

CsvClock::CsvClock(const CsvHeader::Column& column, char decimal)
    : unit_(units::split_unit(column.name)->unit), factor_(column.factor), offset_(column.offset), decimal_(decimal) {}

std::optional<double> CsvClock::number(std::string_view field) {
  // A duration as MATLAB writes it.
  if (unit_.suffix == "s" && field.ends_with(" sec")) field.remove_suffix(4);
  const auto in_si = [&](double value) { return units::to_si(factor_ * value + offset_, unit_); };
  const auto value = number_of(field, decimal_);
  if (!value) return std::nullopt;
  if (!begun_ && in_si(*value) > longest_record) {
    origin_ = {.kind = ClockOrigin::Kind::number, .seconds = in_si(*value), .date = {}};
    first_ = *value;
  }
  if (origin_.kind == ClockOrigin::Kind::none) return in_si(*value);
  // 2021 in nanoseconds has more digits than a double: the whole numbers are subtracted first.
  double since = *value - first_;
  if (const auto exact = number_in<std::int64_t>(field)) {
    if (!begun_) whole_first_ = exact;
    if (whole_first_) since = static_cast<double>(*exact - *whole_first_);
  }
  return units::to_si(factor_ * since, unit_);
}

std::optional<double> CsvClock::take(std::string_view field) {
  field = trimmed(field);
  const auto stamp = begun_ && origin_.kind != ClockOrigin::Kind::day ? std::nullopt : stamp_in(field);
  if (!begun_ && stamp) origin_ = {.kind = ClockOrigin::Kind::day, .seconds = stamp->seconds, .date = stamp->date};
  if (origin_.kind != ClockOrigin::Kind::day) {
    const auto time = number(field);
    begun_ = begun_ || time;
    return time;
  }
  if (!stamp) return std::nullopt;
  // Without a date, a fall by half a day is midnight.
  const bool next_day =
      begun_ && (stamp->date.empty() ? stamp->seconds < second_of_day_ - day / 2.0 : stamp->date != date_);
  if (next_day) days_ += 1.0;
  begun_ = true;
  date_ = stamp->date;
  second_of_day_ = stamp->seconds;
  return stamp->seconds + days_ * day - origin_.seconds;
}

}  // namespace coilwright::text
