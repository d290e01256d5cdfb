#include "coilwright/report/sweep_text.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "formats/study/designs_by_hand.hpp"

namespace coilwright::report {
namespace {

using coilwright::testing::records;
using coilwright::testing::study;
using coilwright::testing::swept;
using sizing::Leader;
using sizing::Study;
using sizing::SweptDesign;

TEST(SweepText, NamesADesignOnceAndSaysWhatIsInTheWay) {
  const Study asked = study();
  const std::vector<Leader> leaders = {{.configuration = "D", .objective = 0, .design = swept(records[0])},
                                       {.configuration = "D", .objective = 1, .design = swept(records[0])},
                                       {.configuration = "A", .objective = 0, .design = [] {
                                          SweptDesign other = swept(records[1]);
                                          other.index = 4;
                                          return other;
                                        }()}};
  EXPECT_EQ(
      to_text(document_of({.study = asked, .designs = 9, .evaluated = 7, .ok = 2, .leaders = leaders})),
      "by hand: minimise current_A, maximise grasp_force_N\n"
      "\nThe smallest current_A is 0.4: configuration D, current_A 0.4, wire_gauge_AWG 30. The largest "
      "grasp_force_N is 1.25: configuration D, current_A 0.4, wire_gauge_AWG 30. 7 of 9 designs evaluated; 2 keep "
      "every limit.\n"
      "\nINTERRUPTED: the run may find better designs; --resume goes on.\n"
      "\nThe best designs\n"
      "  configuration  current_A  wire_gauge_AWG  grasp_force_N  best for\n"
      "              D        0.4              30           1.25  current_A, grasp_force_N\n"
      "              A        0.8              26            2.5  none is feasible; the nearest: mass_g <= 64 "
      "violated by 16 g\n");
}

}  // namespace
}  // namespace coilwright::report
