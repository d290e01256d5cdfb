// The tables of designs, cell by cell, on records made by hand.
#include <gtest/gtest.h>

#include <sstream>

#include "coilwright/actuator/parameters.hpp"
#include "coilwright/report/evaluation_table.hpp"
#include "coilwright/report/sweep_table.hpp"

namespace coilwright::report {
namespace {

using namespace sizing;
using simulation::standard_quantities;

const simulation::ResultQuantity& quantity(std::string_view name) {
  return standard_quantities().at(name);
}

Study study() {
  Study out;
  out.name = "by hand";
  out.variables = {
      ConfigurationVariable{.values = {actuator::Configuration::D, actuator::Configuration::A}},
      CurrentVariable{.range = Interval{.lower = 0.1, .upper = 1.5}},
      ParameterVariable{.parameter = actuator::find_parameter("wire_gauge_AWG"), .range = Choice{.values = {26, 30}}}};
  out.objectives = {{.quantity = quantity("current_A"), .sense = Sense::minimise},
                    {.quantity = quantity("grasp_force_N"), .sense = Sense::maximise}};
  out.limits = {{.quantity = quantity("mass_g"), .side = Limit::Side::at_most, .value = 64.0},
                {.quantity = quantity("coil_temperature_degC"), .side = Limit::Side::at_most, .value = 128.0},
                {.quantity = quantity("damping_ratio"), .side = Limit::Side::at_least, .value = 0.0625}};
  return out;
}

Evaluation evaluated(double current, double force, std::vector<double> constraints) {
  return {.objectives = {current, force}, .constraints = std::move(constraints), .failure = {}, .infeasibility = {}};
}

// Constraints in sixteenths of the limits, so that the margins below are exact.
const std::vector<Record> records = {
    {.point = {0, 0.4, 1}, .evaluation = evaluated(0.4, 1.25, {-0.0625, -0.5, 0.0})},
    {.point = {1, 0.8, 0}, .evaluation = evaluated(0.8, 2.5, {0.25, -0.25, -4.0})},
    {.point = {1, 1.2, 0},
     .evaluation = {.objectives = {}, .constraints = {}, .failure = "too hot, \"really\"", .infeasibility = 2.0}}};

TEST(EvaluationTable, HasStatusMarginsAndReasonInUnits) {
  std::ostringstream out;
  write_evaluations(out, study(), records);
  EXPECT_EQ(out.str(),
            "configuration,current_A,wire_gauge_AWG,status,grasp_force_N,mass_max_margin_g,"
            "coil_temperature_max_margin_K,damping_ratio_min_margin,reason\n"
            "D,0.4,30,ok,1.25,4,64,0,\n"
            "A,0.8,26,infeasible,2.5,-16,32,0.25,\n"
            "A,1.2,26,failed,,,,,\"too hot, \"\"really\"\"\"\n");
}

TEST(FrontTable, HasVariablesObjectivesAndMargins) {
  std::ostringstream out;
  write_front(out, study(), std::span(records).first(1));
  EXPECT_EQ(out.str(),
            "configuration,current_A,wire_gauge_AWG,grasp_force_N,mass_max_margin_g,coil_temperature_max_margin_K,"
            "damping_ratio_min_margin\n"
            "D,0.4,30,1.25,4,64,0\n");
}

SweptDesign swept(const Record& record) {
  SweptDesign out{.index = 3, .point = record.point, .evaluation = record.evaluation, .quantities = {}};
  if (!record.evaluation.failure.empty()) return out;
  for (std::size_t i = 0; i < standard_quantities().size(); ++i) out.quantities.emplace_back(static_cast<double>(i));
  return out;
}

TEST(SweepTable, HasEveryQuantityOnceAndEmptyCellsForWhatIsNot) {
  std::ostringstream out;
  const Study asked = study();
  SweepTable table(out, asked);
  SweptDesign hot = swept(records[1]);
  for (std::size_t i = 0; i < standard_quantities().size(); ++i)
    if (standard_quantities()[i].name == "coil_temperature_degC") hot.quantities[i].reset();
  table.row(hot);
  table.row(swept(records[2]));

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

TEST(SweepText, NamesADesignOnceAndSaysWhatIsInTheWay) {
  const Study asked = study();
  const std::vector<Leader> leaders = {{.configuration = "D", .objective = 0, .design = swept(records[0])},
                                       {.configuration = "D", .objective = 1, .design = swept(records[0])},
                                       {.configuration = "A", .objective = 0, .design = [] {
                                          SweptDesign other = swept(records[1]);
                                          other.index = 4;
                                          return other;
                                        }()}};
  EXPECT_EQ(to_text(SweepAnswer{.study = asked, .designs = 9, .evaluated = 7, .ok = 2, .leaders = leaders}),
            "configuration  current_A  wire_gauge_AWG  grasp_force_N  best for\n"
            "            D        0.4              30           1.25  current_A, grasp_force_N\n"
            "            A        0.8              26            2.5  nothing feasible; nearest: mass_g <= 64 broken "
            "by 16 g\n"
            "\n7 of 9 designs evaluated; 2 keep every limit.\n");
}

}  // namespace
}  // namespace coilwright::report
