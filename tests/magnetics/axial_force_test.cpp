#include "coilwright/magnetics/axial_force.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coilwright/magnetics/constants.hpp"
#include "reference_cases.hpp"

namespace coilwright::magnetics {
namespace {

/// A current sheet is the magnet of remanence mu0 K.
CylinderMagnet sheet(double radius, double length, double surface_current) {
  return CylinderMagnet({.radius = radius, .length = length, .remanence = vacuum_permeability * surface_current});
}

double force_of(const nlohmann::json& c) {
  const std::string kind = c["kind"];
  const double z = c["z"];
  if (kind == "coil_magnet")
    return axial_force(reference::coil(c["coil"], c["coil_model"]), c["coil"]["I"], reference::magnet(c["magnet"]), z);
  if (kind == "magnet_magnet") return axial_force(reference::magnet(c["magnet1"]), reference::magnet(c["magnet2"]), z);
  if (kind == "coil_coil")
    return axial_force(reference::coil(c["coil1"], c["coil_model"]), c["coil1"]["I"],
                       reference::coil(c["coil2"], c["coil_model"]), c["coil2"]["I"], z);
  return axial_force(sheet(c["r1"], c["l1"], c["K1"]), sheet(c["r2"], c["l2"], c["K2"]), z);
}

// Golden values of an independent program (tests/data/magnetics_SOURCES.md), given to 2e-15, coil-coil to 1e-12.
TEST(AxialForce, AgreesWithTheIndependentReferenceInEveryCase) {
  const auto data = reference::load("coaxial.json");
  ASSERT_EQ(data["cases"].size(), 56U);
  for (const auto& c : data["cases"]) {
    const double expected = c["Fz_on_2"];
    const double relative = std::abs(force_of(c) / expected - 1.0);
    if (std::getenv("SHOW")) printf("%-35s %.2e\n", c["id"].get<std::string>().c_str(), relative);
    EXPECT_LT(relative, 1e-10) << c["id"];
  }
}

}  // namespace
}  // namespace coilwright::magnetics
