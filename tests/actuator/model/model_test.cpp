#include "coilwright/actuator/model/model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"

namespace coilwright::actuator {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;

Assembly assembled_finger(Configuration configuration,
                          magnetics::Fidelity torque = magnetics::Fidelity::line_of_centres) {
  Design design = paper_finger();
  design.layout = layout_of(configuration);
  design.choices.torque = torque;
  design.choices.masses = SegmentMass::rigid_bodies;
  return assemble_or_throw(design);
}

JointVector uneven(int n) {
  JointVector out(n);
  for (int j = 0; j < n; ++j) out[j] = 0.31 + 0.17 * std::sin(2.3 * j);
  return out;
}

CoilCurrents uneven_currents(int n) {
  CoilCurrents out(n);
  for (int i = 0; i < n; ++i) out[i] = 0.9 - 0.35 * i;
  return out;
}

TEST(Model, HasTheStiffnessThatItsResidualShows) {
  Design oriented = paper_finger();  // distant pairs with the directions of their dipoles
  oriented.layout = layout_of(Configuration::D);
  oriented.choices.winding = magnetics::CurrentDistribution::uniform;
  oriented.choices.torque = magnetics::Fidelity::exact;
  for (const Assembly& a : {assembled_finger(Configuration::B), assembled_finger(Configuration::C),
                            assembled_finger(Configuration::D), assemble_or_throw(oriented)}) {
    const int n = a.model.joints();
    const CoilCurrents currents = uneven_currents(a.coils);
    JointVector angles = uneven(n);
    angles[0] = a.model.hinges()[0].contact.closing_angle - 0.003;  // one joint on its stop
    const JointMatrix stiffness = a.model.tangent_stiffness(angles, currents);
    constexpr double step = 1e-5;
    for (int j = 0; j < n; ++j) {
      JointVector ahead = angles;
      JointVector behind = angles;
      ahead[j] += step;
      behind[j] -= step;
      const JointVector slope =
          (a.model.static_residual(behind, currents) - a.model.static_residual(ahead, currents)) / (2.0 * step);
      // Central differences: step^2 of the torque's third derivative, and 1e-16 / step of a stop's 75 N m/rad.
      for (int i = 0; i < n; ++i) EXPECT_NEAR(stiffness(i, j), slope[i], 1e-7) << i << j;
    }
  }
}

// Everything but damping comes from an energy.
TEST(Model, HasASymmetricStiffness) {
  const Assembly a = assembled_finger(Configuration::D);
  const JointMatrix stiffness = a.model.tangent_stiffness(uneven(5), uneven_currents(4));
  EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-5 * stiffness.norm());  // curves of 1e-6
}

TEST(Model, ReversesMagneticsWithPolarityAndCurrent) {
  Design design = paper_finger();
  design.layout = layout_of(Configuration::C);
  const Assembly plain = assemble_or_throw(design);
  for (Component& component : design.layout)
    if (component.kind == ComponentKind::coil) component.polarity = -1;
  const Assembly turned = assemble_or_throw(design);
  const JointVector angles = uneven(4);
  const JointVector rates = JointVector::Constant(4, 0.7);
  const JointVector forward = plain.model.torques(angles, rates, uneven_currents(3));
  const JointVector backward = turned.model.torques(angles, rates, -uneven_currents(3));
  for (int j = 0; j < 4; ++j) EXPECT_DOUBLE_EQ(forward[j], backward[j]);
}

TEST(Model, AcceleratesByTorquesAndWhatIsApplied) {
  const Assembly a = assembled_finger(Configuration::B);
  const JointVector angles = uneven(2);
  const JointVector rates = JointVector::Constant(2, -3.1);
  const CoilCurrents currents = uneven_currents(2);
  JointVector applied(2);
  applied << 2e-3, -5e-3;
  JointVector acceleration(2);
  a.model.derivative(angles, rates, {}, currents, applied, acceleration, {});
  const mechanics::PlanarChain& chain = a.model.chain();
  const JointVector balance = chain.mass_matrix(angles) * acceleration + chain.velocity_torques(angles, rates) +
                              chain.gravity_torques(angles) - a.model.torques(angles, rates, currents) - applied;
  EXPECT_LT(balance.lpNorm<Eigen::Infinity>(), 1e-15);  // of torques of 1e-2: rounding
}

