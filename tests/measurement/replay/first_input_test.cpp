// Runs whose input, on a clock of its own, begins before the first picture: they rest under the first input, and move
// from there. By another way: every step, line and edge is integrated from the first row of the input on.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "measurement/random_numbers.hpp"
#include "measurement/replay/input_whitener.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/replay/window_input.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::replay {
namespace {

// A mass on a spring and a damper that swings at 8 Hz, as a finger does.
constexpr double swing_rate = 2.0 * std::numbers::pi * 8.0;
constexpr double stiffness = swing_rate * swing_rate;
constexpr double damping = 0.1 * swing_rate;

actuator::Model swinging_mass() {
  const mechanics::Link link{.length = 1.0, .com_along = 1.0, .com_offset = 0.0, .mass = 1.0, .inertia = 0.0};
  return actuator::Model({.chain = mechanics::PlanarChain(std::span(&link, 1), 0.0),
                          .hinges = {actuator::Hinge{.stiffness = stiffness, .damping = damping}},
                          .magnetics = {},
                          .coils = 0,
                          .tip = {}});
}

// Half a second filmed at 125 pictures a second from `first` on, s; the torque is logged from 0 on every `apart`.
template <class Angle>
data::Run filmed(double first, double apart, data::InputHold hold, const Angle& held_angle) {
  data::Run run{.name = "swing.csv", .kind = data::RunKind::transient, .drive = simulation::Drive::torque};
  run.hold = hold;
  for (int i = 0; i < 63; ++i) run.times.push_back(first + 0.008 * i);
  for (int i = 0; apart * (i - 1) < run.times.back() + 0.1; ++i) {
    run.input_times.push_back(apart * i);
    run.inputs.push_back({stiffness * held_angle(apart * i)});
  }
  run.channels = {
      {.name = "theta1_deg", .kind = data::ChannelKind::joint_angle, .values = std::vector(run.times.size(), 0.0)}};
  return run;
}

// The torque between two rows of the input, at a share of the way: an edge lies in the middle.
double torque_between(const data::Run& run, std::size_t row, double share) {
  constexpr double edge = 0.2 * stiffness;
  const double from = run.inputs[row][0];
  const double to = run.inputs[std::min(row + 1, run.inputs.size() - 1)][0];
  if (run.hold == data::InputHold::zero_order) return from;
  if (run.hold == data::InputHold::linear || std::abs(to - from) < edge) return from + share * (to - from);
  return share < 0.5 ? from : to;
}

// The angles at the pictures taken `shift` later than they are stamped, from rest at the first row of the input on:
// Runge and Kutta's fourth order in steps of 0.5 ms, of which samples, middles and pictures are multiples.
std::vector<double> angles_of(const data::Run& run, double shift) {
  constexpr double step = 5e-4;
  const double apart = run.input_times[1] - run.input_times[0];
  const auto per_row = static_cast<std::size_t>(std::lround(apart / step));
  double angle = run.inputs.front()[0] / stiffness;
  double rate = 0.0;
  std::vector<double> out;
  for (std::size_t i = 0; out.size() < run.times.size(); ++i) {
    while (out.size() < run.times.size() && run.times[out.size()] + shift <= step * (static_cast<double>(i) + 0.5))
      out.push_back(angle);
    const auto torque = [&](double part) {
      return torque_between(run, i / per_row, (static_cast<double>(i % per_row) + part) / static_cast<double>(per_row));
    };
    // What jumps does so where a step ends, never within one.
    constexpr double within = 1e-6;
    const double first = torque(within), middle = torque(0.5), last = torque(1.0 - within);
    const auto slope = [](double u, double x, double v) { return u - stiffness * x - damping * v; };
    const double a1 = slope(first, angle, rate);
    const double v2 = rate + 0.5 * step * a1, a2 = slope(middle, angle + 0.5 * step * rate, v2);
    const double v3 = rate + 0.5 * step * a2, a3 = slope(middle, angle + 0.5 * step * v2, v3);
    const double v4 = rate + step * a3, a4 = slope(last, angle + step * v3, v4);
    angle += step / 6.0 * (rate + 2.0 * v2 + 2.0 * v3 + v4);
    rate += step / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
  return out;
}

struct Replayed {
  double apart{};      // from the independent simulation, of its largest angle
  std::size_t rows{};  // of the input
};

Replayed replayed(data::Run run, double shift = 0.0) {
  run.clock.offset_sigma = 0.004;
  PreparedRun prepared{.run = &run};
  prepared.windows = {{.range = {0, run.times.size()}}};
  Window& window = prepared.windows.front();
  set_input(window, run, {.rows = run.inputs}, swinging_mass());
  const LocalNumbers numbers(prepared, window);
  std::vector<double> values(numbers.size(), 0.0);  // straight between samples, edges in the middle
  values.back() = shift;                            // of the clocks
  const LocalValues local{.numbers = &numbers, .values = values};
  EXPECT_EQ(numbers.clock_offset(values), shift);
  const auto motion = simulate_window(swinging_mass(), window, local, {});
  if (!motion) return {.apart = 1.0};
  const Eigen::VectorXd found = observed_values(swinging_mass(), prepared, window, *motion, local);
  const std::vector<double> expected = angles_of(run, shift);
  double largest = 0.0;
  Replayed out{.rows = window.input.times.size()};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    largest = std::max(largest, std::abs(expected[i]));
    out.apart = std::max(out.apart, std::abs(found[static_cast<Eigen::Index>(i)] - expected[i]));
  }
  out.apart /= largest;
  return out;
}

// A smooth curve replaces fine steps and lines to 4e-5 of a motion.
constexpr double of_the_curve = 1e-4;

// From its peak, or from its middle: at the first picture it is neither, nor is the finger at rest.
TEST(FirstInput, IsWhereARunRestsThoughPicturesBeginLater) {
  for (const double phase : {0.0, 0.5 * std::numbers::pi})
    for (const data::InputHold hold :
         {data::InputHold::zero_order, data::InputHold::linear, data::InputHold::unknown_within_sample})
      for (const double first : {0.0, 0.004, 0.0605, 0.5, 4.5})
        for (const double shift : {-0.003, 0.0, 0.003}) {
          const auto sine = [&](double time) { return std::cos(2.0 * std::numbers::pi * 3.0 * time - phase); };
          EXPECT_LT(replayed(filmed(first, 0.002, hold, sine), shift).apart, of_the_curve)
              << phase << ", " << name_of(hold) << ", " << first << ", " << shift;
        }
}

TEST(FirstInput, IsWhereARunRestsThoughItJumpsBeforeThePictures) {
  for (const data::InputHold hold : {data::InputHold::zero_order, data::InputHold::unknown_within_sample})
    for (const double first : {0.0, 0.0205, 0.15, 4.5}) {
      const auto pulses = [](double time) { return time < 0.012 || std::fmod(time, 0.4) > 0.2 ? 0.1 : 0.6; };
      EXPECT_LT(replayed(filmed(first, 0.004, hold, pulses)).apart, of_the_curve) << name_of(hold) << ", " << first;
    }
}

// The first row comes later than the first picture, as far as clocks may be apart: the finger rests until then.
TEST(FirstInput, IsWhereARunRestsBeforeTheInputBegins) {
  for (const data::InputHold hold : {data::InputHold::zero_order, data::InputHold::linear}) {
    const auto sine = [](double time) { return std::cos(2.0 * std::numbers::pi * 3.0 * time); };
    EXPECT_LT(replayed(filmed(-0.01, 0.002, hold, sine)).apart, of_the_curve) << name_of(hold);
  }
}

// A logger that ran for ten minutes before costs no more than the finger moves, whatever its last digit does.
TEST(FirstInput, MayComeLongBeforeThePictures) {
  Normal normal(5);
  for (const data::InputHold hold : {data::InputHold::zero_order, data::InputHold::linear}) {
    const auto late_sine = [&](double time) {
      return 0.001 * std::round(normal()) +
             (time < 599.95 ? 0.3 : 0.3 + 0.5 * std::sin(2.0 * std::numbers::pi * 3.0 * (time - 599.95)));
    };
    const Replayed found = replayed(filmed(600.0, 0.01, hold, late_sine));
    EXPECT_LT(found.apart, 1e-3) << name_of(hold);
    EXPECT_LT(found.rows, 2500U) << name_of(hold);
  }
}

// A log of many runs: of what moved the finger before its last long rest nothing is simulated. Of a motion that never
// stopped a minute is.
TEST(FirstInput, IsThatOfTheLastLongRestInALogOfManyRuns) {
  const auto many = [](double time) { return std::fmod(time, 10.0) < 5.0 ? 0.3 : 0.3 + 0.4 * std::sin(15.0 * time); };
  const Replayed last = replayed(filmed(995.1, 0.01, data::InputHold::zero_order, many));
  EXPECT_LT(last.apart, 1e-3);
  EXPECT_LT(last.rows, 2500U);
  const auto one = [](double time) { return 0.4 * std::sin(15.0 * time); };
  const Replayed endless = replayed(filmed(300.0, 0.01, data::InputHold::zero_order, one));
  EXPECT_LT(endless.apart, 1e-3);
  EXPECT_LT(endless.rows, 8000U);
}

// Errors of the input act from there, too: a slide's place is as uncertain at its first picture as if it had been
// filmed all the time.
TEST(FirstInput, IsFromWhenItsErrorsAct) {
  const DeclaredModel declared = slide(true_mass, true_damping);
  const actuator::Model model(declared.build(std::vector{true_mass, true_damping}));
  constexpr std::size_t late = 30;
  data::Run all = slide_run(60, {}, no_error);
  all.input_uncertainty = {.sigma = {0.2}};
  data::Run part = all;
  part.input_times = all.times;
  for (std::vector<double>* each : {&part.times, &part.channels.front().values})
    each->erase(each->begin(), each->begin() + late);
  const auto deviations = [&](const data::Run& run) {
    PreparedRun prepared = prepare_run(run, declared, model);
    weigh_input_errors(prepared, model, {});
    return prepared.windows.front().input_whitener->deviations();
  };
  const double expected = deviations(all)[late];
  EXPECT_GT(expected, 0.5 * noise_sigma);
  EXPECT_NEAR(deviations(part)[0], expected, 1e-6 * expected);
}

}  // namespace
}  // namespace coilwright::measurement::replay
