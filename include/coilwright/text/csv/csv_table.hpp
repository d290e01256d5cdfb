#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/csv/csv_form.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::text {

/// Bounds on a CSV input.
inline constexpr std::size_t csv_size_limit = 512'000'000;  ///< bytes of text, which is never held as a whole
inline constexpr std::size_t csv_row_limit = 1'000'000;     ///< bytes of one row
inline constexpr std::size_t csv_value_limit = 20'000'000;  ///< numbers that are kept (160 MB)

/// The columns of a CSV table, requested as the keys of an ObjectReader are.
///
/// A column is named by its quantity and a unit, "theta1_deg"; any unit of the same dimension may replace it. A time in
/// whole seconds ("time_s") beside one of parts of a second ("time_ns") is one time, as ROS 2 writes it. Throws
/// InputError naming file, line, column and rule.
class CsvHeader {
 public:
  /// A column: of the file, or computed for each row.
  struct Column {
    /// The source of the column's values.
    enum class From { field, row_number, markers };
    std::string name{};   ///< our name if the layout gives one, otherwise the file's
    std::string label{};  ///< name in errors, with the file's name
    From from{From::field};
    std::size_t index{};  ///< of the field in a row, or of the markers in the layout
    double factor{1.0};   ///< as in CsvColumn
    double offset{0.0};
    double period{0.0};
    std::optional<std::size_t> part{};  ///< for whole seconds the field that has the part of a second
    double part_unit{};                 ///< unit of that part, s
  };

  /// Reads the header. `form` and `layout` must outlive it.
  CsvHeader(std::string file, const CsvForm& form, const CsvLayout& layout);

  /// Requests a column that must exist.
  void require(std::string_view name);
  /// Requests a column; returns whether it exists.
  [[nodiscard]] bool find(std::string_view name);
  /// Requests the columns that `pattern` numbers from 1 on without a gap, and returns their number: "theta#_deg" counts
  /// theta1_deg, theta2_deg, ...
  [[nodiscard]] std::size_t numbered(std::string_view pattern);
  /// Allows the column, or the numbered columns, without keeping their values, which must still be numbers.
  void ignore(std::string_view name);
  /// Allows rows that lack values of columns other than time; these are NaN in the table.
  void allow_gaps() noexcept { gaps_ = true; }
  /// Refuses columns that were not requested, and names the one that was probably meant, or all that are allowed. If
  /// none was meant, `advice` ends the message: "; ...".
  void finish(std::string_view advice = {}) const;

  /// The names of all columns except ignored ones: those that the layout ignores, and columns without a name, or not
  /// requested, that are empty in every row.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Names in the layout that the file does not have: sources of columns, points of markers, columns to ignore, and
  /// "sampling_rate_Hz" if there is a column of time.
  [[nodiscard]] const std::vector<std::string>& absent() const noexcept { return absent_; }
  [[nodiscard]] const std::vector<Column>& columns() const noexcept { return columns_; }
  [[nodiscard]] const CsvForm& form() const noexcept { return *form_; }
  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  /// Whether the reader keeps the values of the column with this index.
  [[nodiscard]] bool keeps(std::size_t column) const { return kept_.contains(column); }
  /// Whether the fields of the column with this index must be numbers.
  [[nodiscard]] bool looks_at(std::size_t column) const { return known_.contains(column); }
  [[nodiscard]] bool gaps_allowed() const noexcept { return gaps_; }
  /// An error of the reader about the header as a whole.
  [[nodiscard]] InputError error(std::string rule) const;
  /// An error about one column of the header.
  [[nodiscard]] InputError error(std::string_view column, std::string rule) const;

 private:
  [[nodiscard]] std::size_t line() const;
  void map_columns(const CsvLayout& layout);
  void add_computed(const CsvLayout& layout);
  void join_clock();
  [[nodiscard]] std::optional<std::size_t> field_of(std::string_view source);
  [[nodiscard]] std::size_t index_of(std::string_view name) const;
  bool ask(std::string_view name);
  void refuse_nameless(std::string_view advice) const;

  std::string file_;
  const CsvForm* form_;
  bool others_ignored_{};
  bool gaps_{false};
  std::vector<Column> columns_{};
  std::vector<std::string> absent_{};
  std::vector<std::string> asked_for_{};
  std::vector<std::string> legal_{};  // as people read them: "theta1_deg.."
  std::set<std::size_t> known_{};
  std::set<std::size_t> kept_{};
  std::set<std::size_t> left_alone_{};
};

/// The zero from which the times of a table count.
struct ClockOrigin {
  /// The zero of the times: their own, a number beyond any record (seconds since 1970), or midnight.
  enum class Kind { none, number, day };
  Kind kind{Kind::none};
  double seconds{};    ///< of the first row, from that zero
  std::string date{};  ///< of the first row, as it is written
};

/// The numbers of a CSV file, by column, in SI; NaN for an allowed gap.
class CsvTable {
 public:
  [[nodiscard]] std::size_t rows() const noexcept { return lines_.size(); }
  /// The values of a quantity in SI: column("theta1") is in rad even if the file has theta1_deg. Throws
  /// std::out_of_range if no such column was kept.
  [[nodiscard]] std::span<const double> column(std::string_view quantity) const;
  /// The name of that column, with the unit of the file: name("theta1") is "theta1_deg". Throws as column() does.
  [[nodiscard]] const std::string& name(std::string_view quantity) const { return names_[index_of(quantity)]; }
  /// Throws InputError if a value does not exceed the one before it, with the cure: for rows that repeat a time, rows
  /// out of order, a clock that starts again. `of_records` and `of_rate` extend the message about the last, and about a
  /// clock that is too coarse: " and ...".
  void require_increasing(std::string_view quantity, std::string_view of_records = {},
                          std::string_view of_rate = {}) const;
  /// The zero from which the column of time counts.
  [[nodiscard]] const ClockOrigin& clock_origin() const noexcept { return clock_origin_; }
  /// An error at one value, for readers with rules of their own. It shows the value in the file's unit.
  [[nodiscard]] InputError error(std::string_view quantity, std::size_t row, std::string rule) const;

 private:
  friend class CsvTableBuilder;
  [[nodiscard]] std::size_t index_of(std::string_view quantity) const;

  std::string file_;
  ClockOrigin clock_origin_{};
  std::vector<std::string> names_;            // with the unit of the file; of the columns that are kept
  std::vector<std::string> labels_;           // of the same, for errors
  std::vector<std::vector<double>> columns_;  // SI
  std::vector<std::uint32_t> lines_;          // of each row in the file
};

/// Reads a CSV file (RFC 4180, with LF, CRLF or CR; other separators and decimal signs as CsvForm finds them or the
/// layout states) with names of its columns and at least one row of numbers. `ask` requests columns from the header;
/// finish() is called after it. Blank lines, and lines that begin with #, are skipped; fields of a column of time may
/// be dates and times. Throws InputError naming file, line, column and rule for any deviation, and all lines at fault
/// if they are few.
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& path, const std::function<void(CsvHeader&)>& ask,
                                const CsvLayout& layout = {});

/// Parses CSV from a text in memory; errors call it `file`.
[[nodiscard]] CsvTable parse_csv(std::string_view text, std::string file, const std::function<void(CsvHeader&)>& ask,
                                 const CsvLayout& layout = {});

}  // namespace coilwright::text
