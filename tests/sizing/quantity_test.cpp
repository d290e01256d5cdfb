#include "coilwright/simulation/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "coilwright/sizing/design_problem.hpp"
#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

TEST(Quantities, HaveNamesOfTheirOwnAndEverythingAReportNeeds) {
  std::set<std::string_view> names;
  for (const simulation::Quantity& quantity : simulation::quantities()) {
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
    EXPECT_FALSE(quantity.meaning.empty()) << quantity.name;
    EXPECT_GT(quantity.scale, 0.0) << quantity.name;
    EXPECT_EQ(simulation::find_quantity(quantity.name), &quantity);
  }
  EXPECT_EQ(simulation::find_quantity("weight_g"), nullptr);
}

TEST(Quantities, ThatMayHaveNoValueSayWhy) {
  Study study = testing::small_study();
  study.variables = {CurrentVariable{.range = Choice{.values = {0.0, 5.0}}}};
  study.current = VariedCurrent{};
  study.duty = 1.0;
  study.base.surroundings.coil_limit = 20.0;  // below the ambient 25: no current at all may be held
  const DesignProblem problem(study);
  for (const double index : {0.0, 1.0}) {
    const auto design = std::get<EvaluatedDesign>(problem.evaluate(std::vector{index}));
    for (const simulation::Quantity& quantity : simulation::quantities())
      EXPECT_TRUE(quantity.get(design.candidate()) || !quantity.absence.empty()) << quantity.name;
  }
  const auto still = std::get<EvaluatedDesign>(problem.evaluate(std::vector{0.0}));
  EXPECT_EQ(simulation::find_quantity("rise_time_s")->get(still.candidate()), std::nullopt);
  EXPECT_EQ(simulation::find_quantity("thermal_load")->get(still.candidate()), std::nullopt);
}

TEST(Quantities, ScaleIsWithinTenfoldOfThePrototype) {
  // Scales weigh limits of zero against each other; an order of magnitude is all they must get right.
  const DesignProblem problem(testing::small_study());
  const auto base = std::get<EvaluatedDesign>(problem.evaluate_base());
  for (const simulation::Quantity& quantity : simulation::quantities()) {
    const std::optional<double> value = quantity.get(base.candidate());
    ASSERT_TRUE(value.has_value()) << quantity.name;
    EXPECT_LT(std::abs(std::log10(*value / quantity.scale)), 1.0) << quantity.name << " is " << *value;
  }
}

}  // namespace
}  // namespace coilwright::sizing
