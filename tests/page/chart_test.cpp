#include "coilwright/page/chart.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "coilwright/text/json/document.hpp"

namespace coilwright::page {
namespace {

Chart some_chart() {
  return {.id = "c",
          .title = "Title",
          .description = "What is seen",
          .x_title = "time, s",
          .y_title = "angle, deg",
          .series = {{.name = "first", .x = {0.1, 0.2, 0.7}, .y = {3.25, -1.0 / 3.0, 4.0}},
                     {.name = "seen", .x = {0.3}, .y = {2.0}, .mark = Mark::points},
                     {.name = "limit", .x = {}, .y = {5.5}, .mark = Mark::level}}};
}

text::Document spec_of(const Figure& figure) {
  return text::parse_json(std::get<text::Json>(figure.content).text(), "spec");
}

TEST(Chart, HasEveryNumberAsItIs) {
  const text::Document document = spec_of(figure_of(some_chart()));
  const std::vector<text::Node> rows = document.root().find("data").value().find("values").value().elements();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].find("x").value().numbers(), (std::vector<double>{0.1, 0.2, 0.7}));
  EXPECT_EQ(rows[0].find("y").value().numbers(), (std::vector<double>{3.25, -1.0 / 3.0, 4.0}));
  EXPECT_EQ(rows[1].find("y").value().numbers(), (std::vector<double>{2.0}));
}

// Each layer shows the series of one kind, and every kind that is there has a layer: a series without one is invisible.
TEST(Chart, HasALayerForEveryKindOfMark) {
  const text::Document document = spec_of(figure_of(some_chart()));
  std::string filters;
  int levels = 0;
  for (const text::Node& layer : document.root().find("layer").value().elements()) {
    if (const auto transform = layer.find("transform"))
      filters += transform->elements().at(0).find("filter").value().text() + ";";
    if (const auto data = layer.find("data"))
      levels += data->find("values").value().elements().at(0).find("y").value().number() == 5.5 ? 1 : 0;
  }
  EXPECT_EQ(filters, "datum.kind === 'line';datum.kind === 'points';");
  EXPECT_EQ(levels, 2);  // the line and its name
}

TEST(Chart, HasATableOfTheSameNumbers) {
  const Figure figure = figure_of(some_chart());
  ASSERT_EQ(figure.table.rows.size(), 5U);
  EXPECT_EQ(figure.table.rows[1], (std::vector<std::string>{"first", "0.2", "-0.333333"}));
  EXPECT_EQ(figure.table.rows[4], (std::vector<std::string>{"limit", "", "5.5"}));
  EXPECT_EQ(figure.table.note, "");
}

TEST(Chart, SaysWhereItsTableIsAChoice) {
  Chart chart = some_chart();
  chart.series = {{.name = "long", .x = {}, .y = {}}};
  for (int i = 0; i < 1000; ++i) {
    chart.series[0].x.push_back(i);
    chart.series[0].y.push_back(2 * i);
  }
  const Figure figure = figure_of(chart);
  EXPECT_EQ(figure.table.rows.size(), 334U);
  EXPECT_EQ(figure.table.note, "one row in 3 of 1000");
}

TEST(BarChart, HasEveryValueWithItsGroup) {
  const Figure figure = figure_of(BarChart{
      .id = "b",
      .title = "t",
      .description = "d",
      .value_title = "change",
      .label_title = "step",
      .bars = {{.label = "up", .value = 1.5, .group = "better"}, {.label = "down", .value = -2.5, .group = "worse"}}});
  const text::Document document = spec_of(figure);
  const std::vector<text::Node> rows = document.root().find("data").value().find("values").value().elements();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].find("value").value().number(), -2.5);
  EXPECT_EQ(rows[1].find("group").value().text(), "worse");
}

}  // namespace
}  // namespace coilwright::page
