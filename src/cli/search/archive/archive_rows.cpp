#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/search/archive/opened_archive.hpp"
#include "cli/search/commands.hpp"
#include "coilwright/formats/study/archive_results.hpp"
#include "coilwright/report/archive_text.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/spelling.hpp"

namespace coilwright::cli {
namespace {

struct ArchiveRowsOptions {
  std::string folder;
  std::string where;
  std::string most, least;  // columns
  std::optional<std::size_t> count{};
  std::string out;
  bool force{false};
  bool json{false};
};

void add_common_options(CLI::App& command, ArchiveRowsOptions& options) {
  add_archive_folder(command, options.folder);
  add_json_option(command, options.json);
}

void add_where(CLI::App& command, ArchiveRowsOptions& options, bool required) {
  command
      .add_option("--where", options.where,
                  "Condition in SQL over the columns of the archive: \"mass_g < 70 and status = 'ok'\"")
      ->required(required);
}

std::vector<std::string> columns_of(const archive::Contents& contents) {
  std::vector<std::string> names{"id", "run", "number", "status", "failure", "took_s"};
  for (const archive::Column& column : contents.columns) names.push_back(column.column);
  return names;
}

constexpr const char* condition_example = "; a condition is written as mass_g < 60 and status = 'ok'";

// SQLite's own words, and what may have been meant where they name a column that is none.
std::string complaint(std::string_view words, const archive::Contents& contents) {
  constexpr std::string_view unknown = "no such column: ";
  std::string text(words);
  if (!words.starts_with(unknown)) return text + condition_example;
  const std::string hint = text::did_you_mean(words.substr(unknown.size()), columns_of(contents));
  return text + (hint.empty() ? "; coilwright archive csv DIR has every column" : hint);
}

template <class Take>
void each_of(const archive::Reader& archive, const archive::Query& query, const std::string& option, const Take& take) {
  try {
    archive.each(query, take);
  } catch (const std::invalid_argument& mistake) {
    throw text::InputError(
        {.file = option, .place = {}, .rule = complaint(mistake.what(), archive.contents()), .value = {}});
  }
}

std::vector<archive::Row> rows_of(const archive::Reader& archive, const archive::Query& query,
                                  const std::string& option) {
  std::vector<archive::Row> rows;
  each_of(archive, query, option, [&](const archive::Row& row) { rows.push_back(row); });
  return rows;
}

void print(const archive::Reader& archive, const std::vector<archive::Row>& rows, const ArchiveRowsOptions& options,
           const std::string& further_column) {
  if (options.json)
    std::cout << formats::to_json(archive.contents(), rows).text();
  else
    std::cout << report::to_text(archive.contents(), rows, further_column);
}

void run_top(const ArchiveRowsOptions& options) {
  if (options.most.empty() == options.least.empty())
    throw text::InputError(
        {.file = "top", .place = {}, .rule = "needs --most or --least, one of the two", .value = {}});
  const archive::Reader archive = opened_archive(options.folder);
  const std::string& column = options.most.empty() ? options.least : options.most;
  const archive::Query query{.where = options.where.empty() ? "status = 'ok'" : options.where,
                             .order_by = column,
                             .descending = options.least.empty(),
                             .most = options.count.value_or(10)};
  // The column is asked about by itself, so that mistakes of the condition are not told of it.
  (void)rows_of(archive, {.order_by = column, .most = 0}, options.most.empty() ? "--least" : "--most");
  print(archive, rows_of(archive, query, "--where"), options, column);
}

}  // namespace

void add_archive_filter(CLI::App& command) {
  auto options = std::make_shared<ArchiveRowsOptions>();
  CLI::App* filter = command.add_subcommand("filter", "The designs that hold a condition");
  add_common_options(*filter, *options);
  add_where(*filter, *options, true);
  filter->footer(
      "Columns: the variables, every quantity, status (ok, infeasible, failed), failure, number (place in the order "
      "of\n"
      "the search), id (the row), took_s. A design without a value that the condition asks for does not hold it.\n\n"
      "Example:\n  coilwright archive filter results/fastest_finger --where \"mass_g < 60 and status = 'ok'\"");
  filter->callback([options] {
    const archive::Reader archive = opened_archive(options->folder);
    print(archive, rows_of(archive, {.where = options->where}, "--where"), *options, "");
  });
}

void add_archive_top(CLI::App& command) {
  auto options = std::make_shared<ArchiveRowsOptions>();
  CLI::App* top = command.add_subcommand("top", "The designs with the most or the least of a quantity");
  add_common_options(*top, *options);
  top->add_option("--most", options->most, "Column whose largest values come first");
  top->add_option("--least", options->least, "Column whose smallest values come first");
  add_whole_number(*top, "--count", options->count, text::Rule::between(1, 1e9), "Number of designs (default 10)");
  add_where(*top, *options, false);
  top->footer(
      "Without --where only designs that keep every limit.\n\n"
      "Example:\n  coilwright archive top results/fastest_finger --most peak_bending_speed_deg_s --count 5");
  top->callback([options] { run_top(*options); });
}

void add_archive_csv(CLI::App& command) {
  auto options = std::make_shared<ArchiveRowsOptions>();
  CLI::App* csv = command.add_subcommand("csv", "Every design with every quantity as CSV");
  add_archive_folder(*csv, options->folder);
  csv->add_option("--out", options->out, "File for the table; - is standard output (default -)")->default_str("-");
  add_where(*csv, *options, false);
  add_force_option(*csv, options->force);
  add_flag(*csv, "--json", options->json, "Print the designs as JSON, or with --out what was written");
  csv->footer("Example:\n  coilwright archive csv results/fastest_finger --out designs.csv");
  csv->callback([options] {
    const archive::Reader archive = opened_archive(options->folder);
    const bool to_file = !options->out.empty() && options->out != "-";
    if (options->json && !to_file) {
      print(archive, rows_of(archive, {.where = options->where}, "--where"), *options, "");
      return;
    }
    if (to_file) keep_inputs({archive.path()}, {options->out});
    text::OutputFile file(options->out.empty() ? "-" : options->out);
    formats::ArchiveTable table(file.stream(), archive.contents());
    each_of(archive, {.where = options->where}, "--where", [&](const archive::Row& row) { table.row(row); });
    keep_other_kind(file, table_mark, options->force);
    file.commit();
    if (options->json) std::cout << written_json({options->out}).text();
  });
}

}  // namespace coilwright::cli
