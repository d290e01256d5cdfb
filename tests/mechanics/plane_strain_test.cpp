#include <gtest/gtest.h>

#include <cmath>

#include "coilwright/mechanics/silicone_hinge.hpp"
#include "mechanics/plane_strain_hinge.hpp"

namespace coilwright::mechanics {
namespace {

// The prototype's body: 21.5 mm above the bottom layer, half a coil segment of 6.3 mm beside the cut, 22 mm wide,
// Shore 28, nu = 0.49. In N mm/rad where E' w is in N/mm.
constexpr double poisson = 0.49;
constexpr int fine = 12;

double plane_strain_modulus_times_width() {
  return young_modulus_from_shore_a(28.0) * 1e-6 / (1.0 - poisson * poisson) * 22.0;
}

HingeBlock prototype(double ligament, double slot_width = 0.0) {
  return {.ligament = ligament,
          .slot_width = slot_width,
          .height = 21.5 + ligament,
          .half_length = 6.3,
          .poisson_ratio = poisson};
}

// Deep: a body sixty times the ligament. Flexibility over that of E' w h^2.
double deep_compliance(double slot_over_ligament, int levels = fine) {
  return 1.0 / hinge_stiffness_by_elements({.ligament = 1.0,
                                            .slot_width = slot_over_ligament,
                                            .height = 60.0,
                                            .half_length = 80.0,
                                            .poisson_ratio = poisson},
                                           levels);
}

double law_compliance(double slot_over_ligament) {
  return 1.0 / ligament_stiffness({.width = 1.0, .height = 1.0, .slot_width = slot_over_ligament},
                                  {.young_modulus = 1.0 - poisson * poisson, .poisson_ratio = poisson});
}

// An uncut bar is a beam: E' I / length to its plane ends, quadratic elements have no error in pure bending.
TEST(PlaneStrainElements, AreExactForABeam) {
  const double height = 1.7;
  const double half_length = 2.3;
  const double stiffness = hinge_stiffness_by_elements({.ligament = height,
                                                        .slot_width = 0.0,
                                                        .height = height + 1e-9,
                                                        .half_length = half_length,
                                                        .poisson_ratio = 0.4},
                                                       3);
  // A sliver of 1e-9 above the ligament is cut.
  EXPECT_NEAR(stiffness, height * height * height / 12.0 / (2.0 * half_length), 1e-6);
}

// The stress at the edge of a cut grows without bound, so displacements converge with the size of the elements there;
// each level shrinks them by a factor.
TEST(PlaneStrainElements, ConvergeAsTheyShrinkTowardsTheEdge) {
  double before = hinge_stiffness_by_elements(prototype(2.5), 4);
  double change_before = 0.0;
  for (const int levels : {8, 12, 16}) {
    const double now = hinge_stiffness_by_elements(prototype(2.5), levels);
    const double change = before - now;
    EXPECT_GT(change, 0.0) << "displacement elements are too stiff, coarser ones more";
    if (change_before > 0.0) {
      EXPECT_LT(change, 0.4 * change_before);
    }
    change_before = change;
    before = now;
  }
  EXPECT_LT(change_before, 1e-3 * before);
}

// Figures of an audit by elements of its own (N mm/rad, three digits); half a unit of the last and the 0.1 % of the
// mesh.
TEST(PlaneStrainElements, GiveTheAuditsFigures) {
  const double scale = plane_strain_modulus_times_width();
  const auto slit = [&](double height) { return scale * hinge_stiffness_by_elements(prototype(height), fine); };
  EXPECT_NEAR(slit(1.5), 4.36, 0.01);
  EXPECT_NEAR(slit(2.5), 12.28, 0.02);
  EXPECT_NEAR(slit(4.0), 32.8, 0.08);
  const auto slot = [&](double height) { return scale * hinge_stiffness_by_elements(prototype(height, 0.9), fine); };
  EXPECT_NEAR(slot(1.5), 3.06, 0.01);
  EXPECT_NEAR(slot(2.5), 9.83, 0.02);
  EXPECT_NEAR(slot(4.0), 28.5, 0.08);
}

// Cores of 20 mm, 0.25 mm above the bottom layer and 0.3 mm from the slit: 21, 28 and 38 % stiffer than rubber all
// through. The audit's 5.16, 15.65 and 45.1 are 2.3, 0.8 and 0.2 % below; where its cores end below was not stated, and
// 0.05 mm higher is worth 1.4 %.
TEST(PlaneStrainElements, GiveWhatStiffCoresAdd) {
  const double scale = plane_strain_modulus_times_width();
  const auto cored = [&](double height) {
    HingeBlock block = prototype(height);
    block.core = HingeBlock::Core{.wall = 0.3, .bottom = height + 0.25, .top = height + 20.25};
    return scale * hinge_stiffness_by_elements(block, fine);
  };
  EXPECT_NEAR(cored(1.5), 5.16, 0.025 * 5.16);
  EXPECT_NEAR(cored(2.5), 15.65, 0.010 * 15.65);
  EXPECT_NEAR(cored(4.0), 45.1, 0.005 * 45.1);
}

// 15.8 = 24 * 0.66 is the limit of a fit by the handbook's authors, good to about 0.5 %; the mesh errs by 0.1 %.
TEST(LigamentStiffness, IsTheElementsForADeepSlit) {
  EXPECT_NEAR(deep_compliance(0.0) / 15.8, 1.0, 2e-3);
}

TEST(LigamentStiffness, IsTheElementsForSlotsUpToFourTimesItsHeight) {
  for (const double slot : {0.03, 0.07, 0.15, 0.28, 0.5, 0.8, 1.5, 3.0, 4.0})
    EXPECT_NEAR(deep_compliance(slot) / law_compliance(slot), 1.0, 1.5e-3) << "slot over ligament " << slot;
}

// A bottom layer of its own silicone under a softer or a stiffer body.
TEST(LigamentStiffness, IsTheElementsForABodyOfAnotherRubber) {
  const auto compliances = [](double above, double slot) {
    const double elements = 1.0 / hinge_stiffness_by_elements({.ligament = 1.0,
                                                               .slot_width = slot,
                                                               .height = 60.0,
                                                               .half_length = 80.0,
                                                               .poisson_ratio = poisson,
                                                               .modulus_above = above},
                                                              fine);
    const double law =
        1.0 / ligament_stiffness(
                  {.width = 1.0, .height = 1.0, .slot_width = slot},
                  {.young_modulus = 1.0 - poisson * poisson, .poisson_ratio = poisson, .modulus_above = above});
    return law / elements;
  };
  for (const double above : {0.1, 0.5, 10.0}) EXPECT_NEAR(compliances(above, 0.0), 1.0, 0.015) << above;
  for (const double above : {0.1, 10.0}) EXPECT_NEAR(compliances(above, 0.36), 1.0, 0.035) << above;
}

// What the law leaves out in the prototype's body: its finite height and the planes of its neighbours.
TEST(LigamentStiffness, IsASoftBoundInTheBodyOfTheFinger) {
  const double scale = plane_strain_modulus_times_width();
  const auto excess = [&](double height) {
    return scale * hinge_stiffness_by_elements(prototype(height), fine) /
               (1e3 *
                ligament_stiffness({.width = 22e-3, .height = height * 1e-3, .slot_width = 0.0},
                                   {.young_modulus = young_modulus_from_shore_a(28.0), .poisson_ratio = poisson})) -
           1.0;
  };
  EXPECT_NEAR(excess(1.5), 0.01, 0.005);
  EXPECT_NEAR(excess(2.5), 0.02, 0.005);
  EXPECT_NEAR(excess(4.0), 0.065, 0.005);
}

}  // namespace
}  // namespace coilwright::mechanics
