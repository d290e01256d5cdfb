#include "page/result_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/page/chart.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "page/result_words.hpp"
#include "page/run_figures.hpp"

namespace coilwright::page {
namespace {

using text::Node;

// One channel of the proposed run, as next_experiment.csv has it.
struct Expected {
  std::string run;
  std::string channel;
  std::string axis;  // title of the x axis
  double noise{};
  std::vector<double> at;
  std::vector<std::vector<double>> values;  // of each explanation
};

// The columns that tell of what a row is; those behind them are the explanations.
constexpr std::array<std::string_view, 5> columns_of_place = {"run", "channel", "time_s", "angle_deg", "noise"};

std::vector<std::string> explanations_in(const text::CsvTexts& table) {
  const auto& names = table.names();
  if (names.size() <= columns_of_place.size() ||
      !std::ranges::equal(std::span(names).first(columns_of_place.size()), columns_of_place))
    throw table.error(
        fmt::format("must have the columns {}, and one for each explanation", fmt::join(columns_of_place, ", ")));
  return {names.begin() + static_cast<std::ptrdiff_t>(columns_of_place.size()), names.end()};
}

std::vector<Expected> expected_of(const text::CsvTexts& table, const std::vector<std::string>& explanations) {
  std::vector<Expected> out;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& run = table.column("run")[row];
    const std::string& channel = table.column("channel")[row];
    const std::optional<double> time = table.number("time_s", row);
    if (out.empty() || out.back().run != run || out.back().channel != channel)
      out.push_back({.run = run,
                     .channel = channel,
                     .axis = time ? "time, s" : "angle, deg",
                     .noise = table.required_number("noise", row),
                     .at = {},
                     .values = std::vector<std::vector<double>>(explanations.size())});
    out.back().at.push_back(time ? *time : table.required_number("angle_deg", row));
    for (std::size_t i = 0; i < explanations.size(); ++i)
      out.back().values[i].push_back(table.required_number(explanations[i], row));
  }
  return out;
}

Figure readings_figure(const Expected& expected, const std::vector<std::string>& explanations, std::size_t number) {
  const Thinning thinning(expected.at.size());
  Chart chart{.id = fmt::format("expected-{}", number),
              .title = fmt::format("{}: what each explanation expects", expected.run),
              .description = fmt::format("{} of the proposed run as each explanation that is left predicts it.{}",
                                         expected.channel, thinning.text()),
              .x_title = expected.axis,
              .y_title = expected.channel,
              .colour_order = explanations};
  for (std::size_t i = 0; i < explanations.size(); ++i)
    chart.series.push_back(
        {.name = explanations[i], .x = thinning.of(expected.at), .y = thinning.of(expected.values[i])});
  return figure_of(chart);
}

// In units of the noise where it is known, so that 1 is what a single reading can just show.
Figure difference_figure(const Expected& expected, const std::vector<std::string>& explanations, std::size_t number) {
  const Thinning thinning(expected.at.size());
  const double unit = expected.noise > 0.0 ? expected.noise : 1.0;
  Chart chart{
      .id = fmt::format("difference-{}", number),
      .title = fmt::format("{}: predicted difference to {}", expected.run, explanations.front()),
      .description = fmt::format("What each other explanation expects less what {} expects, {}.", explanations.front(),
                                 expected.noise > 0.0 ? fmt::format("in multiples of the noise of one reading, {} {}",
                                                                    short_number(expected.noise), expected.channel)
                                                      : "in the channel's own unit: its noise is not known"),
      .x_title = expected.axis,
      .y_title = expected.noise > 0.0 ? "difference, times the noise" : "difference, " + expected.channel,
      .colour_order = explanations};
  for (std::size_t i = 1; i < explanations.size(); ++i) {
    std::vector<double> difference;
    for (std::size_t k = 0; k < expected.at.size(); ++k)
      difference.push_back((expected.values[i][k] - expected.values[0][k]) / unit);
    chart.series.push_back({.name = explanations[i], .x = thinning.of(expected.at), .y = thinning.of(difference)});
  }
  return figure_of(chart);
}

std::vector<Figure> expected_figures(const std::filesystem::path& file) {
  const text::CsvTexts table = read_table(file);
  const std::vector<std::string> explanations = explanations_in(table);
  std::vector<Figure> figures;
  std::size_t number = 0;
  for (const Expected& each : expected_of(table, explanations)) {
    ++number;
    figures.push_back(readings_figure(each, explanations, number));
    if (explanations.size() > 1) figures.push_back(difference_figure(each, explanations, number));
  }
  return figures;
}

}  // namespace

void add_next_experiment(Page& page, const std::filesystem::path& folder, const Node& diagnosis) {
  const auto next = diagnosis.find("next_experiment");
  if (!next || next->is_null()) return;
  Section& section = section_named(page, "next", "What to do next");
  Table table{.header = {"", ""}};
  for (const Node& each : next->members())
    if (each.kind() != Node::Kind::object && each.kind() != Node::Kind::array)
      table.rows.push_back({each.key(), cell_of(each)});
  section.blocks.emplace_back(
      TableBlock{.caption = "The run that would separate the explanations", .table = std::move(table)});
  if (std::filesystem::is_regular_file(folder / "next_experiment.csv"))
    for (Figure& figure : expected_figures(folder / "next_experiment.csv"))
      section.blocks.emplace_back(std::move(figure));
}

}  // namespace coilwright::page
