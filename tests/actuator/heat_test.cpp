#include "coilwright/actuator/heat.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/thermal/paths.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "degree.hpp"
#include "error_text.hpp"

namespace coilwright::actuator {
namespace {

TEST(HeatNetwork, HasItsComponentsFirst) {
  Design design = paper_finger();
  design.layout = layout_of(Configuration::D);
  const Assembly a = assemble_or_throw(design);
  const thermal::Network network = heat_network(design, a);
  ASSERT_EQ(network.size(), 2 * 6 + 2);  // jackets and both solid ends
  for (std::size_t i = 0; i < 6; ++i) {
    const bool magnet = design.layout[i].kind == ComponentKind::magnet;
    EXPECT_EQ(network.nodes()[i].kind, magnet ? thermal::NodeKind::magnet : thermal::NodeKind::coil);
    EXPECT_EQ(network.nodes()[i].resistance, magnet ? 0.0 : a.coil.resistance);
    EXPECT_EQ(network.nodes()[i].temperature_limit, magnet ? 80.0 : 155.0);
  }
}

// Cores and jackets hold what segments hold, but for the silicone between the wires, which a mass leaves out, and for
// the rear and front parts, of which only what is near the coils takes part.
TEST(HeatNetwork, HoldsTheHeatOfItsParts) {
  const Design design = paper_finger();
  const Assembly a = assemble_or_throw(design);
  const thermal::Network network = heat_network(design, a);
  const thermal::Node& magnet = network.nodes()[1];
  const thermal::Node& jacket = network.nodes()[4];
  EXPECT_NEAR(magnet.heat_capacity + jacket.heat_capacity, a.segments[1].heat_capacity, 1e-9);
  EXPECT_GT(network.nodes()[0].heat_capacity, 385.0 * a.coil.copper_mass);
}

// An independent finite-volume model of the prototype, straight, has 1.08 A where silicone is between the turns and
// 0.755 A where air is: enamelled wires apart, as here, make a third less within 2 %.
TEST(HeatNetwork, HoldsAThirdLessWhereItsCoilsAreDry) {
  const auto current = [](Filler filler) {
    Design design = paper_finger();
    design.coil.filler = filler;
    const Assembly a = assemble_or_throw(design);
    return thermal::continuous_current(heat_network(design, a, mechanics::JointVector::Zero(2)),
                                       thermal::LimitedParts::coils)
        .current;
  };
  const double silicone = current(Filler::silicone);
  EXPECT_NEAR(silicone, current(Filler::unstated), 1e-12);
  EXPECT_NEAR(current(Filler::air) / silicone, 0.755 / 1.08, 0.02 * 0.7);
}

// All heat of the coils leaves to ambient through the nodes' own conductances: a balance of the whole finger.
TEST(HeatNetwork, LosesWhatItsCoilsMake) {
  const Design design = paper_finger();
  const thermal::Network network = heat_network(design, assemble_or_throw(design));
  const double mean_square = 0.9 * 0.9;
  const auto state = thermal::steady_state(network, thermal::same_in_every_coil(network, mean_square));
  double lost = 0.0;
  double made = 0.0;
  for (Eigen::Index i = 0; i < network.size(); ++i) {
    const thermal::Node& node = network.nodes()[static_cast<std::size_t>(i)];
    lost += node.ambient_conductance * (state.temperatures[i] - 25.0);
    made += mean_square * node.resistance * (1.0 + network.temperature_coefficient() * (state.temperatures[i] - 20.0));
  }
  EXPECT_NEAR(lost, made, 1e-12 * made);
  EXPECT_GT(made, 6.0);  // 2 * 0.81 A^2 * 3.76 Ohm and more, being warm
}

// How much the posture decides: the figures of thermal_joint_angle's comment.
TEST(HeatNetwork, HeatsTheMagnetLessWhereJointsStandOpen) {
  const Design design = paper_finger();
  const Assembly a = assemble_or_throw(design);
  const auto current = [&](double angle, thermal::LimitedParts watch) {
    return thermal::continuous_current(heat_network(design, a, angle), watch).current;
  };
  std::printf("  film %.5g W/(m2 K), still air %.4g\n",
              design.calibration.heat_transfer * design.surroundings.heat_transfer,
              still_air_film(design, a, mechanics::JointVector::Zero(2)));
  std::printf("  joint angle, deg: continuous current of coils, magnets, in still air, A\n");
  for (const double angle : {0.0, 15.0, 30.0, 45.0, 60.0}) {
    const auto still =
        thermal::current_limits(still_air_network(design, a, mechanics::JointVector::Constant(2, angle * degree)));
    std::printf("  %4.0f: %.4f %.4f  %.4f %.4f\n", angle, current(angle * degree, thermal::LimitedParts::coils),
                current(angle * degree, thermal::LimitedParts::magnets), still.coils, still.magnets);
  }
  EXPECT_NEAR(current(30.0 * degree, thermal::LimitedParts::coils), 1.1, 1e-9);  // calibrated there
  const double printed = 5e-4;  // half of the last digit of that comment
  EXPECT_NEAR(current(0.0, thermal::LimitedParts::coils), 1.067, printed);
  EXPECT_NEAR(current(60.0 * degree, thermal::LimitedParts::coils), 1.132, printed);
  EXPECT_NEAR(current(0.0, thermal::LimitedParts::magnets), 0.96, 5e-3);
  EXPECT_NEAR(current(30.0 * degree, thermal::LimitedParts::magnets), 1.78, 5e-3);
  EXPECT_NEAR(current(60.0 * degree, thermal::LimitedParts::magnets), 1.98, 5e-3);
  // The default of a design's surroundings is the prototype's.
  EXPECT_NEAR(design.calibration.heat_transfer * design.surroundings.heat_transfer, Design{}.surroundings.heat_transfer,
              0.05);
}

// The film of still air and the surface that it keeps belong together. Closed, all heat leaves by a box whose area is
// known: the law of the film, looked up at that heat over film and area, is the film that the search found. Where the
// magnet limits, an audit with finite volumes has 43 degC and 13.5 W/(m2 K); in open joints coils limit, and the
// surface is hotter.
TEST(StillAirFilm, IsThatOfItsOwnSurface) {
  Design design = paper_finger();
  design.magnet.temperature_limit = 60.0;  // N52
  const Assembly a = assemble_or_throw(design);
  const auto closed = mechanics::JointVector::Zero(2);
  const double film = still_air_film(design, a, closed);
  const thermal::Network network = still_air_network(design, a, closed);
  const double current = thermal::current_limits(network).for_good();
  const double heat =
      thermal::steady_state(network, thermal::same_in_every_coil(network, current * current)).heat.sum();
  const Dimensions& size = a.dimensions;
  const double length = size.effective_length + design.body.rear_length;
  const double area = 2.0 * (size.width + size.height) * length + 2.0 * size.width * size.height;
  const double surface = 25.0 + heat / (film * area);
  EXPECT_NEAR(film, thermal::still_air_film({.height = size.height, .ambient = 25.0, .surface_temperature = surface}),
              1e-6);
  EXPECT_NEAR(surface, 43.0, 2.0);
  EXPECT_NEAR(film, 13.5, 0.4);
  EXPECT_GT(still_air_film(design, a, mechanics::JointVector::Constant(2, 30.0 * degree)), film + 1.0);
}

// Each joint opens its own way: the one that is closed passes what it passes when all are.
TEST(HeatNetwork, TakesEachJointAtItsOwnAngle) {
  const Design design = paper_finger();
  const Assembly a = assemble_or_throw(design);
  mechanics::JointVector angles(2);
  angles << -0.02, 0.5;
  const thermal::NodeMatrix own = heat_network(design, a, angles).conductance();
  const thermal::NodeMatrix closed = heat_network(design, a, 0.0).conductance();
  const thermal::NodeMatrix open = heat_network(design, a, 0.5).conductance();
  EXPECT_NEAR(own(0, 1), closed(0, 1), 1e-15);
  EXPECT_NEAR(own(1, 2), open(1, 2), 1e-15);
  EXPECT_LT(closed(0, 1), open(0, 1));  // both negative
}

TEST(HeatNetwork, WantsAnAngleForEachJoint) {
  const Design design = paper_finger();
  const Assembly a = assemble_or_throw(design);
  const auto text = [&](const mechanics::JointVector& angles) {
    return error_text([&] { (void)heat_network(design, a, angles); });
  };
  EXPECT_EQ(text(mechanics::JointVector::Zero(3)), "joint_angles: must have 2 values; got 3");
  mechanics::JointVector angles(2);
  angles << 0.1, std::nan("");
  EXPECT_EQ(text(angles), "joint_angles[1]: must be finite; got nan");
}

}  // namespace
}  // namespace coilwright::actuator
