#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/units/unit.hpp"
#include "text/csv/csv_clock.hpp"

namespace coilwright::text {

/// Fills a CsvTable row by row.
class CsvTableBuilder {
 public:
  /// `form` and `layout` must outlive it. Throws what `ask` and CsvHeader throw, and InputError where no line has the
  /// names and no layout has positions.
  CsvTableBuilder(std::string file, const CsvForm& form, const CsvLayout& layout,
                  const std::function<void(CsvHeader&)>& ask);

  /// A row that is at fault is noted, and left out; one that repeats the names is left out.
  void take(std::span<const std::string_view> fields, std::size_t line);
  /// Throws InputError for the first row that is at fault, naming the others where they are few.
  [[nodiscard]] CsvTable finish();

 private:
  // Readings that may wrap.
  struct Unwrapped {
    double period{};  // 0: they do not
    std::optional<double> before{};
    double operator()(double value);
  };
  struct Column {
    CsvHeader::Column column;
    units::Unit unit;
    bool kept;
    bool time;
    Unwrapped unwrapped;
    double value{};  // of the row at hand, in SI
  };
  // What a point of markers is: two fields, or a place.
  struct Coordinate {
    std::optional<std::size_t> field{};
    double place{};
  };
  struct Markers {
    std::vector<Coordinate> coordinates;  // x and y of each point
    bool y_is_up;
  };

  void add_markers(const CsvForm& form, const CsvLayout& layout);
  void fill(Column& column, std::span<const std::string_view> fields, std::size_t line);
  [[nodiscard]] std::optional<double> time_of(const CsvHeader::Column& column,
                                              std::span<const std::string_view> fields);
  [[nodiscard]] double angle(const Markers& markers, std::span<const std::string_view> fields, std::size_t line) const;
  [[nodiscard]] InputError at_fault(std::size_t line, const std::string& label, std::string_view field) const;

  CsvTable table_;
  std::size_t width_;
  std::vector<std::string> names_;
  char decimal_;
  bool gaps_;
  std::vector<Column> columns_;
  std::vector<Markers> markers_;
  std::optional<CsvClock> clock_;
  std::optional<Fault> fault_;
  std::vector<std::size_t> fault_lines_;
  std::size_t rows_{0};
};

}  // namespace coilwright::text
