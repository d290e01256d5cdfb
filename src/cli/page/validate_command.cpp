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
#include "coilwright/report/systems/comparison_text.hpp"
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
    const report::Document document = report::document_of(rows);
    if (*page)
      write_page(page::page_of(document, fmt::format("Page by {}.", results::made_by())), **page, {.force = *force});
    std::cout << (*json ? as_json(rows, outside == 0).text() : report::to_text(document));
    if (outside > 0) outcome.code = ExitCode::failure;
  });
}

}  // namespace coilwright::cli
