#include "coilwright/mechanics/contact_impulses.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "error_text.hpp"
#include "mechanics/coordinates.hpp"

namespace coilwright::mechanics {
namespace {

// A point of mass m above the ground: x, y.
Contact ground(double along, double against) {
  return {.normal = coordinates({0.0, 1.0}), .tangent = coordinates({1.0, 0.0}), .friction = {along, against}};
}

TEST(ContactImpulses, StopASlowPointAndBrakeAFastOneByWhatFrictionGives) {
  const double m = 0.37;
  const CoordinateMatrix mass = m * CoordinateMatrix::Identity(2, 2);
  const std::vector<Contact> contacts{ground(0.3, 0.7)};
  const double fall = 0.05;  // m/s of weight in the step
  struct Case {
    double before, after;
  };
  for (const Case& each :
       {Case{0.01, 0.0}, Case{0.21, 0.21 - 0.3 * fall}, Case{-0.03, 0.0}, Case{-0.21, -0.21 + 0.7 * fall}}) {
    const ContactStep step = contact_impulses(mass, coordinates({each.before, -fall}), contacts);
    EXPECT_NEAR(step.velocities[0], each.after, 1e-15) << each.before;  // rounding of one division
    EXPECT_NEAR(step.velocities[1], 0.0, 1e-16);
    EXPECT_NEAR(step.impulses[0].normal, m * fall, 1e-16);
    EXPECT_NEAR(step.impulses[0].tangential, m * (each.after - each.before), 1e-16);
  }
}

TEST(ContactImpulses, LeaveAloneWhatSeparates) {
  const CoordinateMatrix mass = 0.4 * CoordinateMatrix::Identity(2, 2);
  const ContactStep step = contact_impulses(mass, coordinates({0.2, 0.1}), std::vector<Contact>{ground(0.3, 0.3)});
  EXPECT_EQ(step.velocities, coordinates({0.2, 0.1}));
  EXPECT_EQ(step.impulses[0].normal, 0.0);
}

TEST(ContactImpulses, OfALandingKeepHorizontalMomentumWithoutFriction) {
  // A rod that lands on one end: x, y, angle. Impulse by hand: m v / (1 + (l/2)^2 m / J cos^2).
  const double m = 0.08, inertia = 3e-5, half = 0.03, angle = 0.4;
  CoordinateMatrix mass = CoordinateMatrix::Zero(3, 3);
  mass.diagonal() = coordinates({m, m, inertia});
  const double arm = half * std::cos(angle);
  const Contact end{.normal = coordinates({0.0, 1.0, arm}),
                    .tangent = coordinates({1.0, 0.0, -half * std::sin(angle)}),
                    .friction = {}};
  const ContactStep step = contact_impulses(mass, coordinates({0.6, -1.1, 0.0}), std::vector<Contact>{end});
  EXPECT_DOUBLE_EQ(step.velocities[0], 0.6);
  EXPECT_NEAR(step.impulses[0].normal, m * 1.1 / (1.0 + arm * arm * m / inertia), 1e-15);
}

// All conditions of contact and friction, written as they are defined and not as they are solved.
void expect_all_conditions(const CoordinateMatrix& mass, const CoordinateVector& free,
                           const std::vector<Contact>& contacts) {
  const ContactStep step = contact_impulses(mass, free, contacts);
  CoordinateVector momentum = mass * (step.velocities - free);
  const double energy = 0.5 * step.velocities.dot(mass * step.velocities) - 0.5 * free.dot(mass * free);
  const double scale = free.norm();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactImpulse& impulse = step.impulses[i];
    const auto [along, against] = contacts[i].friction;
    momentum -= impulse.normal * contacts[i].normal + impulse.tangential * contacts[i].tangent;
    const double opening = contacts[i].normal.dot(step.velocities);
    const double sliding = contacts[i].tangent.dot(step.velocities);
    EXPECT_GE(impulse.normal, 0.0);
    EXPECT_GT(opening, -1e-7 * scale);  // 1e-8 is what is promised of rows of norm sqrt(5)
    EXPECT_LT(std::min(impulse.normal, opening), 1e-7 * scale);
    EXPECT_LE(impulse.tangential, against * impulse.normal * (1.0 + 1e-9) + 1e-12);
    EXPECT_GE(impulse.tangential, -along * impulse.normal * (1.0 + 1e-9) - 1e-12);
    if (sliding > 1e-6 * scale) {
      EXPECT_NEAR(impulse.tangential, -along * impulse.normal, 1e-7 * scale);
    }
    if (sliding < -1e-6 * scale) {
      EXPECT_NEAR(impulse.tangential, against * impulse.normal, 1e-7 * scale);
    }
  }
  EXPECT_LT(momentum.norm(), 1e-8 * scale);
  EXPECT_LT(energy, 1e-9);  // contacts only take energy
}

// Random problems, and ones with more contacts than can be told apart.
TEST(ContactImpulses, KeepEveryConditionOnRandomProblems) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(generator); };
  for (const int count : {1, 2, 4}) {
    for (const bool dependent : {false, true}) {
      for (int run = 0; run < 2000; ++run) {
        const Eigen::MatrixXd root = Eigen::MatrixXd::NullaryExpr(5, 5, draw);
        const CoordinateMatrix mass = 0.03 * (root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(5, 5));
        std::vector<Contact> contacts(count);
        for (int i = 0; i < count; ++i) {
          Contact& contact = contacts[i];
          contact.friction = {.along = 0.3, .against = 0.7};
          contact.normal = CoordinateVector::NullaryExpr(5, draw);
          contact.tangent = CoordinateVector::NullaryExpr(5, draw);
          if (dependent && i > 0) contact.tangent = contacts[0].tangent;
          if (dependent && i > 1) contact.normal = 2.0 * contacts[i - 1].normal - contacts[i - 2].normal;
        }
        CoordinateVector free = CoordinateVector::NullaryExpr(5, draw);
        if (dependent) {  // as bodies do that lie still: every sliding speed zero, or all of them alike
          free = -0.1 * contacts[0].normal;
          if (count > 1) free -= 0.1 * contacts[1].normal;
        }
        expect_all_conditions(mass, free, contacts);
      }
    }
  }
}

