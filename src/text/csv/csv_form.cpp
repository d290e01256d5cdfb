#include "coilwright/text/csv/csv_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/one_line.hpp"
#include "text/csv/csv_clock.hpp"
#include "text/csv/csv_fields.hpp"
#include "text/input_file.hpp"

namespace coilwright::text {
namespace {

constexpr std::size_t sampled_rows = 500;
constexpr std::size_t searched_lines = 400;  // at the end of what is seen, where no head is
constexpr std::array separators = {',', ';', '\t', '|', ' '};
constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

struct Line {
  std::string_view text;
  std::size_t number{};  // from 1
  std::size_t at{};      // its first byte
};

bool has_nothing(std::string_view line) {
  return line.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

// All lines that are complete and not skipped.
std::vector<Line> lines_of(std::string_view text, bool whole, std::size_t skip) {
  std::vector<Line> lines;
  std::size_t at = text.starts_with(utf8_mark) ? utf8_mark.size() : 0;
  for (std::size_t number = 1; at < text.size(); ++number) {
    std::size_t end = text.find_first_of("\r\n", at);
    if (end == std::string_view::npos) {
      if (!whole) break;
      end = text.size();
    }
    if (number > skip) lines.push_back({.text = text.substr(at, end - at), .number = number, .at = at});
    at = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
  }
  return lines;
}

bool is_number(std::string_view field, char separator) {
  return number_of(field, '.') || (separator != ',' && number_of(field, ',')) || stamp_in(field);
}

// Decimal commas stand between quotes where commas separate.
bool is_quoted_number(std::string_view line, std::string_view field) {
  return line.find('"') != std::string_view::npos && number_of(field, ',').has_value();
}

bool quotes_fit(std::string_view text) {
  return std::ranges::count(text, '"') % 2 == 0;
}

// What the last lines look like when they are cut at one separator.
struct Cut {
  char separator{','};
  std::size_t width{};
  std::vector<bool> numeric;  // columns that hold numbers, where they hold something
  std::vector<bool> blank;    // columns left of all numbers that hold hardly anything
  long score{};
};

Cut cut(const std::vector<Line>& lines, char separator) {
  struct Rows {
    std::vector<std::vector<std::string>> fields;  // of those that have a number
    std::size_t votes = 0;                         // one a line, and one more where it has a number
  };
  std::map<std::size_t, Rows> by_width;
  const std::size_t first = lines.size() > searched_lines ? lines.size() - searched_lines : 0;
  long score = 0;
  for (std::size_t i = first; i < lines.size(); ++i) {
    if (has_nothing(lines[i].text) || lines[i].text.starts_with('#') || !quotes_fit(lines[i].text)) continue;
    std::vector<std::string> fields = fields_of(lines[i].text, separator);
    bool has_number = false;
    for (const std::string& field : fields) {
      // Text alone tells nothing; digits in what is no number stand where a line is cut wrongly.
      const bool number = is_number(field, separator) || is_quoted_number(lines[i].text, field);
      has_number = has_number || number;
      if (number)
        ++score;
      else if (field.find_first_of("0123456789") != std::string::npos)
        --score;
    }
    Rows& rows = by_width[fields.size()];
    rows.votes += has_number ? 2 : 1;
    if (has_number) rows.fields.push_back(std::move(fields));
  }
  Cut out{.separator = separator, .width = 0, .numeric = {}, .blank = {}, .score = score};
  std::size_t most = 0;
  for (const auto& [width, rows] : by_width)
    if (rows.votes >= most) {
      most = rows.votes;
      out.width = width;
    }
  for (std::size_t column = 0; column < out.width; ++column) {
    std::size_t numbers = 0, filled = 0;
    const auto& rows = by_width[out.width].fields;
    for (const auto& row : rows) {
      filled += is_absent(row[column]) ? 0 : 1;
      numbers += is_number(row[column], separator) || number_of(row[column], ',') ? 1 : 0;
    }
    const bool leads = std::ranges::find(out.numeric, true) == out.numeric.end();
    out.numeric.push_back(numbers > 0 && 2 * numbers >= filled);
    out.blank.push_back(leads && numbers == 0 && 2 * filled < rows.size());
  }
  return out;
}

// The separator under which most of what stands in the last lines is a number.
Cut best_cut(const std::vector<Line>& lines, const CsvLayout& layout) {
  if (layout.separator) return cut(lines, *layout.separator);
  std::optional<Cut> best;
  for (const char separator : separators) {
    Cut each = cut(lines, separator);
    if (!best || each.score > best->score) best = std::move(each);
  }
  return *best;
}

// The lines before the rows; those that quotes join are one, and have the number of the last.
std::vector<NamesLine> lines_above(std::string_view text, std::vector<Line>::const_iterator line,
                                   std::vector<Line>::const_iterator end) {
  constexpr std::ptrdiff_t most_joined = 40;
  std::vector<NamesLine> above;
  for (; line != end; ++line) {
    auto last = line;
    const auto joined = [&] { return text.substr(line->at, last->at + last->text.size() - line->at); };
    if (!line->text.starts_with('#'))
      while (!quotes_fit(joined()) && last + 1 != end && last - line < most_joined) ++last;
    if (!quotes_fit(joined())) last = line;
    above.push_back({.text = joined(), .number = last->number});
    line = last;
  }
  return above;
}

char most_fields(std::string_view line) {
  return *std::ranges::max_element(separators.begin(), separators.end() - 1, {},
                                   [&](char separator) { return fields_of(line, separator).size(); });
}

bool is_row(const std::vector<std::string>& fields, const Cut& form) {
  if (fields.size() != form.width) return false;
  std::size_t numbers = 0, columns = 0;
  for (std::size_t i = 0; i < form.width; ++i) {
    if (!form.numeric[i]) continue;
    ++columns;
    const bool number = is_number(fields[i], form.separator) || number_of(fields[i], ',');
    if (!number && !is_absent(fields[i])) return false;
    numbers += number ? 1 : 0;
  }
  return numbers > 0 && 3 * numbers >= columns;
}

bool names_a_setting(const std::vector<std::string>& fields, const Cut& form) {
  for (std::size_t i = 0; i < form.width; ++i)
    if (form.blank[i] && !is_absent(fields[i])) return true;
  return false;
}

bool names_columns(const std::vector<std::string>& fields, const Cut& form) {
  for (std::size_t i = 0; i < form.width; ++i)
    if (form.numeric[i] && (i >= fields.size() || is_absent(fields[i]) || is_number(fields[i], form.separator)))
      return false;
  return true;
}

// A comma among digits that may part thousands.
bool parts_thousands(std::string_view field) {
  const std::size_t comma = field.find(',');
  if (comma == std::string_view::npos) return false;
  if (field.starts_with('-') || field.starts_with('+')) return parts_thousands(field.substr(1));
  return comma >= 1 && comma <= 3 && field.front() != '0' && field.size() == comma + 4;
}

char decimal_of(const CsvForm& form, const std::string& file, const CsvLayout& layout) {
  if (layout.decimal) return *layout.decimal;
  bool comma = false, certain = false, point = false;
  std::string shown;
  for (const auto& row : form.sample)
    for (const std::string& field : row) {
      if (!number_of(field, '.') && number_of(field, ',')) {
        comma = true;
        certain = certain || !parts_thousands(field);
        shown = field;
      }
      point = point || (number_of(field, '.') && field.find('.') != std::string::npos);
    }
  if (!comma) return '.';
  // Between commas, decimal commas need quotes; so do thousands.
  if (form.separator == ',') return certain && !point ? ',' : '.';
  if (point || !certain)
    throw InputError({.file = file,
                      .place = fmt::format("line {}", form.rows_line),
                      .rule = "must have decimals that cannot be taken for thousands: write them with a point, and "
                              "thousands without a comma (dataset.json of a data set may say \"decimal\": \",\")",
                      .value = in_quotes(shown)});
  return ',';
}

// "t:1523,I:0.7", as a plotter of serial numbers takes them.
bool names_in_fields(const std::vector<std::string>& fields) {
  return !fields.empty() && std::ranges::all_of(fields, [](std::string_view field) {
    const std::size_t colon = field.find(':');
    return colon != std::string_view::npos && number_of(field.substr(colon + 1), '.');
  });
}

InputError not_text(const std::string& file, std::string rule) {
  return InputError({.file = file, .rule = std::move(rule)});
}

}  // namespace

bool CsvForm::is_empty(std::size_t column) const {
  return !sample.empty() && std::ranges::all_of(sample, [&](const std::vector<std::string>& row) {
    return column >= row.size() || row[column].empty();
  });
}

CsvForm find_csv_form(std::string_view text, bool whole, const std::string& file, const CsvLayout& layout) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw not_text(file, "must be UTF-8, and is UTF-16: save it anew as UTF-8 (\"CSV UTF-8\" of a spreadsheet)");
  if (text.starts_with("PK\x03\x04"))
    throw not_text(file, "must be text, and is a spreadsheet or an archive: export it as CSV");
  const std::vector<Line> lines = lines_of(text, whole, layout.skip_lines);
  const Cut form = best_cut(lines, layout);
  const auto is_data = [&](const Line& line) {
    return !has_nothing(line.text) && !line.text.starts_with('#') && is_row(fields_of(line.text, form.separator), form);
  };
  auto row = std::ranges::find_if(lines, is_data);
  // A setting with a number a column, above the names, as in LabVIEW's header. Beside the rows of an oscilloscope,
  // whose columns have no names, settings stand too.
  if (row != lines.end() && names_a_setting(fields_of(row->text, form.separator), form)) {
    const auto names = std::find_if(row, lines.end(), [&](const Line& line) {
      return !line.text.starts_with('#') && names_columns(fields_of(line.text, form.separator), form);
    });
    if (names != lines.end()) row = std::find_if(names, lines.end(), is_data);
  }
  if (row == lines.end() && text.find('\0') != std::string_view::npos)
    throw not_text(file, "must be text, and is binary: export it as CSV");
  CsvForm out{.separator = form.separator};
  if (row == lines.end() && !lines.empty() &&
      names_in_fields(fields_of(lines.back().text, most_fields(lines.back().text))))
    throw InputError({.file = file,
                      .place = fmt::format("line {}", lines.back().number),
                      .rule =
                          "has a name and a colon before each number: delete these in all lines, or have the logger "
                          "print the numbers alone",
                      .value = in_quotes(lines.back().text)});
  if (row == lines.end()) {
    // Rows that are none: the first line is taken for the names, and the next one says what is wrong.
    const auto first = std::ranges::find_if(
        lines, [](const Line& line) { return !has_nothing(line.text) && !line.text.starts_with('#'); });
    if (lines.size() < 2 && !whole)
      throw not_text(file, fmt::format("must have its names and first row within its first {} bytes: leave out columns",
                                       csv_form_size));
    if (first == lines.end()) throw not_text(file, "is empty: it must have a header");
    if (!layout.separator) out.separator = most_fields(first->text);
    for (const std::string& name : fields_of(first->text, out.separator)) out.names.push_back(in_utf8(name));
    out.names_line = first->number;
    if (std::next(first) != lines.end()) {
      out.rows_line = std::next(first)->number;
      out.rows_at = std::next(first)->at;
    }
    return out;
  }
  out.rows_line = row->number;
  out.rows_at = row->at;
  for (auto line = row; line != lines.end() && out.sample.size() < sampled_rows; ++line)
    if (is_data(*line)) out.sample.push_back(fields_of(line->text, form.separator));
  out.decimal = decimal_of(out, file, layout);
  out.arrows = without_arrow(row->text, form.separator) != row->text;
  const std::vector<NamesLine> above = lines_above(text, lines.begin(), row);
  ColumnNames names = find_names(above, form.width, form.separator);
  // R names its rows, and not the column of these names.
  if (names.names.size() + 1 == form.width && row->text.starts_with('"') && out.sample.size() > 1 &&
      !out.is_empty(form.width - 1))
    names.names.insert(names.names.begin(), std::string());
  out.names = names.names;
  out.names_line = names.line;
  for (std::size_t i = 0; i < names.first; ++i) out.preamble.emplace_back(above[i].text);
  // A separator at the end of the rows alone; or one column less than named, which no row has.
  while (!out.names.empty() && out.names.size() < form.width && out.is_empty(out.names.size()))
    out.names.emplace_back();
  if (out.names.empty()) out.names.resize(form.width);
  if (out.names.size() > form.width && out.sample.size() > 1) out.names.resize(form.width);
  return out;
}

CsvForm read_csv_form(const std::filesystem::path& path, const CsvLayout& layout) {
  InputFile file(path, csv_size_limit);
  std::string text(csv_form_size, '\0');
  text.resize(file.read(text).size());
  return find_csv_form(text, text.size() < csv_form_size, file.name(), layout);
}

}  // namespace coilwright::text
