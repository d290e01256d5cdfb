#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "coilwright/sizing/study/spread.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/units/angle.hpp"
#include "sizing/small_study.hpp"

// Builds and their uses are two things: of what lasts each build is looked at in the worst of its uses.
namespace coilwright::sizing {
namespace {

using simulation::ResultQuantity;
using testing::quantity;

constexpr double degree = 1.0 / units::degrees_per_radian;

Scatter normal_part(const char* name, double relative_sd) {
  return {.name = name, .about = NormalDeviation{relative_sd}, .relative = true};
}

Scatter use(const char* name, double low, double high) {
  return {.name = name, .about = UniformDeviation{.low = low, .high = high}, .of_use = true};
}

Study study_of(std::vector<Scatter> scatters, double current) {
  Study study{.name = "one",
              .base = {},
              .current = FixedCurrent{current},
              .variables = {},
              .objectives = {},
              .limits = {},
              .search = {}};
  study.spread = Spread{.scatters = std::move(scatters)};
  return study;
}

void limit(Study& study, const ResultQuantity& what, double at_most) {
  study.limits.push_back({.quantity = what, .side = Limit::Side::at_most, .value = at_most});
}

EvaluatedDesign design_at(double current) {
  return simulation::evaluate(actuator::Design{}, {.current = current});
}

Yield yield_at(const Study& study, double current, std::size_t builds = 400) {
  return yield_of(study, design_at(current), {.builds = builds, .seed = 3, .threads = 2}).value();
}

// A quantity of every use that reads the operating point alone.
ResultQuantity made_up(std::function<double(const simulation::DesignView&)> value) {
  return simulation::of_every_use({.name = "made_up",
                                   .meaning = "for a test",
                                   .scale = 1.0,
                                   .value = [value = std::move(value)](const simulation::DesignView& design) {
                                     return std::optional(value(design));
                                   }});
}

double opening_of(const simulation::DesignView& design) {
  return design.point.grasp.opening / degree;
}

// A part of a finger in one use: deviations of the room, K, and place of the wall, deg.
EvaluatedDesign in_use(actuator::Design part, double current, double ambient, double opening) {
  part.surroundings.ambient += ambient;
  actuator::OperatingPoint point{.current = current};
  point.grasp.opening = opening * degree;
  return simulation::evaluate(std::move(part), point);
}

// Parts by dice of our own, and of each the worst of a grid of uses, without anything that makes builds: the share of
// 250 that keep two limits in every use. Both shares err by 0.04 together.
TEST(Uses, AreAllMetByEachBuild) {
  constexpr double current = 0.9;
  const ResultQuantity& load = quantity("thermal_load");
  const ResultQuantity& temperature = quantity("magnet_temperature_degC");
  const EvaluatedDesign worst = in_use({}, current, 5.0, 0.0);
  const double most_load = 1.01 * load.value(worst.view()).value();
  const double hottest = 1.03 * temperature.value(worst.view()).value();
  Study study = study_of({normal_part("remanence_T", 0.015), normal_part("heat_transfer_factor", 0.1),
                          normal_part("coil_resistance_factor", 0.05), use("ambient_degC", -5.0, 5.0),
                          use("grasp_opening_deg", 0.0, 25.0)},
                         current);
  limit(study, load, most_load);
  limit(study, temperature, hottest);
  const Yield yield = yield_at(study, current);

  std::mt19937_64 generator(11);
  std::normal_distribution<double> deviate;
  std::uniform_real_distribution<double> even;
  constexpr std::size_t builds = 250;
  std::size_t in_all = 0;
  std::size_t in_one = 0;
  for (std::size_t build = 0; build < builds; ++build) {
    actuator::Design part;
    part.magnet.remanence *= 1.0 + 0.015 * deviate(generator);
    part.calibration.heat_transfer *= 1.0 + 0.1 * deviate(generator);
    part.calibration.coil_resistance *= 1.0 + 0.05 * deviate(generator);
    const auto keeps_at = [&](double ambient, double opening) {
      const EvaluatedDesign used = in_use(part, current, ambient, opening);
      const std::optional<double> found = load.value(used.view());
      const std::optional<double> degrees = temperature.value(used.view());
      return found && degrees && *found <= most_load && *degrees <= hottest;
    };
    bool all = true;
    for (const double ambient : {-5.0, -2.5, 0.0, 2.5, 5.0})
      for (const double opening : {0.0, 8.0, 17.0, 25.0}) all = all && keeps_at(ambient, opening);
    in_all += all ? 1 : 0;
    const double ambient = 10.0 * even(generator) - 5.0;
    in_one += keeps_at(ambient, 25.0 * even(generator)) ? 1 : 0;
  }
  const double own = static_cast<double>(in_all) / builds;
  EXPECT_GT(own, 0.2);
  EXPECT_LT(own, 0.8);
  const double error = std::sqrt(own * (1.0 - own) * (1.0 / builds + 1.0 / static_cast<double>(yield.builds)));
  EXPECT_NEAR(yield.keeps_all.value, own, 3.0 * error);
  // What is drawn with the build is another promise.
  EXPECT_GT(static_cast<double>(in_one) / builds, own + 6.0 * error);
  EXPECT_EQ(yield.quantities[0].of_uses, 1.0);
}

// How long it is on belongs to a use: what lasts is of the longest one, and nothing is on for more than always.
TEST(Uses, DifferInTheirDuty) {
  constexpr double current = 0.9;
  const auto at_duty = [](double duty) { return simulation::evaluate({}, {.current = current, .duty = duty}); };
  const ResultQuantity& temperature = quantity("coil_hot_spot_degC");
  for (const auto& [designed, longest] : {std::pair{0.5, 0.7}, {0.9, 1.0}}) {
    SpreadQuantities of(
        {.scatters = {
             {.name = "duty", .about = UniformDeviation{.low = -0.2, .high = 0.2}, .of_use = is_of_use("duty")}}});
    const ResultQuantity worst = of.find("p95_coil_hot_spot_degC", simulation::standard_quantities()).value();
    const EvaluatedDesign design = at_duty(designed);
    const EvaluatedDesign hottest = at_duty(longest);
    // Builds have curves of 1e-4, which move a temperature by 5e-6 of itself.
    EXPECT_NEAR(worst.value(design.view()).value(), temperature.value(hottest.view()).value(), 1e-3) << designed;
  }
}

// Statistics of the builds of one design, by their names.
std::vector<double> statistics(std::vector<Scatter> scatters, const std::vector<const char*>& names) {
  SpreadQuantities of({.scatters = std::move(scatters)});
  std::vector<ResultQuantity> found;
  for (const char* name : names) found.push_back(of.find(name, simulation::standard_quantities()).value());
  const EvaluatedDesign design = design_at(0.9);
  std::vector<double> out;
  for (const ResultQuantity& each : found) out.push_back(each.value(design.view()).value());
  return out;
}

// The search's own figures are those of the same parts at the hot end. A finger has one speed in each use: its
// statistics are over both, unless the name asks for the worst.
TEST(Uses, GiveStatisticsOfTheWorstOfThem) {
  std::vector<Scatter> day{normal_part("remanence_T", 0.015), normal_part("heat_transfer_factor", 0.1),
                           use("ambient_degC", -5.0, 5.0)};
  std::vector<Scatter> hot = day;
  hot.back() = {.name = "ambient_degC", .about = UniformDeviation{.low = 5.0 - 1e-9, .high = 5.0}};
  const std::vector<const char*> names{"p95_thermal_load", "p95_magnet_temperature_degC",
                                       "p05_peak_bending_speed_deg_s", "mean_thermal_load"};
  const std::vector<double> of_day = statistics(day, names);
  const std::vector<double> of_hot = statistics(hot, names);
  EXPECT_NEAR(of_day[0], of_hot[0], 1e-6);
  EXPECT_NEAR(of_day[1], of_hot[1], 1e-5);
  const std::vector<double> worst = statistics(day, {"p05_worst_peak_bending_speed_deg_s"});
  EXPECT_NEAR(worst[0], of_hot[2], 1e-4 * of_hot[2]);
  day.back().of_use = false;
  const std::vector<double> drawn = statistics(day, names);
  EXPECT_EQ(of_day[2], drawn[2]);
  EXPECT_EQ(of_day[3], drawn[3]);
  EXPECT_LT(drawn[0], of_day[0]);
  SpreadQuantities of({.scatters = day});
  EXPECT_EQ(of.find("p95_worst_thermal_load", simulation::standard_quantities()), std::nullopt);  // it is that anyway
}

// What is 0 in the middle and at each end alone says nothing of where it is worst: all corners are looked at.
TEST(Uses, AreLookedForWhereTheDesignItselfShowsNothing) {
  Study study = study_of({use("grasp_opening_deg", 0.0, 20.0), use("current_A", -0.1, 0.1)}, 1.0);
  limit(study, made_up([](const simulation::DesignView& design) {
          return std::max(0.0, (20.0 - opening_of(design)) * (design.point.current - 1.0) - 1.9);
        }),
        0.05);
  const Yield yield = yield_at(study, 1.0, 20);
  EXPECT_EQ(yield.keeps_all.value, 0.0);
  EXPECT_NEAR(yield.quantities[0].p50.value(), 0.1, 1e-9);
}

// A law without ends: in the stated share of the uses, of two laws together.
TEST(Uses, OfALawWithoutEndsAreAShare) {
  const auto place = [](const simulation::DesignView& design) { return design.point.current; };
  const auto used = [](std::vector<Scatter> scatters, double share) {
    Study study = study_of(std::move(scatters), 1.0);
    study.spread->share_of_uses = share;
    return study;
  };
  const Scatter current{.name = "current_A", .about = NormalDeviation{0.01}, .of_use = true};
  Study one = used({current}, 0.99);
  limit(one, made_up(place), 1.1);
  const Yield yield = yield_at(one, 1.0, 10);
  EXPECT_EQ(yield.quantities[0].of_uses, 0.99);
  EXPECT_NEAR(yield.quantities[0].p05.value(), 1.0 + 0.01 * 2.3263, 3e-5);  // of tables; the cut is at 4 deviations
  const Scatter ambient{.name = "ambient_degC", .about = NormalDeviation{1.0}, .of_use = true};
  Study two = used({current, ambient}, 0.9025);
  limit(two, made_up(place), 1.1);
  EXPECT_NEAR(yield_at(two, 1.0, 10).quantities[0].p05.value(), 1.0 + 0.01 * 1.6449, 3e-5);  // 0.95 of each
}

// A use in which a build cannot be driven is one that it does not stand.
TEST(Uses, FailABuildThatLacksAValueInOne) {
  Study study = study_of({use("current_A", -0.1, 3.0)}, 0.9);
  limit(study, quantity("coil_temperature_degC"), 1e6);
  const Yield yield = yield_at(study, 0.9, 20);
  EXPECT_EQ(yield.keeps_all.value, 0.0);
  EXPECT_FALSE(yield.failures.empty());
}

// What tells of heat or of lost magnetisation lasts, under whatever name.
TEST(Uses, CountForAllThatLasts) {
  for (const ResultQuantity& each : simulation::standard_quantities()) {
    const bool tells = each.name.ends_with("_degC") || each.name.find("thermal") != std::string::npos ||
                       each.name.find("demagnet") != std::string::npos || each.name.starts_with("irreversible") ||
                       each.name.find("continuous") != std::string::npos || each.name.starts_with("runaway") ||
                       each.name.starts_with("time_to_limit");
    EXPECT_EQ(each.in_every_use, tells) << each.name;
  }
}

}  // namespace
}  // namespace coilwright::sizing