// A beam on four supports in a row, which two would hold: how they share the weight is not determined, the motion is.
TEST(ContactImpulses, HoldABodyThatStandsOnMoreThanItNeeds) {
  const double weight = 0.9;
  CoordinateMatrix mass = CoordinateMatrix::Zero(3, 3);
  mass.diagonal() = coordinates({0.5, 0.5, 2e-3});
  std::vector<Contact> contacts;
  for (const double x : {-0.03, -0.01, 0.02, 0.05})
    contacts.push_back(
        {.normal = coordinates({0.0, 1.0, x}), .tangent = coordinates({1.0, 0.0, 0.0}), .friction = {0.4, 0.4}});
  const ContactStep step = contact_impulses(mass, coordinates({0.1, -weight, 0.0}), contacts);
  EXPECT_LT(step.velocities.norm(), 1e-14);
  double sum = 0.0, moment = 0.0;
  for (int i = 0; i < 4; ++i) {
    sum += step.impulses[i].normal;
    moment += step.impulses[i].normal * contacts[i].normal[2];
  }
  EXPECT_NEAR(sum, 0.5 * weight, 1e-14);
  EXPECT_NEAR(moment, 0.0, 1e-15);
}

// Feet on two links whose joint is almost level slide almost alike. Lemke's method alone leaves 2e-8 of the speed
// there.
TEST(ContactImpulses, TellContactsApartThatAreAlmostAlike) {
  CoordinateMatrix mass = CoordinateMatrix::Zero(4, 4);
  mass.diagonal() = coordinates({0.09, 0.09, 6e-5, 7e-6});
  for (const double tilt : {1e-3, 1e-5, 1e-7, 1e-9}) {
    std::vector<Contact> contacts;
    for (const double x : {-0.04, -0.01, 0.004, 0.03})
      contacts.push_back({.normal = coordinates({0.0, 1.0, x, x > 0.0 ? x : 0.0}),
                          .tangent = coordinates({1.0, 0.0, 1e-3 + tilt * x, x > 0.0 ? 1e-3 - tilt * x : 0.0}),
                          .friction = {.along = 0.6, .against = 0.062}});
    for (const double sliding : {-0.024, 1e-4, 0.0}) {
      const ContactStep step = contact_impulses(mass, coordinates({sliding, -1e-3, 2e-4, -1e-4}), contacts);
      for (int i = 0; i < 4; ++i) {
        EXPECT_GE(step.impulses[i].normal, 0.0);
        EXPECT_GT(step.impulses[i].normal_speed, -1e-9);  // 1e-8 of the largest speed, and a tenth of that
      }
    }
  }
}

