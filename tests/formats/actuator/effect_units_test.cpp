#include <gtest/gtest.h>

#include "coilwright/actuator/effect_catalogue.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

// An effect's parameter says how its key's unit is left; the list of units says so too.
TEST(EffectUnits, AreThoseOfTheirKeys) {
  for (const actuator::EffectKind* kind : actuator::standard_effects().kinds()) {
    for (const actuator::EffectParameter& parameter : kind->parameters()) {
      const auto split = units::split_unit(parameter.key);
      const double si = split ? units::to_si(2.3, split->unit) : 2.3;
      EXPECT_DOUBLE_EQ(2.3 / parameter.denominator, si) << kind->id() << ' ' << parameter.key;
    }
  }
}

TEST(EffectUnits, AreMissingFromPureNumbersOnly) {
  for (const actuator::EffectKind* kind : actuator::standard_effects().kinds()) {
    for (const actuator::EffectParameter& parameter : kind->parameters()) {
      const std::string_view key = parameter.key;
      const bool pure =
          key == "gain" || key == "scale" || key == "side" || key == "warm_start" || key == "stiffness_ratio";
      EXPECT_EQ(!units::split_unit(key).has_value(), pure) << kind->id() << ' ' << key;
    }
  }
}

}  // namespace
}  // namespace coilwright::formats
