#include "coilwright/magnetics/wrench.hpp"

#include <gtest/gtest.h>

#include "reference_cases.hpp"

namespace coilwright::magnetics {
namespace {

Eigen::Vector3d vector(const nlohmann::json& v) {
  return Eigen::Vector3d(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
}

// The reference gives 1e-13. Relative to the length of the force, and for the torque to force times magnet radius or
// the torque itself, whichever is larger (a torque may vanish by symmetry).
TEST(Wrench, AgreesWithTheIndependentReferenceInEveryCase) {
  const auto data = reference::load("noncoaxial.json");
  ASSERT_EQ(data["cases"].size(), 13U);
  for (const auto& c : data["cases"]) {
    const CylinderMagnet magnet = reference::magnet(c["magnet"]);
    const Wrench result = wrench(reference::coil(c["coil"], c["coil_model"]), c["coil"]["I"], magnet,
                                 {.position = vector(c["pos"]), .axis = vector(c["axis"])});
    const Eigen::Vector3d force = vector(c["F_on_magnet"]);
    const Eigen::Vector3d torque = vector(c["T_about_magnet_centre"]);
    const double force_error = (result.force - force).norm() / force.norm();
    const double torque_error =
        (result.torque - torque).norm() / std::max(torque.norm(), 0.1 * force.norm() * magnet.radius());
    if (std::getenv("SHOW")) printf("%-20s %.2e %.2e\n", c["id"].get<std::string>().c_str(), force_error, torque_error);
    EXPECT_LT(force_error, 1e-7) << c["id"];
    EXPECT_LT(torque_error, 1e-7) << c["id"];
  }
}

}  // namespace
}  // namespace coilwright::magnetics
