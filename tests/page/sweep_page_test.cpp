#include <gmock/gmock.h>

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/page/pages.hpp"
#include "coilwright/text/json/document.hpp"
#include "temporary_folder.hpp"

namespace coilwright::page {
namespace {

using ::testing::ElementsAre;

constexpr const char* header =
    "gap_mm,turns_radial,wire_gauge_AWG,status,speed_deg_s,mass_g,mass_max_margin_g,reason\n";

// Of gap 0.8 with 12 turns no design keeps the limit.
constexpr const char* designs = R"(0.8,10,28,ok,100,60,6,
0.8,10,30,ok,120,62,4,
0.8,12,28,infeasible,300,70,-4,
0.8,12,30,failed,,,,no room
1,10,28,ok,90,58,8,
1,10,30,infeasible,200,67,-1,
1,12,28,ok,80,64,2,
1,12,30,ok,70,63,3,
)";

// The page of a sweep with these variables, and what else its result says.
Page page_of_sweep(const std::string& variables, const std::string& more = "") {
  const testing::TemporaryFolder folder;
  folder.file("result.json", R"({"command": "sweep", "study": "small", "objectives": [{"maximise": "speed_deg_s"},
    {"minimise": "mass_g"}], "designs": 8, "evaluated": 8, "ok": 5,
    "summary": {"title": "small", "verdict": "8 of 8 designs.", "cautions": [], "sections": []}, "best": [{"variables": )" +
                                 variables + "}]" + more + "}");
  folder.file("designs.csv", std::string(header) + designs);
  folder.file("best.csv", std::string("best_for,") + header + "speed_deg_s,0.8,10,30,ok,120,62,4,\n");
  return page_of(folder.path(), {});
}

constexpr const char* three = R"({"gap_mm": 0.8, "turns_radial": 10, "wire_gauge_AWG": 30})";

std::optional<text::Document> map_of(const Page& page) {
  const auto section = std::ranges::find(page.sections, "map", &Section::id);
  if (section == page.sections.end()) return std::nullopt;
  for (const Block& block : section->blocks)
    if (const auto* figure = std::get_if<Figure>(&block))
      return text::parse_json(std::get<text::Json>(figure->content).text(), "spec");
  return std::nullopt;
}

std::vector<std::string> options(const text::Node& spec, std::size_t param) {
  std::vector<std::string> out;
  const text::Node bind = spec.find("params").value().elements().at(param).find("bind").value();
  for (const text::Node& each : bind.find("options").value().elements()) out.push_back(each.text());
  return out;
}

std::vector<text::Node> rows_of(const text::Node& spec) {
  return spec.find("data").value().find("values").value().elements();
}

std::vector<std::optional<double>> column(const text::Node& row, const char* name) {
  std::vector<std::optional<double>> out;
  for (const text::Node& each : row.find(name).value().elements())
    out.push_back(each.is_null() ? std::nullopt : std::optional(each.number()));
  return out;
}

std::string mark_of(const text::Node& spec, std::size_t layer) {
  return spec.find("layer").value().elements().at(layer).find("mark").value().find("type").value().text();
}

TEST(SweepPage, MapsTheBestAtEachTwoValuesOfAGrid) {
  const auto document = map_of(page_of_sweep(three));
  ASSERT_TRUE(document);
  const text::Node spec = document->root();
  EXPECT_THAT(options(spec, 0),
              ElementsAre("gap_mm, turns_radial", "gap_mm, wire_gauge_AWG", "turns_radial, wire_gauge_AWG"));
  EXPECT_THAT(options(spec, 1), ElementsAre("speed_deg_s", "mass_g"));
  EXPECT_EQ(mark_of(spec, 1), "rect");
  const std::vector<text::Node> rows = rows_of(spec);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].find("_pair").value().text(), "gap_mm, turns_radial");
  EXPECT_THAT(column(rows[0], "_x"), ElementsAre(0.8, 0.8, 1.0, 1.0));
  EXPECT_THAT(column(rows[0], "_y"), ElementsAre(10.0, 12.0, 10.0, 12.0));
  EXPECT_THAT(column(rows[0], "speed_deg_s"), ElementsAre(120.0, std::nullopt, 90.0, 80.0));
  EXPECT_THAT(column(rows[0], "mass_g"), ElementsAre(60.0, std::nullopt, 58.0, 63.0));
}

TEST(SweepPage, MapsTheDesignsOfASampleAndSaysThatItIsOne) {
  const Page page = page_of_sweep(three, R"(, "sample": {"sampling": "latin_hypercube", "drawn": 9, "seed": 5})");
  const auto document = map_of(page);
  ASSERT_TRUE(document);
  EXPECT_EQ(options(document->root(), 0).size(), 3U);
  EXPECT_EQ(mark_of(document->root(), 1), "point");
  const std::vector<text::Node> rows = rows_of(document->root());
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_THAT(column(rows[0], "gap_mm"), ElementsAre(0.8, 0.8, 0.8, 1.0, 1.0, 1.0, 1.0));
  EXPECT_THAT(column(rows[0], "speed_deg_s"), ElementsAre(100.0, 120.0, 300.0, 90.0, 200.0, 80.0, 70.0));
  EXPECT_FALSE(rows[0].find("_keeps").value().elements().at(2).boolean());
}

TEST(SweepPage, HasNoMapOfOneVariable) {
  EXPECT_FALSE(map_of(page_of_sweep(R"({"gap_mm": 0.8})")));
}

}  // namespace
}  // namespace coilwright::page
