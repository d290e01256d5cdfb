// The crawler by another method: contact as stiff springs and dampers, friction as a steep function of the sliding
// speed, the whole integrated by classical Runge-Kutta. It shares the mass matrix and the torque curves with the code
// under test, and neither contact, nor time stepping, nor circuit.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "coilwright/systems/crawl.hpp"
#include "coilwright/systems/validation/paper_finger.hpp"

namespace coilwright::systems {
namespace {

using Eigen::VectorXd;

struct Ground {
  double stiffness;  // N/m of a foot
  double damping;    // N s/m
  double slip;       // m/s at which friction has three quarters of its value
};

// d(position, velocity)/dt
VectorXd slope_of(const Crawler& crawler, const Ground& ground, bool closed, const VectorXd& state) {
  const int n = crawler.chain().coordinates(), joints = crawler.model().joints(), coils = crawler.model().coils();
  const mechanics::CoordinateVector position = state.head(n), velocity = state.tail(n);
  const mechanics::JointVector angles = position.tail(joints), rates = velocity.tail(joints);
  const actuator::Model& model = crawler.model();

  actuator::CoilCurrents currents = model.all_coils(0.0);
  if (closed) {  // the loop equations as a linear system: R I_c + r sum I + induced = U
    Eigen::MatrixXd loops = Eigen::MatrixXd::Constant(coils, coils, crawler.parts().drive.lead_resistance);
    loops.diagonal().array() += crawler.coil_resistance();
    VectorXd voltages(coils);
    for (int c = 0; c < coils; ++c) {
      actuator::CoilCurrents one = model.all_coils(0.0);
      one[c] = 1.0;
      const double induced =
          (model.magnetic_torques(angles, one) - model.magnetic_torques(angles, model.all_coils(0.0))).dot(rates);
      voltages[c] = crawler.parts().cell.voltage - induced;
    }
    currents = loops.partialPivLu().solve(voltages);
  }
  const mechanics::FloatingFrames frames = crawler.chain().frames(position);
  mechanics::CoordinateVector force =
      -crawler.chain().velocity_forces(frames, velocity) - crawler.chain().gravity_forces(frames);
  force.tail(joints) += model.torques(angles, rates, currents);
  for (const mechanics::LinkPoint& point : crawler.contact_points()) {
    const Eigen::Vector2d at = crawler.chain().position(frames, point);
    if (at.y() >= 0.0) continue;
    const mechanics::FloatingJacobian rows = crawler.chain().jacobian(frames, point);
    const Eigen::Vector2d speed = rows * velocity;
    const double normal = std::max(0.0, -ground.stiffness * at.y() - ground.damping * speed.y());
    const FootFriction& friction = crawler.parts().friction;
    const double along = std::tanh(speed.x() / ground.slip);  // forwards is -x
    const double tangential = -(along > 0.0 ? friction.backwards : friction.forwards) * normal * along;
    force += rows.transpose() * Eigen::Vector2d(tangential, normal);
  }
  VectorXd out(2 * n);
  out.head(n) = velocity;
  out.tail(n) = crawler.chain().mass_matrix(frames).llt().solve(force);
  return out;
}

double speed_by_penalty(const Crawler& crawler, const Ground& ground, double step, int settling, int periods) {
  const int n = crawler.chain().coordinates();
  VectorXd state = VectorXd::Zero(2 * n);
  state.head(n) = crawler.lying();
  double from = 0.0;
  const double period = 1.0 / crawler.parts().drive.frequency;
  for (int k = 0; k < settling + periods; ++k) {
    if (k == settling) from = state[0];
    for (const bool closed : {true, false}) {
      const int steps = static_cast<int>(std::lround(0.5 * period / step));
      for (int i = 0; i < steps; ++i) {
        const VectorXd a = slope_of(crawler, ground, closed, state);
        const VectorXd b = slope_of(crawler, ground, closed, state + 0.5 * step * a);
        const VectorXd c = slope_of(crawler, ground, closed, state + 0.5 * step * b);
        const VectorXd d = slope_of(crawler, ground, closed, state + step * c);
        state += step / 6.0 * (a + 2.0 * b + 2.0 * c + d);
      }
    }
  }
  return (from - state[0]) / (periods * period);
}

TEST(Crawl, HasTheSpeedThatAPenaltyMethodFinds) {
  const actuator::Design design = validation::paper_finger();
  CrawlerParts parts;
  parts.friction = {.forwards = 0.3, .backwards = 0.6};
  const Crawler crawler(design, actuator::assemble_or_throw(design), parts);
  const double speed = crawl(crawler, {.settling_periods = 5, .periods = 6, .step = 5e-5}).speed;
  // Feet of 20 N/mm sink 10 um under the robot, and are damped so that they land without a rebound, as Moreau's do
  // (with a quarter of this damping the robot is 5 % faster). What is left is the width of the law of friction: feet
  // that hold creep at up to `slip`, against the way. Half the width, less than half the difference.
  const auto penalty = [&](double slip, double step) {
    return speed_by_penalty(crawler, {.stiffness = 2e4, .damping = 160.0, .slip = slip}, step, 5, 6);
  };
  const double wide = penalty(1e-3, 5e-6) / speed - 1.0;
  const double narrow = penalty(5e-4, 2.5e-6) / speed - 1.0;
  RecordProperty("wide", std::to_string(wide));
  RecordProperty("narrow", std::to_string(narrow));
  EXPECT_LT(std::abs(narrow), 0.5 * std::abs(wide));
  EXPECT_LT(std::abs(narrow), 0.01);
}

// Away from the 10 Hz at which the robot hops in step with its pulses, equal friction included, where nothing but
// inertia decides which end slides. docs/theory/systems.md has what becomes of it at 10 Hz.
TEST(Crawl, HasThatSpeedAtOtherFrequenciesAndFrictionsToo) {
  const actuator::Design design = validation::paper_finger();
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  struct Case {
    double frequency, backwards;
  };
  for (const Case& each : {Case{8.0, 0.3}, Case{12.0, 0.4}}) {
    CrawlerParts parts;
    parts.friction = {.forwards = 0.3, .backwards = each.backwards};
    parts.drive.frequency = each.frequency;
    const Crawler crawler(design, assembly, parts);
    const double speed = crawl(crawler, {.settling_periods = 4, .periods = 4, .step = 5e-5}).speed;
    const Ground ground{.stiffness = 2e4, .damping = 160.0, .slip = 5e-4};
    // Feet that hold creep at up to 0.5 mm/s, a third of the time each: less than 0.35 mm/s.
    EXPECT_NEAR(speed_by_penalty(crawler, ground, 3e-6, 4, 4), speed, 0.35e-3) << each.frequency;
  }
}

}  // namespace
}  // namespace coilwright::systems
