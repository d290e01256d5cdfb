// The tables of designs, cell by cell, on records made by hand.
#include <gtest/gtest.h>

#include <sstream>

#include "coilwright/formats/study/evaluation_table.hpp"
#include "coilwright/formats/study/sweep_table.hpp"
#include "formats/study/designs_by_hand.hpp"

namespace coilwright::formats {
namespace {

using namespace sizing;
using coilwright::testing::records;
using coilwright::testing::study;
using coilwright::testing::swept;
using simulation::standard_quantities;

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

}  // namespace
}  // namespace coilwright::formats
