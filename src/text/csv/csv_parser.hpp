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

  /// How the text is cut, and where it begins.
  struct Cut {
    char separator{','};        ///< ' ': any number of blanks
    std::size_t first_line{1};  ///< number of its first line
    bool arrows{false};         ///< as of CsvForm
  };

  /// `file` is the name in errors.
  CsvParser(std::string file, OnRow on_row, Cut cut);
  /// The same of a whole file with commas; feed() also throws InputError for what is no text in UTF-8.
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
  void take_line(std::string_view line, bool complete);
  void feed_pieces();
  void feed_line(std::string_view line);
  void give_out_row();

  std::unique_ptr<State> state_;
};

}  // namespace coilwright::text
