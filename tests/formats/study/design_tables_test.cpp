// The tables of designs, cell by cell, on records made by hand.
#include <gtest/gtest.h>

#include <sstream>

#include "coilwright/formats/study/design_tables.hpp"
#include "formats/study/designs_by_hand.hpp"

namespace coilwright::formats {
namespace {

using namespace sizing;
using coilwright::testing::records;
using coilwright::testing::study;
using coilwright::testing::swept;
using simulation::standard_quantities;

// The table of quantities has the current, which is a variable too, and lacks an objective.
TEST(EvaluationTable, HasOrderQuantitiesMarginsAndReasonInUnits) {
  Study asked = study();
  asked.quantities =
      simulation::QuantityTable({standard_quantities().at("mass_g"), standard_quantities().at("current_A"),
                                 standard_quantities().at("voltage_V")});
  std::vector<Record> made = records;
  made[0].number = 3;
  made[0].proposed_by = "end";
  made[0].evaluation.quantities = {62.5, 0.4, std::nullopt};
  made[1].number = 1;
  made[1].evaluation.quantities = {80.0, 0.8, 6.5};
  made[2].number = 2;
  std::ostringstream out;
  write_evaluations(out, asked, made);
  EXPECT_EQ(out.str(),
            "configuration,current_A,wire_gauge_AWG,evaluation,proposed_by,status,mass_g,voltage_V,grasp_force_N,"
            "mass_max_margin_g,coil_temperature_max_margin_K,damping_ratio_min_margin,reason\n"
            "D,0.4,30,3,end,ok,62.5,,1.25,4,64,0,\n"
            "A,0.8,26,1,,infeasible,80,6.5,2.5,-16,32,0.25,\n"
            "A,1.2,26,2,,failed,,,,,,,\"too hot, \"\"really\"\"\"\n");
}

// A unit that the table of units lacks stands whole at the end of the margin's name: not "N_max_margin_g".
TEST(EvaluationTable, NamesMarginsOfExpressionsByTheirOwnUnit) {
  const simulation::ResultQuantity ratio{.name = "grip_per_mass_N_g",
                                         .meaning = "of the study",
                                         .scale = 0.02,
                                         .value = [](const simulation::DesignView&) { return std::optional(1.0); },
                                         .unit = "N_g"};
  EXPECT_EQ(margin_column({.quantity = ratio, .side = Limit::Side::at_least, .value = 0.01}),
            "grip_per_mass_min_margin_N_g");
}

Problem by_hand(std::vector<Objective> objectives) {
  const bool two = objectives.size() == 2;
  return {.variables = {{.name = "x", .kind = VariableKind::integer, .lower = 0, .upper = 9}},
          .objectives = std::move(objectives),
          .constraints = {"limit"},
          .evaluate = [two](std::span<const double> x) {
            if (x[0] == 1)
              return Evaluation{.objectives = {}, .constraints = {}, .failure = "none", .infeasibility = 1};
            std::vector<double> values{x[0]};
            if (two) values.push_back((x[0] - 5) * (x[0] - 5));
            return Evaluation{
                .objectives = std::move(values), .constraints = {(4 - x[0]) / 4}, .failure = {}, .infeasibility = 0};
          }};
}

Archive evaluated_in_order(Problem problem, std::initializer_list<double> points) {
  Archive archive{std::move(problem)};
  for (const double x : points) {
    (void)archive.evaluate(std::vector{x});
    archive.number(std::vector{x});
  }
  return archive;
}

TEST(ConvergenceTable, HasARowForEachImprovementAndTheLast) {
  const Archive archive =
      evaluated_in_order(by_hand({{.name = "x_mm", .sense = Sense::minimise}}), {1, 0, 2, 9, 3, 6, 7, 4, 5});
  std::ostringstream out;
  write_convergence(out, archive);
  EXPECT_EQ(out.str(), "evaluation,best_x_mm,least_violation\n2,,1\n3,,0.5\n4,9,0\n6,6,0\n8,4,0\n9,4,0\n");
}

// The final front has x = 4 and 5 of the feasible 4 to 9, at (4, 1) and (5, 0): in its own frame x = 9 lies outside, x
// = 5 covers 0.1 * 1.1, and both 0.1 * 1.1 + 1 * 0.1.
TEST(ConvergenceTable, HasTheHypervolumeOfTheFrontSoFar) {
  const Archive archive = evaluated_in_order(
      by_hand({{.name = "a", .sense = Sense::minimise}, {.name = "b", .sense = Sense::minimise}}), {1, 3, 9, 5, 4});
  std::ostringstream out;
  write_convergence(out, archive);
  std::istringstream lines(out.str());
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0], "evaluation,front_size,hypervolume,least_violation");
  EXPECT_EQ(rows[1], "1,0,,");
  EXPECT_EQ(rows[2], "2,0,,0.25");
  EXPECT_EQ(rows[3], "3,1,0,0");
  EXPECT_TRUE(rows[4].starts_with("4,1,0.11")) << rows[4];
  EXPECT_TRUE(rows[5].starts_with("5,2,0.21")) << rows[5];
}

TEST(FrontTable, HasVariablesObjectivesMarginsAndThenEveryOtherQuantityOnce) {
  std::ostringstream out;
  write_front(out, study(), std::span(records).first(1));
  const std::string header =
      "configuration,current_A,wire_gauge_AWG,grasp_force_N,mass_max_margin_g,coil_temperature_max_margin_K,"
      "damping_ratio_min_margin";
  std::size_t others = 0;
  std::string expected = header;
  for (const simulation::ResultQuantity& quantity : study().quantities) {
    if (quantity.name == "grasp_force_N" || quantity.name == "current_A") continue;  // columns already
    expected += "," + quantity.name;
    ++others;
  }
  EXPECT_GT(others, 50u);
  EXPECT_EQ(out.str(), expected + "\nD,0.4,30,1.25,4,64,0" + std::string(others, ',') + "\n");
}

TEST(SweepTable, HasEveryQuantityOnceAndEmptyCellsForWhatIsNot) {
  std::ostringstream out;
  const Study asked = study();
  const SweepRow write_row = write_sweep(out, asked);
  SweptDesign hot = swept(records[1]);
  for (std::size_t i = 0; i < standard_quantities().size(); ++i) {
    hot.evaluation.quantities.emplace_back(static_cast<double>(i));
    if (standard_quantities()[i].name == "coil_temperature_degC") hot.evaluation.quantities[i].reset();
  }
  write_row(hot);
  write_row(swept(records[2]));

  std::istringstream lines(out.str());
  std::string header, first, second;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  // 3 variables, status, the quantities but current_A, 3 margins, reason.
  const auto columns = static_cast<std::ptrdiff_t>(3 + 1 + standard_quantities().size() - 1 + 3 + 1);
  for (const std::string& line : {header, first})
    EXPECT_EQ(std::count(line.begin(), line.end(), ',') + 1, columns) << line;
  EXPECT_TRUE(header.starts_with("configuration,current_A,wire_gauge_AWG,status,axial_force_N,")) << header;
  EXPECT_TRUE(first.starts_with("A,0.8,26,infeasible,0,1,2,")) << first;
  EXPECT_TRUE(first.ends_with(",-16,32,0.25,")) << first;
  EXPECT_NE(first.find(",,"), std::string::npos);
  EXPECT_TRUE(second.starts_with("A,1.2,26,failed,,,")) << second;
}

}  // namespace
}  // namespace coilwright::formats
