#include "truth/laboratory/programmes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

namespace truth::laboratory {
namespace {

constexpr double update = 0.002;  // s between updates of the driver

double rounded(double current) {
  return std::round(current * 1e6) / 1e6;
}

PlannedRun smooth(std::string name, double duration, const std::function<double(double)>& current) {
  PlannedRun run{.experiment = {}, .begins = 0.0, .duration = duration, .wave = current, .validate = false};
  run.experiment.name = std::move(name);
  for (int i = 0; i * update < duration; ++i) {
    run.experiment.times.push_back(i * update);
    run.experiment.currents.push_back(rounded(current(i * update)));
  }
  return run;
}

struct Edge {
  double time;
  double current;  // from then on
};

// The updates between edges repeat the current: effects that are held between samples see them.
PlannedRun stepped(std::string name, double duration, double from, const std::vector<Edge>& edges) {
  PlannedRun run{.experiment = {}, .begins = 0.0, .duration = duration, .wave = {}, .validate = false};
  run.experiment.name = std::move(name);
  double current = from;
  std::size_t next = 0;
  const auto add = [&](double time) {
    run.experiment.times.push_back(time);
    run.experiment.currents.push_back(current);
  };
  constexpr double same = 1e-9;  // s
  for (int i = 0; i * update < duration; ++i) {
    const double time = i * update;
    for (; next < edges.size() && edges[next].time < time - same; ++next) {
      current = edges[next].current;
      add(edges[next].time);
    }
    if (next < edges.size() && edges[next].time <= time + same) current = edges[next++].current;
    add(time);
  }
  return run;
}

class Planner {
 public:
  Planner(Edges edges, Random& random) : edges_(edges), random_(random) {}

  PlannedRun step(double current, double from = 0.0) {
    return stepped(from == 0.0 ? fmt::format("step_{:g}A", current) : fmt::format("step_{:g}A_{:g}A", from, current),
                   0.7, from, {{begin(), current}});
  }

  PlannedRun release(const std::string& name, Rig rig = {}, double current = 1.4) {
    PlannedRun run = stepped(name, 0.8, current, {{begin(), 0.0}});
    run.experiment.rig = rig;
    return run;
  }

  // Nobody drives: the record knows no current at all.
  static PlannedRun let_go(const std::string& name, CoilState coil) {
    PlannedRun run = stepped(name, 0.9, 1.4, {{0.01, 0.0}});
    run.experiment.rig.coil = coil;
    run.begins = 0.04;
    run.duration = 0.8;
    return run;
  }

  PlannedRun hold(double current, double until) {
    const double start = begin();
    return stepped(fmt::format("hold_{:g}A", current), until + 1.0, 0.0,
                   {{start, current}, {until, 0.0}, {until + 0.5, current}});
  }

  PlannedRun pulses(double current, double frequency) {
    const double start = begin();
    // To a hundredth of a second: a log that says `zero_order` has every edge in one of its samples.
    const double half_period = std::round(50.0 / frequency) / 100.0;
    std::vector<Edge> edges;
    for (int i = 0; start + half_period * i < 1.0; ++i)
      edges.push_back({start + half_period * i, i % 2 == 0 ? current : 0.0});
    return stepped(fmt::format("pulses_{:g}Hz", frequency), 1.0, 0.0, edges);
  }

  static PlannedRun sine(double mean, double amplitude, double frequency, double duration) {
    return smooth(fmt::format("sine_{:g}Hz", frequency), duration,
                  [=](double t) { return mean + amplitude * std::sin(2.0 * std::numbers::pi * frequency * t); });
  }

 private:
  // s: rest before the first edge.
  double begin() { return edges_ == Edges::anywhere ? 0.05 + 0.02 * random_.uniform() : 0.05; }

  Edges edges_;
  Random& random_;
};

constexpr double turn = std::numbers::pi / 6.0;
constexpr double hung_mass = 5e-3;  // kg

}  // namespace

PlannedRun drawn_through(PlannedRun run, const std::vector<double>& samples) {
  constexpr double step = 0.5e-3;  // s: the steps that the integrator sees, each with the current of its middle
  run.experiment.times.clear();
  run.experiment.currents.clear();
  std::size_t next = 1;
  for (int i = 0; i * step < run.duration; ++i) {
    const double middle = (i + 0.5) * step;
    while (next + 1 < samples.size() && samples[next] < middle) ++next;
    const double before = rounded(run.wave(samples[next - 1]));
    const double after = rounded(run.wave(samples[next]));
    const double share = (middle - samples[next - 1]) / (samples[next] - samples[next - 1]);
    run.experiment.times.push_back(i * step);
    run.experiment.currents.push_back(before + std::min(share, 1.0) * (after - before));
  }
  return run;
}

std::vector<PlannedRun> plan_runs(Programme programme, Edges edges, bool shorted, Random& random) {
  Planner plan(edges, random);
  std::vector<PlannedRun> fit;
  std::vector<PlannedRun> validate;
  switch (programme) {
    case Programme::paper:
      fit = {plan.step(0.35),
             plan.step(0.7),
             plan.step(1.05),
             plan.step(1.4),
             Planner::sine(0.7, 0.7, 0.5, 2.0),
             Planner::sine(0.7, 0.7, 1, 1),
             Planner::sine(0.7, 0.7, 2, 1),
             Planner::sine(0.7, 0.7, 10, 0.5),
             plan.release("release_1.4A"),
             plan.hold(1.3, 15.0)};
      validate = {plan.step(0.55), plan.step(1.25), Planner::sine(0.6, 0.5, 1.5, 1.4), plan.pulses(0.8, 3.0)};
      break;
    case Programme::few:
      fit = {plan.step(0.35), plan.step(0.9), plan.step(1.4), plan.release("release_1.4A")};
      validate = {plan.step(1.15)};
      break;
    case Programme::one:
      fit = {plan.step(0.3, 1.4)};
      break;
    case Programme::sines:
      fit = {Planner::sine(0.7, 0.7, 0.5, 4.0), Planner::sine(0.7, 0.7, 1, 2), Planner::sine(0.7, 0.5, 3, 2),
             Planner::sine(0.7, 0.7, 8, 1)};
      validate = {Planner::sine(0.6, 0.5, 1.5, 2)};
      break;
    case Programme::rig_changes:
      fit = {plan.step(0.5),
             plan.step(1.3),
             plan.release("release_1.4A"),
             plan.release("release_turned_30deg", {.base_turn = turn}),
             plan.release("release_turned_-30deg", {.base_turn = -turn}),
             plan.release("release_5g", {.tip_mass = hung_mass}),
             Planner::let_go("release_open", CoilState::open)};
      if (shorted) fit.push_back(Planner::let_go("release_shorted", CoilState::shorted));
      validate = {plan.step(1.0), plan.release("release_1.1A", {}, 1.1)};
      break;
    case Programme::hold:
      fit = {plan.step(1.3), plan.hold(1.3, 20.0), plan.step(0.8), plan.release("release_1.4A")};
      validate = {plan.step(1.1), plan.pulses(0.8, 3.0)};
      break;
  }
  std::vector<PlannedRun> all = std::move(fit);
  for (PlannedRun& run : validate) {
    run.validate = true;
    all.push_back(std::move(run));
  }
  int number = 0;
  for (PlannedRun& run : all) {  // two minutes between runs
    run.experiment.number = number;
    run.experiment.session_time = 120.0 * number++;
  }
  return all;
}

}  // namespace truth::laboratory
