#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/page/commands.hpp"
#include "cli/page/page_output.hpp"
#include "cli/report_option.hpp"
#include "coilwright/page/pages.hpp"
#include "coilwright/results/page/page_file.hpp"
#include "coilwright/systems/validation/paper_comparison.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::cli {
namespace {

using systems::validation::Comparison;
using text::Json;

Json as_json(const std::vector<Comparison>& rows, bool all_hold) {
  Json list = Json::list(rows, [](const Comparison& row) {
    return Json::object({{"quantity", row.quantity},
                         {"source", row.source},
                         {"reference", row.reference},
                         {"model", row.model},
                         {"difference_pct", 100.0 * (row.ratio() - 1.0)},
                         {"band_pct", Json::array({100.0 * (row.band_low - 1.0), 100.0 * (row.band_high - 1.0)})},
                         {"holds", row.holds()},
                         {"because", row.because}});
  });
  return Json::object({{"holds", all_hold}, {"rows", std::move(list)}});
}

std::string as_table(const std::vector<Comparison>& rows) {
  std::string text = fmt::format("{:<42} {:>9} {:>9} {:>8} {:>15}    {:<32} {}\n", "quantity", "reference", "model",
                                 "diff %", "band %", "reference from", "the difference");
  for (const Comparison& row : rows)
    text += fmt::format("{:<42} {:>9.4g} {:>9.4g} {:>+8.2f} {:>+6.2f} .. {:>+5.2f} {:>2} {:<32} {}\n", row.quantity,
                        row.reference, row.model, 100.0 * (row.ratio() - 1.0), 100.0 * (row.band_low - 1.0),
                        100.0 * (row.band_high - 1.0), row.holds() ? "" : "!!", row.source, row.because);
  return text;
}

}  // namespace

void add_validate_command(CLI::App& app, Outcome& outcome) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = add_command(app, "validate");
  add_json_option(*command, *json);
  auto page = std::make_shared<std::optional<std::string>>();
  auto force = std::make_shared<bool>(false);
  add_report_file_option(*command, *page, *force);
  command->footer(
      "Each row has the band in which the difference must lie. The exit code is 1 if a difference lies outside\n"
      "its band.\n\n"
      "Example:\n"
      "  coilwright validate --json");
  command->callback([json, page, force, &outcome] {
    require_writable({page->value_or("")});
    const std::vector<Comparison> rows = systems::validation::compare_with_paper();
    const auto outside = std::ranges::count_if(rows, [](const Comparison& row) { return !row.holds(); });
    if (*page) write_page(page::comparison_page(rows, results::made_by()), **page, {.force = *force});
    if (*json)
      std::cout << as_json(rows, outside == 0).text();
    else
      std::cout << as_table(rows) << fmt::format("{} of {} within their bands\n", rows.size() - outside, rows.size());
    if (outside > 0) outcome.code = ExitCode::failure;
  });
}

}  // namespace coilwright::cli
