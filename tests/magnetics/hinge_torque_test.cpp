#include "coilwright/magnetics/hinge_torque.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "reference_cases.hpp"

namespace coilwright::magnetics {
namespace {

// The reference attracts with 1.4 A, which closes the joint: its torque is minus 1.4 times ours. It gives 1e-12.
TEST(HingeTorque, AgreesWithTheIndependentReferenceInBothFidelities) {
  const auto data = reference::load("noncoaxial.json");
  ASSERT_EQ(data["hinge"].size(), 36U);
  const auto& baseline = data["cases"][0];
  for (const auto& row : data["hinge"]) {
    const ThickCoil coil = reference::coil(baseline["coil"], row["model"]);
    const CylinderMagnet magnet = reference::magnet(baseline["magnet"]);
    const HingeGeometry geometry{.coil_offset = row["la"], .magnet_offset = row["lb"], .axis_offset = row["h"]};
    const double angle = row["theta_deg"].get<double>() * std::numbers::pi / 180.0;
    const double current = baseline["coil"]["I"];
    const double exact = -current * hinge_torque_per_ampere(coil, magnet, geometry, Fidelity::exact, angle);
    const double centres = -current * hinge_torque_per_ampere(coil, magnet, geometry, Fidelity::line_of_centres, angle);
    EXPECT_NEAR(exact / row["torque_joint_exact"].get<double>(), 1.0, 1e-7) << row["theta_deg"] << row["model"];
    EXPECT_NEAR(centres / row["torque_joint_approx"].get<double>(), 1.0, 1e-10) << row["theta_deg"] << row["model"];
    EXPECT_NEAR(centre_distance(geometry, angle), row["centre_distance"].get<double>(), 1e-15);
  }
}

}  // namespace
}  // namespace coilwright::magnetics
