#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "coilwright/page/pages.hpp"
#include "coilwright/text/input_error.hpp"
#include "temporary_folder.hpp"

namespace coilwright::page {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* builds =
    R"({"builds": 2000, "not_built": 0, "keeps_all": {"share": 0.93, "low": 0.92, "high": 0.94},
  "quantities": [{"quantity": "mass_g", "nominal": 66, "p05": 65, "p50": 66, "p95": 67},
                 {"quantity": "current_A", "nominal": 0.8, "p05": 0.79, "p50": 0.8, "p95": 0.81, "limit": "current_A <= 0.8014",
                  "keeps": {"share": 0.93, "low": 0.92, "high": 0.94}, "asked": 0.99}], "scatters": []})";

// The page of an answer of `size` whose search converged, with what else its result says.
Page page_of_answer(const std::string& as_built, const std::string& stop_reason = "converged",
                    const std::string& operating_point = R"({"current_A": 0.8})") {
  const testing::TemporaryFolder folder;
  folder.file("result.json", R"({"command": "size", "study": "small", "objectives": [{"minimise": "p95_mass_g"}],
    "search_stop_reason": "converged", "stop_reason": ")" +
                                 stop_reason + R"(", "evaluations": {"ok": 1, "infeasible": 0, "failed": 0, "total": 1},
    "feasible": true, "best": {"variables": {"gap_mm": 1}, "objectives": {"p95_mass_g": 67}, "constraints": []},
    "binding": [], "steps": [], "assumptions": [], "as_built": )" +
                                 as_built + R"(, "operating_point": )" + operating_point + "}");
  folder.file("convergence.csv", "evaluation,best_p95_mass_g\n1,67\n");
  folder.file("evaluations.csv", "evaluation,status,p95_mass_g\n1,ok,67\n");
  return page_of(folder.path(), {});
}

const Section& builds_of(const Page& page) {
  return *std::ranges::find(page.sections, "builds", &Section::id);
}

TEST(SizingPage, SaysOfBuildsWhatSizeSays) {
  const Page page = page_of_answer(builds);
  EXPECT_EQ(std::get<Listing>(builds_of(page).blocks.at(0)).text,
            "93 % (92 to 94) of 2000 builds by fresh dice keep every limit\n"
            "  mass_g: 5 % of them stay below 65, half below 66, 95 % below 67\n");
  EXPECT_THAT(page.cautions, ElementsAre(HasSubstr("MIND: current_A <= 0.8014 is kept by 93 % (92 to 94), not by the "
                                                   "99 % that the study asks for.")));
}

TEST(SizingPage, ShowsBuildsAgainstTheirLimits) {
  const Page page = page_of_answer(builds);
  const Section& section = builds_of(page);
  const Figure& margins = std::get<Figure>(section.blocks.at(1));
  // (0.8014 - 0.81) / 0.8014 is -1.073 %: 95 % of builds are below a current that breaks its limit.
  EXPECT_THAT(margins.table.rows,
              ::testing::Contains(ElementsAre("current_A <= 0.8014", "-1.07312", HasSubstr("95 %"))));
  EXPECT_EQ(margins.table.rows.size(), 4U);  // an objective has no limit
  const Table& table = std::get<TableBlock>(section.blocks.at(2)).table;
  EXPECT_THAT(table.rows,
              ElementsAre(ElementsAre("mass_g", "66", "65", "66", "67", "", ""),
                          ElementsAre("current_A", "0.8", "0.79", "0.8", "0.81", "<= 0.8014", "93 (92 to 94)")));
  EXPECT_THAT(std::get<Paragraph>(section.blocks.at(3)).text, HasSubstr("coilwright yield"));
}

TEST(SizingPage, SaysWhyThereAreNoBuilds) {
  const Page page = page_of_answer("null", "interrupted");
  EXPECT_EQ(std::get<Paragraph>(builds_of(page).blocks.at(0)).text, "None were made: the run was interrupted.");
  EXPECT_THAT(page.cautions, ElementsAre(HasSubstr("INTERRUPTED when the search was over")));
}

TEST(SizingPage, RefusesBuildsAndAnOperatingPointThatCannotBe) {
  const auto refusal_of = [](const std::string& was, const std::string& is) {
    std::string damaged = builds;
    damaged.replace(damaged.find(was), was.size(), is);
    try {
      (void)page_of_answer(damaged);
    } catch (const text::InputError& error) {
      return error.fault().place + ": " + error.fault().rule;
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refusal_of(R"("builds": 2000)", R"("builds": 0)"), "/as_built/builds: must be >= 1");
  EXPECT_EQ(refusal_of(R"("not_built": 0)", R"("not_built": 2001)"), "/as_built/not_built: must be from 0 to 2000");
  EXPECT_EQ(refusal_of(R"("share": 0.93)", R"("share": -0.93)"), "/as_built/keeps_all/share: must be from 0 to 1");
  EXPECT_EQ(refusal_of(R"("high": 0.94)", R"("high": 0.9)"),
            "/as_built/keeps_all: must have a share from its low to its high");
  EXPECT_EQ(refusal_of(R"("asked": 0.99)", R"("asked": 99)"), "/as_built/quantities/1/asked: must be from 0 to 1");
  EXPECT_EQ(refusal_of(R"("nominal": 66, )", ""), "/as_built/quantities/0/nominal: is missing");
  EXPECT_THROW((void)page_of_answer(builds, "converged", "[]"), text::InputError);
}

}  // namespace
}  // namespace coilwright::page
