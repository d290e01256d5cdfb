#include "coilwright/systems/validation/paper_comparison.hpp"

#include <gtest/gtest.h>

namespace coilwright::systems::validation {
namespace {

TEST(PaperComparison, EveryFigureLiesInItsBand) {
  for (const Comparison& row : compare_with_paper()) {
    EXPECT_TRUE(row.holds()) << row.quantity << ": " << row.model << " against " << row.reference;
    EXPECT_LT(row.band_high - row.band_low, 0.12) << row.quantity << ": a band this wide says nothing";
    EXPECT_FALSE(row.because.empty());
  }
}

TEST(PaperComparison, NoticesAModelOutsideItsBand) {
  const Comparison off{
      .quantity = "x", .source = "", .reference = 2.0, .model = 2.3, .band_low = 0.9, .band_high = 1.1, .because = ""};
  EXPECT_FALSE(off.holds());
}

// The measured grasp force lies between walls that give way and walls that do not.
TEST(PaperComparison, BracketsTheMeasuredGraspForce) {
  double below = 0.0;
  double above = 0.0;
  for (const Comparison& row : compare_with_paper()) {
    if (row.quantity == "grasp force N at 1.4 A") below = row.model;
    if (row.quantity == "grasp force N, firm silicone walls") above = row.model;
  }
  EXPECT_LT(below, 1.19);
  EXPECT_GT(above, 1.19);
}

}  // namespace
}  // namespace coilwright::systems::validation
