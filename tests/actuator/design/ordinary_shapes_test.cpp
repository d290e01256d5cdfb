#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>

#include "actuator/design/random_designs.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/parts/coil_row.hpp"
#include "coilwright/actuator/parts/hinge_pair_parts.hpp"
#include "coilwright/magnetics/axial_force.hpp"

// Whatever construction_faults lets pass is computed: a search may not lose a part of its range to a curve.
namespace coilwright::actuator {
namespace {

using magnetics::Curve;
using magnetics::Fidelity;

constexpr double tolerance = 1e-6;  // of a curve's largest value

struct Count {
  int fitting = 0;
  int refused = 0;
  double worst_hinge = 0.0;  // share of the curve's largest value
  double worst_force = 0.0;
};

// More points near the lower end, where the parts touch.
double place(random_designs::Generator& random, const Curve& curve) {
  const double share = random_designs::uniform(random, 0.0, 1.0);
  return curve.lower() + share * share * share * (curve.upper() - curve.lower());
}

double worst_error(random_designs::Generator& random, const HingePair& pair) {
  const HingePairParts::Spec& parts = pair.parts->spec();
  const Curve& curve = *pair.torque_per_ampere;
  double worst = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double angle = place(random, curve);
    const double direct =
        magnetics::hinge_torque_per_ampere(parts.coil, parts.magnet, parts.geometry, parts.fidelity, angle);
    worst = std::max(worst, std::abs(curve.value(angle) - direct) / curve.scale());
  }
  return worst;
}

double worst_error(random_designs::Generator& random, const magnetics::ThickCoil& coil, const Curve& curve) {
  double worst = 0.0;
  for (int i = 0; i < 4; ++i) {
    const double distance = place(random, curve);
    const double direct = magnetics::axial_force(coil, 1.0, coil, 1.0, distance);
    worst = std::max(worst, std::abs(curve.value(distance) - direct) / curve.scale());
  }
  return worst;
}

Count count(Fidelity fidelity, int designs) {
  random_designs::Generator random(8);
  Count out;
  for (int i = 0; i < designs; ++i) {
    const Design design = random_designs::design(random, fidelity);
    if (!construction_faults(design).empty()) continue;
    ++out.fitting;
    const std::variant<Assembly, ConstructionFaults> result = assemble(design);
    if (const auto* faults = std::get_if<ConstructionFaults>(&result)) {
      ++out.refused;
      ADD_FAILURE() << i << ": " << faults->front().rule;
      continue;
    }
    const ModelSpec spec = std::get<Assembly>(result).model.nominal_spec();
    out.worst_hinge = std::max(out.worst_hinge, worst_error(random, spec.magnetics.hinge_pairs().front()));
    if (!spec.coil_row) continue;
    for (const DistantPair& pair : spec.coil_row->pairs())
      out.worst_force =
          std::max(out.worst_force, worst_error(random, spec.coil_row->coils().front().coil, *pair.axial_force));
  }
  std::printf("%d designs fit together, %d refused; worst error of a curve: torque %.1e, force of two coils %.1e\n",
              out.fitting, out.refused, out.worst_hinge, out.worst_force);
  return out;
}

TEST(OrdinaryShapes, AreAllComputedByTheLineOfCentres) {
  const Count seen = count(Fidelity::line_of_centres, 400);
  EXPECT_GT(seen.fitting, 380);
  EXPECT_LT(seen.worst_hinge, tolerance);
  EXPECT_LT(seen.worst_force, tolerance);
}

TEST(OrdinaryShapes, AreAllComputedExactly) {
  const Count seen = count(Fidelity::exact, 150);
  EXPECT_GT(seen.fitting, 140);
  EXPECT_LT(seen.worst_hinge, tolerance);
  EXPECT_LT(seen.worst_force, tolerance);
}

// Two coils next to each other: nine tenths of their distance lies inside their copper.
TEST(OrdinaryShapes, IncludeCoilsNextToEachOther) {
  Design design;
  design.layout = layout_of(Configuration::D);
  const ModelSpec spec = assemble_or_throw(design).model.nominal_spec();
  const std::vector<DistantPair> pairs = spec.coil_row->pairs();
  ASSERT_EQ(pairs.size(), 6U);
  const double length = spec.coil_row->coils().front().coil.length();
  for (const DistantPair& pair : pairs) EXPECT_GE(pair.axial_force->lower(), length);
  EXPECT_LT(pairs[3].axial_force->lower(), 1.06 * length);  // from where they touch
}

}  // namespace
}  // namespace coilwright::actuator
