#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

namespace coilwright::magnetics {
namespace {

using testing::ThrowsMessage;

constexpr ThickCoil::Spec good_coil{
    .inner_radius = 3e-3, .outer_radius = 9.5e-3, .length = 12e-3, .turns_radial = 15, .turns_axial = 30};

template <class Change>
auto making_coil(Change change) {
  return [change] {
    ThickCoil::Spec spec = good_coil;
    change(spec);
    (void)ThickCoil(spec);
  };
}

TEST(ThickCoil, CountsAllItsTurns) {
  EXPECT_EQ(ThickCoil(good_coil).turns(), 450.0);
}

TEST(ThickCoil, SaysWhichFieldBreaksWhichRule) {
  using Error = std::invalid_argument;
  EXPECT_THAT(making_coil([](auto& s) { s.inner_radius = 0.0; }),
              ThrowsMessage<Error>("coil inner_radius must be finite and > 0; got 0"));
  EXPECT_THAT(making_coil([](auto& s) { s.outer_radius = std::numeric_limits<double>::infinity(); }),
              ThrowsMessage<Error>("coil outer_radius must be finite and > 0; got inf"));
  EXPECT_THAT(making_coil([](auto& s) { s.outer_radius = 2e-3; }),
              ThrowsMessage<Error>("coil outer_radius must be > inner_radius (0.003); got 0.002"));
  EXPECT_THAT(making_coil([](auto& s) { s.length = -1e-3; }),
              ThrowsMessage<Error>("coil length must be finite and > 0; got -0.001"));
  EXPECT_THAT(making_coil([](auto& s) { s.turns_radial = 0; }),
              ThrowsMessage<Error>("coil turns_radial must be >= 1; got 0"));
  EXPECT_THAT(making_coil([](auto& s) { s.turns_axial = -4; }),
              ThrowsMessage<Error>("coil turns_axial must be >= 1; got -4"));
}

TEST(CylinderMagnet, SaysWhichFieldBreaksWhichRule) {
  using Error = std::invalid_argument;
  EXPECT_THAT([] { (void)CylinderMagnet({.radius = 0.0, .length = 6e-3, .remanence = 1.2}); },
              ThrowsMessage<Error>("magnet radius must be finite and > 0; got 0"));
  EXPECT_THAT([] { (void)CylinderMagnet({.radius = 5e-3, .length = -6e-3, .remanence = 1.2}); },
              ThrowsMessage<Error>("magnet length must be finite and > 0; got -0.006"));
  EXPECT_THAT([] { (void)CylinderMagnet({.radius = 5e-3, .length = 6e-3, .remanence = -1.2}); },
              ThrowsMessage<Error>("magnet remanence must be finite and > 0; got -1.2"));
}

}  // namespace
}  // namespace coilwright::magnetics
