#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/parameters.hpp"

namespace coilwright::testing {

inline void expect_same_bits(const actuator::Design& a, const actuator::Design& b) {
  for (const actuator::Parameter& parameter : actuator::parameters())
    EXPECT_EQ(std::bit_cast<std::uint64_t>(parameter.get(a)), std::bit_cast<std::uint64_t>(parameter.get(b)))
        << parameter.name << ": " << parameter.get(a) << " became " << parameter.get(b);
  ASSERT_EQ(a.layout.size(), b.layout.size());
  for (std::size_t i = 0; i < a.layout.size(); ++i) {
    EXPECT_EQ(a.layout[i].kind, b.layout[i].kind);
    EXPECT_EQ(a.layout[i].polarity, b.layout[i].polarity);
  }
  EXPECT_EQ(a.choices.winding, b.choices.winding);
  EXPECT_EQ(a.choices.torque, b.choices.torque);
  EXPECT_EQ(a.choices.faces, b.choices.faces);
  EXPECT_EQ(a.choices.masses, b.choices.masses);
}

}  // namespace coilwright::testing
