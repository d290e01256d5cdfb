#include "coilwright/formats/data/diagnosis_formatting.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace coilwright::formats {
namespace {

TEST(DiagnosisFormatting, WritesAnEstimateInTheUnitAtTheEndOfItsKey) {
  const EstimateInUnit shown = in_unit({.key = "joint_stiffness_Nmm_rad",
                                        .value = 0.0124,
                                        .lower = 0.0123,
                                        .upper = std::numeric_limits<double>::infinity()});
  EXPECT_EQ(shown.value, 12.4);
  EXPECT_EQ(shown.lower, 12.3);
  EXPECT_EQ(shown.upper, std::numeric_limits<double>::infinity());
}

TEST(DiagnosisFormatting, FindsTheUnitOfANumberInAList) {
  EXPECT_EQ(in_unit({.key = "/magnetics/0/torque_Nmm_A/1", .value = 0.011, .lower = 0.01, .upper = 0.012}).value, 11.0);
}

TEST(DiagnosisFormatting, LeavesATemperatureInDegreesCelsius) {
  EXPECT_EQ(in_unit({.key = "/surroundings/ambient_degC", .value = 23.5, .lower = 23.0, .upper = 24.0}).value, 23.5);
}

}  // namespace
}  // namespace coilwright::formats
