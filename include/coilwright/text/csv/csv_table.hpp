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

/// The columns of a CSV table, asked for as an ObjectReader is for its keys.
///
/// A column is named by its quantity and a unit, "theta1_deg"; any unit of the same dimension may stand there instead.
/// A time in whole seconds ("time_s") beside one of parts of a second ("time_ns") is one time, as ROS 2 writes it.
/// Throws InputError naming file, line, column and rule.
class CsvHeader {
 public:
  /// A column: of the file, or computed for each row.
  struct Column {
    /// Where its values come from.
    enum class From { field, row_number, markers };
    std::string name{};   ///< ours where the layout gives one, otherwise the file's
    std::string label{};  ///< as errors call it: the file's name too
    From from{From::field};
    std::size_t index{};  ///< of the field in a row, or of the markers in the layout
    double factor{1.0};   ///< as of CsvColumn
    double offset{0.0};
    double period{0.0};
    std::optional<std::size_t> part{};  ///< of whole seconds: the field that has the part of a second
    double part_unit{};                 ///< of that, s
  };

  /// `form` and `layout` must outlive the header.
  CsvHeader(std::string file, const CsvForm& form, const CsvLayout& layout);

  /// The column must be there.
  void require(std::string_view name);
  /// Whether the column is there.
  [[nodiscard]] bool find(std::string_view name);
  /// How many of the columns that `pattern` numbers are there, from 1 on without a gap: "theta#_deg" counts
  /// theta1_deg, theta2_deg, ...
  [[nodiscard]] std::size_t numbered(std::string_view pattern);
  /// Allows the column, or the numbered columns, without keeping their values. They must be numbers all the same.
  void ignore(std::string_view name);
  /// Allows rows that lack values of columns other than time: they are NaN in the table.
  void allow_gaps() noexcept { gaps_ = true; }
  /// Refuses the columns nobody asked for, with the one that was probably meant or all that may stand there. `advice`
  /// ends the message where none was meant: "; ...".
  void finish(std::string_view advice = {}) const;

  /// All but those that are left alone: what the layout ignores, and columns without a name or not asked for that have
  /// nothing in any row.
  [[nodiscard]] std::vector<std::string> names() const;
  /// What the layout names and the file does not have: sources of columns, points of markers, what is to be ignored,
  /// and "sampling_rate_Hz" where there is a column of time.
  [[nodiscard]] const std::vector<std::string>& absent() const noexcept { return absent_; }
  [[nodiscard]] const std::vector<Column>& columns() const noexcept { return columns_; }
  [[nodiscard]] const CsvForm& form() const noexcept { return *form_; }
  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  /// Whether the reader keeps the values of the column with this index.
  [[nodiscard]] bool keeps(std::size_t column) const { return kept_.contains(column); }
  /// Whether its fields must be numbers.
  [[nodiscard]] bool looks_at(std::size_t column) const { return known_.contains(column); }
  [[nodiscard]] bool gaps_allowed() const noexcept { return gaps_; }
  /// An error of the reader's own about the header as a whole.
  [[nodiscard]] InputError error(std::string rule) const;
  /// An error about one column of it.
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

/// What the times of a table count from.
struct ClockOrigin {
  /// Their own zero; a number beyond any record (seconds since 1970); midnight.
  enum class Kind { none, number, day };
  Kind kind{Kind::none};
  double seconds{};    ///< of the first row, from that zero
  std::string date{};  ///< of the first row, as it is written
};

/// The numbers of a CSV file, by column, in SI; NaN where gaps are allowed and a row has no value.
class CsvTable {
 public:
  [[nodiscard]] std::size_t rows() const noexcept { return lines_.size(); }
  /// The values of a quantity in SI: column("theta1") is in rad, also where the file says theta1_deg.
  /// Throws std::out_of_range when no such column was kept.
  [[nodiscard]] std::span<const double> column(std::string_view quantity) const;
  /// The name of that column, with the unit of the file: name("theta1") is "theta1_deg". Throws as column() does.
  [[nodiscard]] const std::string& name(std::string_view quantity) const { return names_[index_of(quantity)]; }
  /// Throws InputError where a value does not exceed the one before it, with what to do about it: rows that repeat a
  /// time, rows out of order, a clock that starts again. `of_records` and `of_rate` go on about the last and about a
  /// clock that is too coarse: " and ...".
  void require_increasing(std::string_view quantity, std::string_view of_records = {},
                          std::string_view of_rate = {}) const;
  /// What the column of time counts from.
  [[nodiscard]] const ClockOrigin& clock_origin() const noexcept { return clock_origin_; }
  /// An error at one value, for readers with rules of their own. Shows the value in the file's unit.
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
/// layout says) with names of its columns and at least one row of numbers. `ask` takes the columns it wants from the
/// header; finish() is called after it. Blank lines, and lines that begin with #, are skipped; fields of a column of
/// time may be dates and times. Throws InputError naming file, line, column and rule for everything that is not exactly
/// so, and all lines that are at fault where they are few.
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& path, const std::function<void(CsvHeader&)>& ask,
                                const CsvLayout& layout = {});

/// The same for a text in memory; `file` is the name its errors carry.
[[nodiscard]] CsvTable parse_csv(std::string_view text, std::string file, const std::function<void(CsvHeader&)>& ask,
                                 const CsvLayout& layout = {});

}  // namespace coilwright::text
