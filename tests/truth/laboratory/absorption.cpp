#include "truth/laboratory/absorption.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "truth/laboratory/noise.hpp"
#include "truth/laboratory/recorded_run.hpp"
#include "truth/laboratory/run_keys.hpp"

namespace truth::laboratory {
namespace {

constexpr double slope_step = 0.25;  // of a standard deviation: the step of a slope
constexpr double change = 1e-3;      // of stiffness and damping

// The coefficients of a curve error for one standard deviation of each: as build_finger() draws them.
std::array<double, 4> curve_deviations(double tolerance) {
  std::array<double, 4> weights{1.0, 0.7, 0.49, 0.343};
  static constexpr std::array<double, 4> mean_squares{1.0 / 3.0, 7.0 / 15.0, 17.0 / 35.0, 31.0 / 63.0};
  double square = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) square += weights[i] * weights[i] * mean_squares[i];
  for (double& weight : weights) weight *= tolerance / std::sqrt(square);
  return weights;
}

}  // namespace

Absorption::Absorption(const Place& place) : place_(place) {
  unknowns_.push_back({[](Bench& bench, double by) { bench.finger.stiffness *= 1.0 + by; }, change, 0.0});
  unknowns_.push_back({[](Bench& bench, double by) { bench.finger.damping *= 1.0 + by; }, change, 0.0});
  if (place.request.tolerances != Tolerances::exact) add_numbers();
  add_clocks();
}

// Of the samples over the noise, above the priors.
Eigen::MatrixXd Absorption::slopes_at(const Eigen::VectorXd& moves) const {
  const auto count = static_cast<Eigen::Index>(unknowns_.size());
  Eigen::Index samples = 0;
  for (const Eigen::VectorXd& run : place_.without) samples += run.size();
  const RecordedAngles here = seen_with(moves);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(samples + count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Unknown& unknown = unknowns_[static_cast<std::size_t>(i)];
    out.col(i).head(samples) =
        difference(here, seen_with(moves + unknown.step * Eigen::VectorXd::Unit(count, i))) / unknown.step;
    out(samples + i, i) = unknown.prior;
  }
  return out;
}

void Absorption::add_numbers() {
  for (const Number& number : place_.built.numbers) {
    if (number.declared == 0.0) {
      const std::array<double, 4> deviations = curve_deviations(number.tolerance);
      for (std::size_t i = 0; i < deviations.size(); ++i)
        unknowns_.push_back(
            {[=](Bench& bench, double by) { bench.finger.curve_error[i] += by * deviations[i]; }, slope_step, 1.0});
      continue;
    }
    unknowns_.push_back({[name = number.name, share = number.tolerance / number.declared](Bench& bench, double by) {
                           set_number(name, 1.0 + by * share, bench.finger);
                         },
                         slope_step, 1.0});
  }
}

void Absorption::add_clocks() {
  const ClockFaults& clocks = place_.request.clocks;
  // An edge that lies anywhere between two samples is a shift of the input.
  const double interval =
      clocks.log == InputLog::own_samples ? 1.0 / clocks.own_rate : 1.0 / place_.request.camera.frame_rate;
  for (std::size_t run = 0; run < place_.fit.size(); ++run) {
    const bool unknown_edge = hold_of(place_.request, place_.planned[run]) == "unknown_within_sample";
    const double shift = std::hypot(stated_offset(clocks), unknown_edge ? interval / std::sqrt(12.0) : 0.0);
    if (shift > 0.0)
      unknowns_.push_back({[=](Bench& bench, double by) { bench.clocks[run].offset += by * shift; }, slope_step, 1.0});
    if (clocks.rate > 0.0)
      unknowns_.push_back(
          {[=, rate = clocks.rate](Bench& bench, double by) { bench.clocks[run].rate += by * rate; }, slope_step, 1.0});
  }
}

Eigen::VectorXd Absorption::difference(const RecordedAngles& from, const RecordedAngles& to) const {
  const double rounding = resolution_deg * std::numbers::pi / 180.0 / std::sqrt(12.0);
  const double white = std::pow(rounding / place_.noise, 2);
  std::vector<Eigen::VectorXd> parts;
  Eigen::Index size = 0;
  for (std::size_t run = 0; run < from.size(); ++run) {
    parts.push_back(
        over_noise(place_.request.noise.colour, white, place_.fit[run].seen, (to[run] - from[run]) / place_.noise));
    size += parts.back().size();
  }
  Eigen::VectorXd out(size);
  Eigen::Index at = 0;
  for (const Eigen::VectorXd& part : parts) {
    out.segment(at, part.size()) = part;
    at += part.size();
  }
  return out;
}

// Runs whose finger and clock nothing has moved are not simulated again.
RecordedAngles Absorption::seen_with(const Eigen::VectorXd& moves) const {
  Bench bench{.finger = place_.built.finger, .clocks = std::vector<RunClock>(place_.fit.size())};
  bool another_finger = false;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const double by = moves[static_cast<Eigen::Index>(i)];
    if (by == 0.0) continue;
    const std::vector<RunClock> before = bench.clocks;
    unknowns_[i].move(bench, by);
    const bool clock_only =
        !std::equal(before.begin(), before.end(), bench.clocks.begin(),
                    [](const RunClock& a, const RunClock& b) { return a.offset == b.offset && a.rate == b.rate; });
    another_finger = another_finger || !clock_only;
  }
  RecordedAngles seen = place_.without;
  for (std::size_t run = 0; run < place_.fit.size(); ++run) {
    const RunClock& clock = bench.clocks[run];
    if (!another_finger && clock.offset == 0.0 && clock.rate == 0.0) continue;
    Experiment filmed = place_.fit[run];
    for (double& time : filmed.seen) time = std::max((1.0 + clock.rate) * time + clock.offset, 0.0);
    seen[run] =
        camera_view(place_.request.channels, place_.others, filmed, simulate(bench.finger, place_.others, filmed));
  }
  return seen;
}

// What is left of `moved`, and of the priors.
Eigen::VectorXd Absorption::left_after(const Eigen::VectorXd& moves, const RecordedAngles& moved) const {
  const Eigen::VectorXd angles = difference(seen_with(moves), moved);
  Eigen::VectorXd left(angles.size() + moves.size());
  left.head(angles.size()) = angles;
  for (Eigen::Index i = 0; i < moves.size(); ++i)
    left[angles.size() + i] = -unknowns_[static_cast<std::size_t>(i)].prior * moves[i];
  return left;
}

// By Gauss and Newton, each step halved until it leaves less.
double Absorption::left_of(const RecordedAngles& moved) const {
  constexpr int most_steps = 12;
  constexpr double shortest = 1.0 / 16.0;
  constexpr double worth_a_step = 0.01;
  Eigen::VectorXd moves = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(unknowns_.size()));
  Eigen::VectorXd left = left_after(moves, moved);
  for (int step = 0; step < most_steps; ++step) {
    const double before = left.norm();
    const Eigen::VectorXd whole = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(slopes_at(moves)).solve(left);
    for (double share = 1.0; share >= shortest; share *= 0.5) {
      try {
        const Eigen::VectorXd there = left_after(moves + share * whole, moved);
        if (there.norm() >= left.norm()) continue;
        left = there;
        moves += share * whole;
        break;
      } catch (const std::runtime_error&) {
        continue;  // such a finger leaves its range of angles
      }
    }
    if (left.norm() > (1.0 - worth_a_step) * before) break;
  }
  return left.norm();
}

}  // namespace truth::laboratory
