#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"
#include "measurement/random_numbers.hpp"

namespace coilwright::measurement {

// A mass on a slide with viscous friction, m x'' = u - d x': a link of unit length without gravity.
inline constexpr double true_mass = 2.0;
inline constexpr double true_damping = 3.0;
inline constexpr double noise_sigma = 1e-3;  // m, which is rad here
inline constexpr double interval = 0.01;

inline replay::DeclaredModel slide(double mass, double damping) {
  return {.calibration = {{.key = "mass",
                           .declared = mass,
                           .lower = 1e-3,
                           .upper = std::numeric_limits<double>::infinity(),
                           .scale = mass},
                          {.key = "damping",
                           .declared = damping,
                           .lower = 0.0,
                           .upper = std::numeric_limits<double>::infinity(),
                           .scale = damping}},
          .build = [](std::span<const double> values) {
            const mechanics::Link link{
                .length = 1.0, .com_along = 1.0, .com_offset = 0.0, .mass = values[0], .inertia = 0.0};
            return actuator::ModelSpec{.chain = mechanics::PlanarChain(std::span(&link, 1), 0.0),
                                       .hinges = {actuator::Hinge{.damping = values[1]}},
                                       .magnetics = {},
                                       .coils = 0,
                                       .tip = {}};
          }};
}

// A slide with a wall that the true one, which never moves below 0, does not have.
inline replay::DeclaredModel slide_with_wall(double mass, double damping, double wall) {
  replay::DeclaredModel declared = slide(mass, damping);
  constexpr double tolerance = 0.05;
  declared.calibration.push_back({.key = "wall",
                                  .declared = wall,
                                  .lower = -1.0,
                                  .upper = 1.0,
                                  .scale = tolerance,
                                  .tolerance = replay::Tolerance{.deviation = tolerance},
                                  .calibrated = false});
  declared.build = [free = declared.build](std::span<const double> values) {
    actuator::ModelSpec spec = free(values);
    spec.hinges.front().contact = {.closing_angle = values[2], .stiffness = 1e3, .damping = 1.0};
    return spec;
  };
  return declared;
}

struct Place {
  double position{};
  double speed{};
};

// Where the slide is after `time` under a constant force: the solution in closed form.
inline Place slid(Place from, double force, double time) {
  const double end_speed = force / true_damping;
  const double decay = std::exp(-true_damping / true_mass * time);
  return {.position =
              from.position + end_speed * time + (from.speed - end_speed) * (1.0 - decay) * true_mass / true_damping,
          .speed = end_speed + (from.speed - end_speed) * decay};
}

// Forces in alternating directions that change every half second.
inline double force_at(std::size_t sample) {
  const std::size_t step = sample / 50;
  return (step % 2 == 0 ? 2.0 : -1.5) + 0.1 * static_cast<double>(step);
}

inline data::Run slide_run(std::size_t samples, Place start, const std::function<double()>& error) {
  data::Run run{.name = "slide.csv",
                .kind = data::RunKind::transient,
                .drive = data::Drive::torque,
                .sigma = noise_sigma,
                .channels = {{.name = "theta1_rad", .kind = data::ChannelKind::joint_angle}}};
  Place place = start;
  for (std::size_t i = 0; i < samples; ++i) {
    run.times.push_back(interval * static_cast<double>(i));
    run.inputs.push_back({force_at(i)});
    run.channels.front().values.push_back(place.position + error());
    place = slid(place, force_at(i), interval);
  }
  return run;
}

inline double no_error() {
  return 0.0;
}

// A slide with a drag in the square of its speed besides, by the midpoint rule in steps of 0.1 ms, and normal noise.
inline data::Run dragged_run(std::size_t samples, double drag, double sigma, unsigned seed) {
  data::Run run = slide_run(samples, {}, no_error);
  run.sigma = sigma;
  Normal normal(seed);
  Place place;
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    run.channels.front().values[i] = place.position + sigma * normal();
    constexpr int parts = 100;
    for (int part = 0; part < parts; ++part) {
      const auto acceleration = [&](double speed) {
        return (force_at(i) - true_damping * speed - drag * speed * std::abs(speed)) / true_mass;
      };
      const double step = interval / parts;
      const double middle = place.speed + 0.5 * step * acceleration(place.speed);
      place.speed += step * acceleration(middle);
      place.position += step * middle;
    }
  }
  return run;
}

// A slide under a force that grows with the square of its speed in the direction of motion, opposite to a drag.
inline data::Run pushed_run() {
  return dragged_run(200, -1.0, 0.1 * noise_sigma, 4);
}

}  // namespace coilwright::measurement
