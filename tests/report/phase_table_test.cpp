#include "coilwright/report/diagnosis/phase_table.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace coilwright::report {
namespace {

using measurement::Phase;

TEST(PhaseTable, NamesEachPhaseInItsOrderAndAddsThemUp) {
  const std::vector<Phase> phases = {{.name = "noise", .seconds = 0.014, .simulated_runs = 0},
                                     {.name = "cross-validation", .seconds = 12.5, .simulated_runs = 4000},
                                     {.name = "intervals", .seconds = 0.25, .simulated_runs = 31}};
  EXPECT_EQ(to_text(phases),
            "  phase                 s  simulated runs\n"
            "  noise              0.01               0\n"
            "  cross-validation  12.50            4000\n"
            "  intervals          0.25              31\n"
            "  total             12.76            4031\n");
}

TEST(PhaseTable, IsEmptyWithoutAPhase) {
  EXPECT_EQ(to_text(std::vector<Phase>{}), "");
}

}  // namespace
}  // namespace coilwright::report
