#include "coilwright/magnetics/magnet_grade.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "coilwright/magnetics/constants.hpp"

namespace coilwright::magnetics {
namespace {

// Arnold Magnetic Technologies, Neodymium-Iron-Boron Magnet Grades: 1450 mT typical, 836 and 876 kA/m at least, -0.12
// and -0.75 %/K, 60 degC. Linear: 876 (1 - 0.0075 40) = 613.2 kA/m and 1 - 0.0012 40 = 0.952 at 60 degC.
TEST(MagnetGrade, HoldsWhatTheMakerOfN52Prints) {
  const MagnetGrade* grade = find_magnet_grade("N52");
  ASSERT_NE(grade, nullptr);
  EXPECT_EQ(grade->remanence, 1.45);
  EXPECT_EQ(grade->temperature_limit, 60.0);
  EXPECT_EQ(grade->price_ratio, 1.0);
  EXPECT_NEAR(grade->coercivity * share_at(20.0, grade->coercivity_coefficient), 876e3, 1e-9);
  EXPECT_NEAR(grade->coercivity * share_at(60.0, grade->coercivity_coefficient), 613.2e3, 1e-9);
  EXPECT_NEAR(share_at(60.0, grade->remanence_coefficient), 0.952, 1e-15);
}

TEST(MagnetGrade, NeverTurnsRoundInTheHeat) {
  const MagnetGrade* grade = find_magnet_grade("N42SH");
  ASSERT_NE(grade, nullptr);
  EXPECT_EQ(share_at(1000.0, grade->coercivity_coefficient), 0.0);
  EXPECT_EQ(share_at(2000.0, grade->remanence_coefficient), 0.0);
}

// What every real row must keep: a guaranteed value is below the typical one; HcB is below Br / (mu0 mu_rec), where the
// recoil line crosses B = 0, and below HcJ; a letter more has more coercivity and costs more.
TEST(MagnetGrade, HoldsRowsThatAMaterialCanHave) {
  std::set<std::string_view> names;
  for (const MagnetGrade& grade : magnet_grades()) {
    SCOPED_TRACE(std::string(grade.name));
    EXPECT_TRUE(names.insert(grade.name).second);
    EXPECT_EQ(find_magnet_grade(grade.name), &grade);
    EXPECT_LT(grade.least_remanence, grade.remanence);
    EXPECT_LT(grade.induction_coercivity,
              grade.remanence / (vacuum_permeability * grade.recoil_permeability) * (1.0 + 0.01));
    EXPECT_LT(grade.induction_coercivity, grade.coercivity);
    EXPECT_GT(share_at(grade.temperature_limit, grade.coercivity_coefficient), 0.25);
  }
  for (const char* number : {"N35", "N38", "N40", "N42", "N45", "N48"}) {
    const MagnetGrade* plain = find_magnet_grade(number);
    const MagnetGrade* hot = find_magnet_grade(std::string(number) + "SH");
    ASSERT_TRUE(plain != nullptr && hot != nullptr) << number;
    EXPECT_GT(hot->coercivity * share_at(80.0, hot->coercivity_coefficient),
              1.9 * plain->coercivity * share_at(80.0, plain->coercivity_coefficient))
        << number;
    EXPECT_GT(hot->price_ratio, plain->price_ratio) << number;
  }
  EXPECT_EQ(find_magnet_grade("N99"), nullptr);
}

}  // namespace
}  // namespace coilwright::magnetics
