#include "sizing/study/early_limits.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>

#include "coilwright/sizing/study/design_problem.hpp"
#include "sizing/problem/design_space.hpp"
#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

using testing::quantity;

// Designs of every configuration, and currents of which some are too hot.
Study study_of(actuator::Wiring wiring) {
  Study study;
  study.name = "wide";
  study.current = VariedCurrent{};
  study.operating.duty = 0.5;
  study.operating.supply = {.wiring = wiring, .resistance = 0.3};
  study.variables = {configuration_variable({actuator::Configuration::A, actuator::Configuration::B,
                                             actuator::Configuration::C, actuator::Configuration::D}),
                     CurrentVariable{.range = Interval{.lower = 0.2, .upper = 2.0}},
                     ParameterVariable{.parameter = actuator::find_parameter("turns_radial"),
                                       .range = Interval{.lower = 4, .upper = 20}},
                     ParameterVariable{.parameter = actuator::find_parameter("turns_axial"),
                                       .range = Interval{.lower = 10, .upper = 40}},
                     ParameterVariable{.parameter = actuator::find_parameter("wire_gauge_AWG"),
                                       .range = Interval{.lower = 26, .upper = 34}}};
  study.objectives = {{.quantity = quantity("mass_g"), .sense = Sense::minimise}};
  return study;
}

std::vector<double> drawn_point(const Problem& problem, std::mt19937_64& random) {
  std::vector<double> point;
  for (const Variable& variable : problem.variables)
    point.push_back(nearest_legal(variable, std::uniform_real_distribution(variable.lower, variable.upper)(random)));
  return point;
}

bool is_told_early(Study study, const EvaluatedDesign& design, const Limit& limit) {
  study.limits.push_back(limit);
  const BreaksEarlyLimit breaks = early_limits(study);
  return breaks && breaks(design.design, design.point.current);
}

Limit limit_on(const simulation::ResultQuantity& asked, Limit::Side side, double value) {
  return {.quantity = asked, .side = side, .value = value};
}

// The full evaluation is the second route. A limit that it keeps is never broken early, whatever its quantity and side;
// with and without a limit on heat. Those of cold quantities are told on both sides.
TEST(EarlyLimits, BreakOnlyWhatTheEvaluationBreaks) {
  const std::set<std::string> exact{"mass_g",
                                    "width_mm",
                                    "height_mm",
                                    "coil_length_mm",
                                    "coil_outer_radius_mm",
                                    "effective_length_mm",
                                    "voltage_cold_V",
                                    "power_cold_W",
                                    "coil_resistance_Ohm",
                                    "current_over_limit",
                                    "supply_voltage_cold_V"};
  std::mt19937_64 random{20261130};
  std::size_t designs = 0, told = 0, cool = 0, hot_told = 0;
  for (const actuator::Wiring wiring : {actuator::Wiring::parallel, actuator::Wiring::series}) {
    const Study study = study_of(wiring);
    const DesignProblem problem(study);
    const Problem searched = problem.problem();
    for (int i = 0; i < 30; ++i) {
      const DesignResult result = problem.evaluate(drawn_point(searched, random));
      const auto* design = std::get_if<EvaluatedDesign>(&result);
      if (design == nullptr) continue;
      ++designs;
      Study within_heat = study;
      const std::optional<double> load = quantity("thermal_load").value(design->view());
      const bool is_cool = load && *load <= 1.0;
      cool += is_cool ? 1 : 0;
      within_heat.limits = {limit_on(quantity("thermal_load"), Limit::Side::at_most, 1.0)};
      for (const simulation::ResultQuantity& asked : simulation::standard_quantities()) {
        const std::optional<double> value = asked.value(design->view());
        if (!value || *value <= 0.0) continue;
        const Limit kept_above = limit_on(asked, Limit::Side::at_most, *value * 1.0001);
        const Limit kept_below = limit_on(asked, Limit::Side::at_least, *value * 0.9999);
        for (const Limit& kept : {kept_above, kept_below}) {
          EXPECT_FALSE(is_told_early(study, *design, kept)) << asked.name;
          EXPECT_FALSE(is_cool && is_told_early(within_heat, *design, kept)) << asked.name;
        }
        const Limit broken_above = limit_on(asked, Limit::Side::at_most, *value * 0.9999);
        const Limit broken_below = limit_on(asked, Limit::Side::at_least, *value * 1.0001);
        for (const Limit& broken : {broken_above, broken_below}) {
          const bool early = is_told_early(study, *design, broken);
          EXPECT_TRUE(early || !exact.contains(asked.name)) << asked.name;
          told += early ? 1 : 0;
        }
        if (asked.name == "voltage_V") {
          hot_told += is_told_early(study, *design, limit_on(asked, Limit::Side::at_most, *value * 0.6)) ? 1 : 0;
          hot_told += is_told_early(within_heat, *design, limit_on(asked, Limit::Side::at_least, *value * 1.7)) ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GE(designs, 30u);
  EXPECT_GE(cool, 10u);
  EXPECT_GE(told, 2 * exact.size() * designs);
  EXPECT_GE(hot_told, designs);
}

TEST(EarlyLimits, AreEmptyWithoutALimitThatCanBeToldEarly) {
  Study study = study_of(actuator::Wiring::parallel);
  study.limits = {limit_on(quantity("steady_angle_deg"), Limit::Side::at_least, 20.0)};
  EXPECT_FALSE(early_limits(study));
  EXPECT_FALSE(DesignProblem(study).problem().excluded);
}

// A program's own quantity under a standard name is another one.
TEST(EarlyLimits, LeaveAQuantityOfAnotherMeaningAlone) {
  Study study = study_of(actuator::Wiring::parallel);
  simulation::ResultQuantity own = quantity("mass_g");
  own.meaning = "mass of the whole actuator with its wires";
  study.limits = {limit_on(own, Limit::Side::at_most, 1.0)};
  EXPECT_FALSE(early_limits(study));
}

// A limit on current alone: the designs that are left out are those beyond it, of a current that follows the gauge too.
TEST(EarlyLimits, HoldForACurrentThatFollowsTheGauge) {
  Study study = study_of(actuator::Wiring::parallel);
  std::erase_if(study.variables, [](const StudyVariable& v) { return std::holds_alternative<CurrentVariable>(v); });
  study.limits = {limit_on(quantity("current_over_limit"), Limit::Side::at_most, 0.8)};
  for (const double share : {0.7, 0.9}) {
    study.current = ShareOfLimit{.share = share};
    const Problem problem = DesignProblem(study).problem();
    std::mt19937_64 random{7};
    for (int i = 0; i < 5; ++i) EXPECT_EQ(problem.excluded(drawn_point(problem, random)), share > 0.8);
  }
}

}  // namespace
}  // namespace coilwright::sizing
