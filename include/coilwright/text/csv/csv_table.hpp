#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/input_error.hpp"

namespace coilwright::text {

/// Bounds on a CSV input.
inline constexpr std::size_t csv_size_limit = 512'000'000;  ///< bytes of text, which is never held as a whole
inline constexpr std::size_t csv_row_limit = 1'000'000;     ///< bytes of one row
inline constexpr std::size_t csv_value_limit = 20'000'000;  ///< numbers that are kept (160 MB)

/// The first line of a CSV table, asked for its columns as an ObjectReader is for its keys.
///
/// A column is named by its quantity and a unit, "theta1_deg"; any unit of the same dimension that measured-data/1
/// lists (_s _ms _A _V _N _Nm _Nmm _deg _rad _deg_s _rad_s _degC _m _mm) may stand there instead.
/// Throws InputError naming file, line, column and rule.
class CsvHeader {
 public:
  /// The names of the columns, as they stand in line `line` of `file`.
  CsvHeader(std::string file, std::size_t line, std::vector<std::string> names);

  /// The column must be there.
  void require(std::string_view name);
  /// Whether the column is there.
  [[nodiscard]] bool find(std::string_view name);
  /// How many of the columns that `pattern` numbers are there, from 1 on without a gap: "theta#_deg" counts
  /// theta1_deg, theta2_deg, ...
  [[nodiscard]] std::size_t numbered(std::string_view pattern);
  /// Allows the column, or the numbered columns, without keeping their values. They must be numbers all the same.
  void ignore(std::string_view name);
  /// Leaves a column alone, whatever is in it: it counts as absent, and its fields are not looked at. Its whole name;
  /// to be called before any column is asked for. False where there is no such column.
  bool leave_alone(std::string_view name);
  /// Refuses the columns nobody asked for, with the one that was probably meant or all that may stand there. `advice`
  /// ends the message where none was meant: "; ...".
  void finish(std::string_view advice = {}) const;

  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }
  /// Whether the reader keeps the values of the column with this index.
  [[nodiscard]] bool keeps(std::size_t column) const { return kept_.contains(column); }
  /// Whether its fields must not be looked at.
  [[nodiscard]] bool leaves_alone(std::size_t column) const { return left_alone_.contains(column); }
  /// An error of the reader's own about the header as a whole.
  [[nodiscard]] InputError error(std::string rule) const;
  /// An error about one column of it.
  [[nodiscard]] InputError error(std::string_view column, std::string rule) const;

 private:
  [[nodiscard]] std::size_t index_of(std::string_view name) const;
  bool ask(std::string_view name);

  std::string file_;
  std::size_t line_;
  std::vector<std::string> names_;
  std::vector<std::string> asked_for_{};
  std::vector<std::string> legal_{};  // as people read them: "theta1_deg.."
  std::set<std::size_t> known_{};
  std::set<std::size_t> kept_{};
  std::set<std::size_t> left_alone_{};
};

/// The numbers of a CSV file, by column, in SI.
class CsvTable {
 public:
  [[nodiscard]] std::size_t rows() const noexcept { return lines_.size(); }
  /// The values of a quantity in SI: column("theta1") is in rad, also where the file says theta1_deg.
  /// Throws std::out_of_range when no such column was kept.
  [[nodiscard]] std::span<const double> column(std::string_view quantity) const;
  /// The name of that column in the file: name("theta1") is "theta1_deg". Throws as column() does.
  [[nodiscard]] const std::string& name(std::string_view quantity) const { return names_[index_of(quantity)]; }
  /// Throws InputError at the first value that does not exceed the one before it.
  void require_increasing(std::string_view quantity) const;
  /// An error at one value, for readers with rules of their own. Shows the value in the file's unit.
  [[nodiscard]] InputError error(std::string_view quantity, std::size_t row, std::string rule) const;

 private:
  friend class CsvTableBuilder;
  [[nodiscard]] std::size_t index_of(std::string_view quantity) const;

  std::string file_;
  std::vector<std::string> names_;            // as the file has them; of the columns that are kept
  std::vector<std::vector<double>> columns_;  // SI
  std::vector<std::uint32_t> lines_;          // of each row in the file
};

/// Reads a CSV file (RFC 4180, with LF, CRLF or CR) with a header and at least one row of numbers. `ask` takes the
/// columns it wants from the header; finish() is called after it. Blank lines, and lines that begin with #, are
/// skipped. Throws InputError naming file, line, column and rule for everything that is not exactly so.
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& path, const std::function<void(CsvHeader&)>& ask);

/// The same for a text in memory; `file` is the name its errors carry.
[[nodiscard]] CsvTable parse_csv(std::string_view text, std::string file, const std::function<void(CsvHeader&)>& ask);

}  // namespace coilwright::text
