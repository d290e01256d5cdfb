#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::text {

/// A date and time, or a time of day, as programs write them: "01/20/2021 10:11:32.002", "2021-01-20T10:11:32Z",
/// "10:11:32,002", "0:03 PM", "00:01.5" (minutes).
struct Stamp {
  std::string date{};  ///< what stands before the time, as it is
  double seconds{};    ///< since midnight
};

/// The stamp in a field; nothing where it is none.
[[nodiscard]] std::optional<Stamp> stamp_in(std::string_view field);

/// Reads a column of time, row by row.
class CsvClock {
 public:
  /// `column` is that of a CsvHeader.
  CsvClock(const CsvHeader::Column& column, char decimal);

  /// The time of the next row, s; nothing where the field is no time of the kind of the first.
  [[nodiscard]] std::optional<double> take(std::string_view field);
  /// What the times count from, when a row has been taken.
  [[nodiscard]] const ClockOrigin& origin() const noexcept { return origin_; }

 private:
  [[nodiscard]] std::optional<double> number(std::string_view field);

  units::Unit unit_;
  double factor_, offset_;
  char decimal_;
  bool begun_{false};
  double days_{0.0};
  std::string date_{};
  double second_of_day_{};
  double first_{0.0};  // in the file's unit, where the times count from it
  std::optional<std::int64_t> whole_first_{};
  ClockOrigin origin_{};
};

}  // namespace coilwright::text
