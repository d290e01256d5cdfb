#include <gtest/gtest.h>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

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
