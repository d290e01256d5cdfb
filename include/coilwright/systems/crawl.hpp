#pragma once

#include <vector>

#include "coilwright/systems/crawler.hpp"

namespace coilwright::systems {

/// Duration and time step of a robot's motion.
struct CrawlTiming {
  int settling_periods = 10;  ///< from lying still, not counted; >= 0
  int periods = 20;           ///< counted; >= 1
  double step = 5e-5;         ///< longest time step, s; finite, > 0, at most 1 ms: each switching falls on one
};

/// Mean powers over the counted periods, W. Input equals output except for `unbalanced`.
struct CrawlPowers {
  double electrical{};  ///< out of the cell
  double copper{};      ///< heat of the coils
  double leads{};       ///< heat of switch and leads
  double mechanical{};  ///< from the coils to the chain: electrical less copper and leads
  double hinges{};      ///< lost in the dampers of hinges and faces
  double friction{};    ///< lost by sliding feet
  double impacts{};     ///< lost where feet land
  double stored{};      ///< increase of kinetic, potential and elastic energy
  double unbalanced{};  ///< mechanical less the four before: error of the time steps
};

/// The motion of a robot that has settled.
struct Crawl {
  double speed{};                ///< mean, m/s, positive towards the fingertip
  double speed_scatter{};        ///< standard deviation of the speeds of single periods, m/s
  double pulse_current{};        ///< current of one coil while closed and nothing moves, A
  double mean_current{};         ///< out of the cell, A
  double run_time{};             ///< on one charge at this current and the cell's full voltage, s
  double distance_per_charge{};  ///< m; negative if it crawls backwards
  double largest_bending{};      ///< sum of the joint angles, rad
  double smallest_bending{};     ///< rad
  std::vector<double> lifts;     ///< greatest height of each contact point (Crawler::contact_points), m
  CrawlPowers powers{};
};

/// Follows the robot from lying straight and still: Moreau's midpoint rule with springs, dampers and induced voltages
/// taken implicitly. Currents follow voltage and motion at once (L / R is 0.3 ms in the prototype, beside pulses of 50
/// ms); coils are at 20 degC; the cell keeps its voltage. Pure. Throws std::invalid_argument naming field, rule and
/// value.
[[nodiscard]] Crawl crawl(const Crawler& crawler, const CrawlTiming& timing = {});

}  // namespace coilwright::systems