TEST(Model, TellsMagneticsAndHingesApartAsBenchesDo) {
  const Assembly a = assembled_finger(Configuration::B);
  const JointVector angles = uneven(2);
  const CoilCurrents currents = uneven_currents(2);
  const JointVector still = JointVector::Zero(2);
  const JointVector springs = a.model.hinge_torques(angles);
  const JointVector magnets = a.model.magnetic_torques(angles, currents);
  for (int j = 0; j < 2; ++j) EXPECT_DOUBLE_EQ(springs[j], -a.model.hinges()[j].stiffness * angles[j]);
  EXPECT_LT((springs + magnets - a.model.torques(angles, still, currents)).norm(), 1e-18);
  EXPECT_GT(magnets.minCoeff(), 0.0);
}

TEST(Model, DampsMoreWhereAStopIsPressed) {
  const Assembly a = assembled_finger(Configuration::B);
  const Hinge& hinge = a.model.hinges()[1];
  JointVector angles = uneven(2);
  EXPECT_EQ(a.model.damping(angles)[1], hinge.damping);
  angles[1] = hinge.contact.closing_angle - 1e-3;
  EXPECT_EQ(a.model.damping(angles)[1], hinge.damping + hinge.contact.damping);
  EXPECT_EQ(a.model.damping(angles)[0], hinge.damping);
}

Model::Spec lumped() {
  const Assembly a = assembled_finger(Configuration::C);
  return {.chain = a.model.chain(),
          .hinges = a.model.hinges(),
          .magnetics = a.model.magnetics(),
          .coils = 3,
          .tip = a.model.tip()};
}

template <typename Change>
std::string spec_refusal(Change&& change) {
  Model::Spec spec = lumped();
  change(spec);
  return error_text([&] { (void)Model(spec); });
}

void replace_pairs(Model::Spec& spec, const HingePair& hinge, const DistantPair& distant) {
  spec.magnetics = MagneticStage({hinge}, {distant});
}

TEST(Model, SaysWhichHingeBreaksWhichRule) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(spec_refusal([](Model::Spec& s) { s.hinges.pop_back(); }), "hinges: one per joint, 4 here; got 3");
  EXPECT_EQ(spec_refusal([](Model::Spec& s) { s.coils = -2; }), "coils must be >= 0; got -2");
  EXPECT_EQ(spec_refusal([](Model::Spec& s) { s.hinges[2].stiffness = -1.0; }),
            "joint 2: stiffness must be finite and >= 0; got -1");
  EXPECT_EQ(spec_refusal([&](Model::Spec& s) { s.hinges[1].damping = nan; }),
            "joint 1: damping must be finite and >= 0; got nan");
  EXPECT_EQ(spec_refusal([](Model::Spec& s) { s.hinges[0].contact.stiffness = -4.0; }),
            "joint 0: contact stiffness must be finite and >= 0; got -4");
  EXPECT_EQ(spec_refusal([](Model::Spec& s) { s.hinges[0].contact.damping = -4.0; }),
            "joint 0: contact damping must be finite and >= 0; got -4");
  EXPECT_EQ(spec_refusal([&](Model::Spec& s) { s.hinges[3].torque_offset = nan; }),
            "joint 3: torque_offset must be finite; got nan");
  EXPECT_EQ(spec_refusal([](Model::Spec& s) { s.tip.link = 4; }), "tip: link must be -1 to 3; got 4");
}

TEST(Model, SaysWhichPairBreaksWhichRule) {
  const MagneticStage good = lumped().magnetics;
  const HingePair hinge = good.hinge_pairs().front();
  const DistantPair distant = good.distant_pairs().front();
  const auto after = [&](auto&& change) {
    HingePair h = hinge;
    DistantPair d = distant;
    change(h, d);
    return spec_refusal([&](Model::Spec& s) { replace_pairs(s, h, d); });
  };
  EXPECT_EQ(after([](HingePair&, DistantPair&) {}), "");
  EXPECT_EQ(after([](HingePair& h, DistantPair&) { h.joint = 4; }), "magnetics: joint 4 and coil 0 must exist");
  EXPECT_EQ(after([](HingePair& h, DistantPair&) { h.coil = 3; }), "magnetics: joint 0 and coil 3 must exist");
  EXPECT_EQ(after([](HingePair& h, DistantPair&) { h.torque_per_ampere.reset(); }),
            "magnetics: a hinge pair must have its curve; got none");
  EXPECT_EQ(after([](HingePair&, DistantPair& d) { d.second.link = -1; }),
            "magnetics: links of a distant pair must rise from -1 to 3; got -1 and -1");
  EXPECT_EQ(after([](HingePair&, DistantPair& d) { d.coil = 3; }),
            "magnetics: coil of a distant pair must be -1 to 2; got 3");
  EXPECT_EQ(after([](HingePair&, DistantPair& d) { d.axial_energy.reset(); }),
            "magnetics: a distant pair must have both its curves; got fewer");
}

}  // namespace
}  // namespace coilwright::actuator
