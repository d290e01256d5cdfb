#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/parameters.hpp"

namespace coilwright::testing {

inline void expect_same_bits(const actuator::Design& a, const actuator::Design& b) {
  // Of several names of one thing the one that counts; numbers behind the others are left over from before.
  for (const actuator::Parameter& parameter : actuator::parameters()) {
    const auto counts = [&parameter](const actuator::Design& design) {
      return parameter.one_name_of.empty() || parameter.needed(design);
    };
    EXPECT_EQ(counts(a), counts(b)) << parameter.name;
    if (!counts(a)) continue;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(parameter.get(a)), std::bit_cast<std::uint64_t>(parameter.get(b)))
        << parameter.name << ": " << parameter.get(a) << " became " << parameter.get(b);
  }
  ASSERT_EQ(a.layout.size(), b.layout.size());
  for (std::size_t i = 0; i < a.layout.size(); ++i) {
    EXPECT_EQ(a.layout[i].kind, b.layout[i].kind);
    EXPECT_EQ(a.layout[i].polarity, b.layout[i].polarity);
  }
  EXPECT_EQ(a.choices.winding, b.choices.winding);
  EXPECT_EQ(a.choices.torque, b.choices.torque);
  EXPECT_EQ(a.choices.faces, b.choices.faces);
  EXPECT_EQ(a.choices.masses, b.choices.masses);
  EXPECT_EQ(a.choices.hinge, b.choices.hinge);
  EXPECT_EQ(a.choices.damping, b.choices.damping);
  ASSERT_EQ(a.calibration.hinge.has_value(), b.calibration.hinge.has_value());
  if (!a.calibration.hinge) return;
  EXPECT_EQ(a.calibration.hinge->width, b.calibration.hinge->width);
  EXPECT_EQ(a.calibration.hinge->bottom_layer, b.calibration.hinge->bottom_layer);
  EXPECT_EQ(a.calibration.hinge->stiffness, b.calibration.hinge->stiffness);
  EXPECT_EQ(a.calibration.hinge->damping, b.calibration.hinge->damping);
  EXPECT_EQ(a.calibration.hinge->first_mode, b.calibration.hinge->first_mode);
}

}  // namespace coilwright::testing
