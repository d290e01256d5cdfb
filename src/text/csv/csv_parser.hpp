#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace coilwright::text {

/// Cuts CSV text, given piece by piece, into rows of fields. Holds one row at a time.
class CsvParser {
 public:
  /// Takes the fields of a row and the line it starts on (from 1).
  using OnRow = std::function<void(std::span<const std::string_view> fields, std::size_t line)>;

  /// `file` is the name in errors.
  CsvParser(std::string file, OnRow on_row);
  ~CsvParser();
  CsvParser(const CsvParser&) = delete;
  CsvParser& operator=(const CsvParser&) = delete;

  /// Throws InputError where quotes do not fit or a row is too long, and what on_row throws.
  void feed(std::string_view text);
  /// Ends the text: gives out the last row when no line end follows it.
  void finish();

 private:
  struct State;
  void feed_line(std::string_view line);
  void give_out_row();

  std::unique_ptr<State> state_;
};

}  // namespace coilwright::text
