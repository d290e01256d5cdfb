#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/data/run.hpp"
#include "measurement/random_numbers.hpp"

namespace coilwright::measurement {

// A ball on a string that is let go: m l^2 theta'' = -m g l sin(theta) - d theta' - f sign(theta') - q theta' |theta'|,
// by Runge and Kutta in steps of 0.1 ms.
struct Ball {
  double length = 0.332;   // m
  double damping = 6e-5;   // N m s/rad
  double angle = 0.9;      // rad
  double rate = 0.0;       // rad/s
  double mass = 0.015;     // kg
  double noise = 0.00873;  // rad
  double friction = 0.0;   // N m
  double drag = 0.0;       // N m s2/rad2

  [[nodiscard]] data::Run filmed(double duration, double pictures_a_second, unsigned seed) const {
    data::Run run{.name = "swing.csv",
                  .kind = data::RunKind::transient,
                  .drive = data::Drive::torque,
                  .start = data::Start::free,
                  .channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}}};
    Normal normal(seed);
    const double inertia = mass * length * length;
    const auto acceleration = [&](double theta, double omega) {
      const double braking = damping * omega + std::copysign(friction, omega) + drag * omega * std::abs(omega);
      return -9.81 / length * std::sin(theta) - braking / inertia;
    };
    double theta = angle;
    double omega = rate;
    constexpr double step = 1e-4;
    double time = 0.0;
    for (int i = 0; i <= duration * pictures_a_second; ++i) {
      const double stamp = i / pictures_a_second;
      while (time < stamp - 0.5 * step) {
        const double k1 = acceleration(theta, omega);
        const double k2 = acceleration(theta + 0.5 * step * omega, omega + 0.5 * step * k1);
        const double k3 = acceleration(theta + 0.5 * step * (omega + 0.5 * step * k1), omega + 0.5 * step * k2);
        const double k4 = acceleration(theta + step * (omega + 0.5 * step * k2), omega + step * k3);
        theta += step * (omega + step * (k1 + k2 + k3) / 6.0);
        omega += step * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
        time += step;
      }
      run.times.push_back(stamp);
      run.inputs.push_back({0.0});
      run.channels.front().values.push_back(theta + noise * normal());
    }
    return run;
  }
};

// As it is declared; damping and length are fitted.
inline formats::DeclaredActuator declared_ball(double length, double damping) {
  static const std::vector<std::string> calibrated{"joint_damping", "/links/0/com_along_m"};
  return formats::parse_declared_actuator(fmt::format(R"({{"format": "lumped-model/1", "gravity_m_s2": 9.81,
                       "links": [{{"length_m": {0}, "com_along_m": {0}, "com_offset_m": 0, "mass_kg": 0.015,
                                   "inertia_kgm2": 0}}],
                       "joints": [{{"stiffness_Nm_rad": 0, "damping_Nms_rad": {1}}}]}})",
                                                      length, damping),
                                          "ball.json", {.names = calibrated, .file = "dataset.json", .tolerances = {}});
}

}  // namespace coilwright::measurement
