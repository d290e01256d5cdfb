#include <gmock/gmock.h>

#include <string>
#include <variant>

#include "coilwright/page/pages.hpp"
#include "coilwright/text/input_error.hpp"
#include "temporary_folder.hpp"

namespace coilwright::page {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* summary =
    R"({"title": "small: minimise p95_mass_g", "verdict": "The smallest one found is 67.", "cautions": ["MIND: so\n"],
  "sections": [{"id": "design", "title": "Best design", "blocks": [{"caption": "Variables", "header": ["variable", "value"],
                                                                    "rows": [["gap_mm", "1"]]}]},
               {"id": "limits", "title": "Limits", "blocks": [
                 {"id": "margins", "title": "Margins", "description": "How far.", "value_title": "margin, %",
                  "label_title": "limit", "symbols": false, "bars": [{"label": "mass_g <= 70", "value": 3.5, "group": "kept"}]}]},
               {"id": "convergence", "title": "The search", "blocks": ["The search ended because it converged.\n"]}]})";

// The page of an answer of `size` with this summary.
Page page_of_answer(const std::string& words) {
  const testing::TemporaryFolder folder;
  folder.file("result.json", R"({"command": "size", "study": "small", "objectives": [{"minimise": "p95_mass_g"}],
    "evaluations": {"ok": 1, "infeasible": 0, "failed": 0, "total": 1}, "best": {"variables": {"gap_mm": 1}})" +
                                 words + "}");
  folder.file("convergence.csv", "evaluation,best_p95_mass_g\n1,67\n");
  folder.file("evaluations.csv", "evaluation,status,p95_mass_g\n1,ok,67\n");
  return page_of(folder.path(), {});
}

TEST(SizingPage, SaysWhatTheSummarySaysAndDrawsItsCharts) {
  const Page page = page_of_answer(std::string(R"(, "summary": )") + summary);
  EXPECT_EQ(page.title, "small: minimise p95_mass_g");
  EXPECT_EQ(page.verdict, "The smallest one found is 67.");
  EXPECT_THAT(page.cautions, ElementsAre("MIND: so\n"));
  ASSERT_EQ(page.sections.size(), 3U);
  EXPECT_THAT(std::get<TableBlock>(page.sections[0].blocks.at(0)).table.rows, ElementsAre(ElementsAre("gap_mm", "1")));
  const Figure& margins = std::get<Figure>(page.sections[1].blocks.at(0));
  EXPECT_THAT(margins.table.rows, ElementsAre(ElementsAre("mass_g <= 70", "3.5", "kept")));
  EXPECT_EQ(std::get<Lines>(page.sections[2].blocks.at(0)).text, "The search ended because it converged.\n");
  EXPECT_EQ(std::get<Figure>(page.sections[2].blocks.at(1)).id, "search");
}

TEST(SizingPage, IsRefusedWithoutASummaryOrWithADamagedOne) {
  const auto refusal_of = [](const std::string& words) {
    try {
      (void)page_of_answer(words);
    } catch (const text::InputError& error) {
      return error.fault().place + ": " + error.fault().rule;
    }
    return std::string("nothing");
  };
  EXPECT_THAT(refusal_of(""), HasSubstr(R"(/: must have "summary" (docs/formats.md), which an earlier version did)"));
  std::string damaged = summary;
  damaged.replace(damaged.find("3.5"), 3, "\"x\"");
  EXPECT_THAT(refusal_of(R"(, "summary": )" + damaged), HasSubstr("/summary/sections/1/blocks/0/bars/0/value"));
}

}  // namespace
}  // namespace coilwright::page
