#include <gtest/gtest.h>

#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

TEST(EffectUnits, AreMissingFromPureNumbersOnly) {
  std::vector<const actuator::EffectKind*> kinds;
  for (const actuator::EffectKind* kind : actuator::standard_effects().kinds()) {
    kinds.push_back(kind);
    if (kind->with_further_numbers() != nullptr) kinds.push_back(kind->with_further_numbers());
  }
  for (const actuator::EffectKind* kind : kinds) {
    for (const actuator::EffectParameter& parameter : kind->parameters()) {
      const std::string_view key = parameter.key;
      const bool pure = key == "gain" || key == "scale" || key == "side" || key == "warm_start" ||
                        key == "stiffness_ratio" || key == "mass_ratio" || key == "stribeck_ratio" ||
                        key == "softening" || key == "damping_ratio" || key == "coefficient";
      EXPECT_EQ(!units::split_unit(key).has_value(), pure) << kind->id() << ' ' << key;
    }
  }
}

}  // namespace
}  // namespace coilwright::formats
