#include <gtest/gtest.h>

#include <string_view>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/parameters.hpp"

namespace coilwright::actuator {
namespace {

TEST(MagnetDesign, TakesTheNumbersOfItsGrade) {
  MagnetDesign magnet{.radius = 8e-3, .length = 4e-3, .remanence = 1.3, .density = 7400.0, .temperature_limit = 70.0};
  const magnetics::MagnetGrade* grade = magnetics::find_magnet_grade("N45SH");
  magnet.make_of(grade);
  EXPECT_EQ(magnet.grade, grade);
  EXPECT_EQ(magnet.remanence, 1.35);
  EXPECT_EQ(magnet.density, 7500.0);
  EXPECT_EQ(magnet.temperature_limit, 150.0);
  EXPECT_EQ(magnet.coercivity, 1512e3);
  EXPECT_EQ(magnet.remanence_coefficient, -0.0012);
  EXPECT_EQ(magnet.coercivity_coefficient, -0.0055);
  EXPECT_EQ(magnet.recoil_permeability, 1.05);
  magnet.remanence = 1.33;  // measured
  magnet.make_of(nullptr);
  EXPECT_EQ(magnet.grade, nullptr);
  EXPECT_EQ(magnet.remanence, 1.33);
  EXPECT_EQ(magnet.recoil_permeability, 1.0) << "it is unknown again";
  EXPECT_FALSE(magnet.has_coercivity());
}

// Files and results stay as they are: of what a grade brings they have only what a person stated.
TEST(MagnetDesign, IsWrittenWithWhatDiffersFromItsGrade) {
  Design design;
  const auto is_needed = [&design](std::string_view name) { return find_parameter(name)->needed(design); };
  design.magnet.make_of(magnetics::find_magnet_grade("N42"));
  for (const std::string_view name : {"coercivity_kA_m", "remanence_coefficient_pct_K", "coercivity_coefficient_pct_K",
                                      "recoil_permeability", "squareness"})
    EXPECT_FALSE(is_needed(name)) << name;
  design.magnet.coercivity = 1020e3;
  EXPECT_TRUE(is_needed("coercivity_kA_m"));
  EXPECT_FALSE(is_needed("squareness"));
}

// 1.44 / (1 + 0.05 0.5947) = 1.3984 T: the audit's 2.125 to 2.063 N.
TEST(MagnetDesign, GivesUpPolarisationOnlyWhereItsRecoilIsKnown) {
  MagnetDesign magnet{.radius = 10e-3, .length = 6e-3, .remanence = 1.44};
  EXPECT_EQ(magnet.polarisation(), 1.44);
  magnet.recoil_permeability = 1.05;
  EXPECT_NEAR(magnet.polarisation(), 1.3984, 5e-5);
}

TEST(Parameters, CallAGradeByItsName) {
  const Parameter* grade = find_parameter("magnet_grade");
  ASSERT_NE(grade, nullptr);
  Design design;
  EXPECT_EQ(grade->get(design), value_named(*grade, "none"));
  EXPECT_EQ(value_named(*grade, "N99"), std::nullopt);
  for (const std::string_view name : grade->names()) {
    grade->set(design, value_named(*grade, name).value());
    EXPECT_EQ(grade->names()[static_cast<std::size_t>(grade->get(design))], name);
    EXPECT_EQ(design.magnet.grade == nullptr ? "none" : design.magnet.grade->name, name);
  }
  EXPECT_TRUE(find_parameter("gap_mm")->names().empty());
}

}  // namespace
}  // namespace coilwright::actuator
