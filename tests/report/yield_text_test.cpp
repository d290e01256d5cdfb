#include "coilwright/report/yield_text.hpp"

#include <gmock/gmock.h>

#include <string>
#include <variant>
#include <vector>

namespace coilwright::report {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;

sizing::Yield built() {
  const sizing::Share share{.value = 0.93, .low = 0.92, .high = 0.94};
  return {.builds = 2000,
          .keeps_all = share,
          .quantities = {{.name = "mass_g", .nominal = 66.0, .p05 = 65.0, .p50 = 66.0, .p95 = 67.0},
                         {.name = "current_A",
                          .nominal = 0.8,
                          .p05 = 0.79,
                          .p50 = 0.8,
                          .p95 = 0.81,
                          .limit = "current_A <= 0.8014",
                          .keeps = share,
                          .asked = 0.99}}};
}

TEST(YieldText, ShowsBuildsBesideTheirLimits) {
  const Document document = document_of(built());
  EXPECT_THAT(document.cautions, ElementsAre("MIND: current_A <= 0.8014 is kept by 93 % (92 to 94), not by the 99 % "
                                             "that the study asks for.\n"));
  const Section& builds = document.sections.at(0);
  EXPECT_EQ(std::get<Lines>(builds.blocks.at(0)).text,
            "93 % (92 to 94) of 2000 builds by fresh dice keep every limit\n");
  // (0.8014 - 0.81) / 0.8014 is -1.073 %: 95 % of builds are below a current that breaks its limit.
  const BarChart& chart = std::get<BarChart>(builds.blocks.at(1));
  EXPECT_EQ(chart.bars.size(), 4U);  // an objective has no limit
  EXPECT_THAT(chart.bars, Contains(Field(&Bar::value, ::testing::DoubleNear(-1.07312, 1e-5))));
  EXPECT_THAT(std::get<TableBlock>(builds.blocks.at(2)).table.rows,
              ElementsAre(ElementsAre("mass_g", "66", "65", "66", "67", "", ""),
                          ElementsAre("current_A", "0.8", "0.79", "0.8", "0.81", "<= 0.8014", "93 % (92 to 94)")));
}

TEST(YieldText, RanksTheScattersOfEachQuantityByTheirShare) {
  sizing::Yield yield = built();
  const auto worth = [](std::string name, double share) {
    const std::vector<std::optional<sizing::SobolIndex>> index(2, sizing::SobolIndex{.value = share});
    return sizing::ScatterWorth{.scatter = std::move(name), .first = index, .total = index, .keeps_all = {}};
  };
  yield.worths = {worth("gap_mm", 0.2), worth("density", 0.7), worth("width_mm", 0.001)};
  const std::vector<Section> sections = builds_sections(yield);
  const BarChart& chart = std::get<BarChart>(sections.at(1).blocks.at(0));
  EXPECT_THAT(chart.title, HasSubstr("mass_g"));
  ASSERT_EQ(chart.bars.size(), 2U);
  EXPECT_EQ(chart.bars.front().label, "density");
}

}  // namespace
}  // namespace coilwright::report