// Two fingers press a glass onto a smooth table, in a step of the study lightest_gripper that once ended the
// evaluation: what the table does is hardly told from what both fingers do. Given by what every impulse does to every
// speed.
TEST(ContactImpulses, PressABodyOntoASmoothTable) {
  Eigen::MatrixXd response(6, 6);
  response << 0.587898693761, -0.317953066699, -0.190892225852, 0.0766649137178, 0.349220975319, -0.431983333401,  //
      -0.317953066699, 0.587811395706, -0.190909336455, -0.349220975319, -0.0766354186703, 0.431975771868,         //
      -0.190892225852, -0.190909336455, 0.472281105092, 0.431983333401, -0.431975771868, 0.0,                      //
      0.0766649137178, -0.349220975319, 0.431983333401, 1.46761446361, 0.626513166473, 0.753637673596,             //
      0.349220975319, -0.0766354186703, -0.431975771868, 0.626513166473, 1.46755102656, 0.753589205275,            //
      -0.431983333401, 0.431975771868, 0.0, 0.753637673596, 0.753589205275, 1.41684331528;
  const CoordinateVector speeds =
      coordinates({-0.175177481898, -0.174851018774, -0.747314598974, -1.0, 0.999906725452, -2.22238870682e-05});
  // Rows whose products are that response, with a mass of one; velocities that give these speeds.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(response);
  const Eigen::MatrixXd rows =
      solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal().toDenseMatrix();
  const CoordinateVector free = Eigen::MatrixXd(rows).completeOrthogonalDecomposition().solve(speeds);
  std::vector<Contact> contacts;
  for (int i = 0; i < 3; ++i)
    contacts.push_back({.normal = rows.row(i).transpose(),
                        .tangent = rows.row(3 + i).transpose(),
                        .friction = i < 2 ? DirectionalFriction{0.8, 0.8} : DirectionalFriction{}});
  expect_all_conditions(CoordinateMatrix::Identity(6, 6), free, contacts);
}

TEST(ContactImpulses, RefuseWhatIsNoContact) {
  const CoordinateMatrix mass = CoordinateMatrix::Identity(2, 2);
  const CoordinateVector still = coordinates({0.0, 0.0});
  const auto refuse = [&](const Contact& contact, const std::string& text) {
    EXPECT_EQ(error_text([&] { (void)contact_impulses(mass, still, std::vector<Contact>{contact}); }), text);
  };
  refuse(ground(-0.1, 0.2), "contact 0: friction.along must be finite and >= 0; got -0.1");
  refuse(ground(0.1, std::nan("")), "contact 0: friction.against must be finite and >= 0; got nan");
  refuse({.normal = coordinates({1.0}), .tangent = coordinates({0.0, 1.0}), .friction = {}},
         "contact 0: rows must have 2 entries; got 1 and 2");
}

}  // namespace
}  // namespace coilwright::mechanics
