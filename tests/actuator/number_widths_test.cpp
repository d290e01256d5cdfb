#include "coilwright/actuator/number_widths.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/modelling_choices.hpp"

namespace coilwright::actuator {
namespace {

const NumberWidth& width_of(std::string_view name) {
  return *std::ranges::find(number_widths(), name, &NumberWidth::name);
}

// What is ordered by a whole number or by its name has none; everything else has a row, even if only to say why it is
// exact. A number that a later version adds to designs fails here until somebody says how well it is known.
TEST(NumberWidths, AreOfEveryNumberOfADesign) {
  for (const Parameter& parameter : parameters()) {
    const auto rows = std::ranges::count(number_widths(), parameter.name, &NumberWidth::name);
    const bool is_choice = parameter.name == "enamel" || parameter.name == "filler";
    EXPECT_EQ(rows, parameter.whole && !is_choice ? 0 : 1) << parameter.name;
  }
  for (const NumberWidth& width : number_widths()) {
    EXPECT_NE(find_parameter(width.name), nullptr) << width.name;
    EXPECT_FALSE(width.source.empty()) << width.name;
    EXPECT_EQ(width.subject.empty(), width.settled_by.empty()) << width.name;
    if (width.subject.empty()) continue;
    EXPECT_TRUE(width.values != nullptr || width.least < width.greatest) << width.name;
    EXPECT_LE(width.printed, width.by_hand) << width.name << ": hands are no closer than moulds";
  }
}

TEST(NumberWidths, AreLookedAtInTheDesignItselfAndNothingElseChanges) {
  const Design design = of_silicone("Dragon Skin 20", 3.2e-3);
  for (const OtherChoice& other : other_numbers(design)) {
    ASSERT_NE(find_parameter(other.number), nullptr) << other.number;
    EXPECT_NE(other.taken, other.otherwise);
    EXPECT_FALSE(other.source.empty());
    for (const Parameter& parameter : parameters()) {
      // Some follow from others where a design does not give them.
      const bool follows = parameter.needed != nullptr && !parameter.needed(design);
      if (parameter.name == other.number) {
        EXPECT_NE(parameter.get(other.design), parameter.get(design)) << other.number;
      } else if (!follows && parameter.one_name_of.empty()) {
        EXPECT_EQ(parameter.get(other.design), parameter.get(design)) << parameter.name << " by " << other.number;
      }
    }
  }
}

// Tensile tests of docs/theory/actuator.md, "Silicones": table over measured 2.3, 1.5 and 3.6; of others a factor of
// two.
TEST(Modulus, IsKnownToTheFactorOfItsSheetUntilItIsMeasuredOrStated) {
  const auto least = [](const Design& design) {
    const std::vector<double> moduli = other_values(width_of("youngs_modulus_MPa"), design);
    return moduli.empty() ? 0.0 : moduli.front() / (design.body.modulus() * 1e-6);
  };
  EXPECT_NEAR(least(of_silicone("Ecoflex 00-30", 4e-3)), 1.0 / 2.3, 0.01);
  EXPECT_NEAR(least(of_silicone("Dragon Skin 20", 3.2e-3)), 1.0 / 1.5, 0.01);
  EXPECT_NEAR(least(of_silicone("Ecoflex 00-10", 4e-3)), 1.0 / 3.6, 0.01);
  EXPECT_DOUBLE_EQ(least(of_silicone("Smooth-Sil 940", 2e-3)), 0.5);
  EXPECT_DOUBLE_EQ(least(Design{}), 0.5);  // Shore 28A
  // Hardness stands above the sheet of Dragon Skin 20 by 1/0.79, and below that of Ecoflex 00-30.
  EXPECT_EQ(other_values(width_of("youngs_modulus_MPa"), of_silicone("Ecoflex 00-30", 4e-3)).size(), 1U);
  EXPECT_NEAR(other_values(width_of("youngs_modulus_MPa"), of_silicone("Dragon Skin 20", 4e-3)).back(), 0.579 / 0.79,
              0.01);

  EXPECT_EQ(least(paper_finger()), 0.0) << "12.5 N mm/rad were measured";
  Design stated = of_silicone("Ecoflex 00-30", 4e-3);
  stated.body.young_modulus = 50.6e3;
  EXPECT_EQ(least(stated), 0.0);
  // What was measured on the prototype's silicone says nothing of another.
  Design other = paper_finger();
  other.body.make_of(of_silicone("Ecoflex 00-30", 4e-3).body.grade);
  EXPECT_NEAR(least(other), 1.0 / 2.3, 0.01);
}

TEST(NumberWidths, AreNoneWhereTheDesignSaysIt) {
  const auto is_open = [](std::string_view name, const Design& design) {
    return !other_values(width_of(name), design).empty();
  };
  Design design;
  EXPECT_TRUE(is_open("filler", design));
  EXPECT_TRUE(is_open("constant_damping_Nmms_rad", design));
  EXPECT_FALSE(is_open("constant_damping_Nmms_rad", paper_finger()));
  EXPECT_EQ(other_values(width_of("base_tilt_deg"), design).size(), 3U);
  EXPECT_EQ(other_values(width_of("remanence_T"), design).size(), 2U);
  design.coil.filler = Filler::air;
  design.surroundings.base_tilt = 0.5;
  design.surroundings.ambient = 60.0;
  EXPECT_FALSE(is_open("filler", design));
  EXPECT_FALSE(is_open("ambient_degC", design));
  for (const double tilt : other_values(width_of("base_tilt_deg"), design)) EXPECT_NEAR(tilt, 28.6, 3.1);
  // Nothing is looked at that cannot be: a wall that is thinner than its width is left out below.
  design.body.bottom_wall = 0.12e-3;
  EXPECT_EQ(other_values(width_of("bottom_wall_mm"), design).size(), 1U);
}

}  // namespace
}  // namespace coilwright::actuator
