#include "text/csv/csv_parser.hpp"

#include <csv.h>
#include <fmt/format.h>

#include <new>
#include <utility>
#include <vector>

#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/input_error.hpp"
#include "text/csv/csv_fields.hpp"

namespace coilwright::text {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// What a file is that is no text in UTF-8, and what to do; empty for text.
std::string_view no_text(std::string_view start) {
  if (start.starts_with("\xff\xfe") || start.starts_with("\xfe\xff"))
    return "must be UTF-8, and is UTF-16: save it anew as UTF-8 (\"CSV UTF-8\" of a spreadsheet)";
  if (start.starts_with("PK\x03\x04")) return "must be text, and is a spreadsheet or an archive: export it as CSV";
  if (start.find('\0') != std::string_view::npos) return "must be text, and is binary: export it as CSV";
  return {};
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

}  // namespace

struct CsvParser::State {
  std::string file;
  OnRow on_row;
  csv_parser parser{};
  Cut cut{};
  std::string pieces{};  // of a line that is not complete, where lines are changed before they are cut
  bool at_start{true};
  bool after_carriage_return{false};
  bool in_row{false};
  bool in_comment{false};
  bool at_line_start{true};
  bool row_complete{false};
  std::size_t line{1};
  std::size_t row_line{1};
  std::size_t row_bytes{0};
  std::string text{};               // the fields of the row, one after the other
  std::vector<std::size_t> ends{};  // where each ends in `text`
  std::vector<std::string_view> fields{};

  InputError error(std::string rule) const {
    return InputError({.file = file, .place = fmt::format("line {}", row_line), .rule = std::move(rule)});
  }

  // Called by libcsv, which is C: nothing may be thrown through it. The row is given out after it has returned.
  static void on_field(void* field, std::size_t size, void* self) noexcept {
    auto& state = *static_cast<State*>(self);
    state.text.append(static_cast<const char*>(field), size);
    state.ends.push_back(state.text.size());
  }
  static void on_row_end(int, void* self) noexcept { static_cast<State*>(self)->row_complete = true; }
};

CsvParser::CsvParser(std::string file, OnRow on_row) : CsvParser(std::move(file), std::move(on_row), Cut{}) {
  state_->at_start = true;
}

CsvParser::CsvParser(std::string file, OnRow on_row, Cut cut)
    : state_(std::make_unique<State>(State{.file = std::move(file),
                                           .on_row = std::move(on_row),
                                           .cut = cut,
                                           .at_start = false,  // its form has been found
                                           .line = cut.first_line,
                                           .row_line = cut.first_line})) {
  if (csv_init(&state_->parser, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
  csv_set_delim(&state_->parser, static_cast<unsigned char>(cut.separator == ' ' ? blank_cut : cut.separator));
}

CsvParser::~CsvParser() {
  csv_free(&state_->parser);
}

void CsvParser::feed(std::string_view text) {
  if (std::exchange(state_->at_start, false)) {
    if (const std::string_view rule = no_text(text); !rule.empty())
      throw InputError({.file = state_->file, .rule = std::string(rule)});
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  }
  // libcsv gets a line at a time, so that we know the number of the line it is in.
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\r\n");
    const bool ends_here = end != std::string_view::npos;
    const std::string_view line = text.substr(0, ends_here ? end + 1 : text.size());
    text.remove_prefix(line.size());
    const bool starts = std::exchange(state_->at_line_start, ends_here);
    if (starts && !state_->in_row && line.front() == '#') state_->in_comment = true;
    if (!state_->in_comment) take_line(line, ends_here);
    if (ends_here) state_->in_comment = false;
    // CR LF is one line end.
    const bool second_of_two = line == "\n" && state_->after_carriage_return;
    if (ends_here && !second_of_two) ++state_->line;
    state_->after_carriage_return = line.ends_with('\r');
  }
}

void CsvParser::take_line(std::string_view line, bool complete) {
  if (state_->cut.separator != ' ' && !state_->cut.arrows) return feed_line(line);
  state_->pieces.append(line);
  if (complete || state_->pieces.size() > csv_row_limit) feed_pieces();
}

void CsvParser::feed_pieces() {
  const std::string line = without_arrow(std::exchange(state_->pieces, {}), state_->cut.separator);
  feed_line(state_->cut.separator == ' ' ? cut_at_blanks(line) : line);
}

void CsvParser::feed_line(std::string_view line) {
  State& state = *state_;
  if (!state.in_row) {
    if (is_blank(line)) return;
    state.in_row = true;
    state.row_line = state.line;
    state.row_bytes = 0;
  }
  state.row_bytes += line.size();
  if (state.row_bytes > csv_row_limit) {
    throw state.error(fmt::format("must not be longer than {} MB (is a quote not closed?)", csv_row_limit / 1'000'000));
  }
  const std::size_t taken =
      csv_parse(&state.parser, line.data(), line.size(), &State::on_field, &State::on_row_end, &state);
  if (csv_error(&state.parser) == CSV_ENOMEM) throw std::bad_alloc();
  if (taken != line.size()) {
    throw state.error(
        "must have quotes around whole fields only, and quotes inside them doubled (delete the line if it is damaged)");
  }
  if (state.row_complete) give_out_row();
}

void CsvParser::finish() {
  State& state = *state_;
  if (!state.pieces.empty()) feed_pieces();
  if (csv_fini(&state.parser, &State::on_field, &State::on_row_end, &state) != 0) {
    throw state.error("must close the quote that it opens");
  }
  if (state.row_complete) give_out_row();
}

void CsvParser::give_out_row() {
  State& state = *state_;
  state.row_complete = false;
  state.in_row = false;
  state.fields.clear();
  std::size_t start = 0;
  for (const std::size_t end : state.ends) {
    state.fields.push_back(without_guard(std::string_view(state.text).substr(start, end - start)));
    start = end;
  }
  state.on_row(state.fields, state.row_line);
  state.text.clear();
  state.ends.clear();
}

}  // namespace coilwright::text
