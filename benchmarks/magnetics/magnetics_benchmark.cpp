#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/magnetics/forces.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "coilwright/magnetics/pair_curve.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "straightforward_force.hpp"

// Rates per thread on the prototype's parts: coil 3..9.5 mm x 12 mm, 15 x 30 turns; magnet 10 mm x 6 mm, 1.44 T.
namespace {

using namespace coilwright::magnetics;

constexpr double degree = std::numbers::pi / 180.0;
const CylinderMagnet magnet({.radius = 10e-3, .length = 6e-3, .remanence = 1.44});
const HingeGeometry hinge{.coil_offset = 6.3e-3, .magnet_offset = 3.6e-3, .axis_offset = 11.5e-3};

ThickCoil prototype_coil(CurrentDistribution winding) {
  return ThickCoil({.inner_radius = 3e-3,
                    .outer_radius = 9.5e-3,
                    .length = 12e-3,
                    .turns_radial = 15,
                    .turns_axial = 30,
                    .winding = winding});
}

/// Centre distances for gaps of 0.3 to 20 mm.
std::vector<double> distances() {
  std::vector<double> z(64);
  for (int i = 0; i < 64; ++i) z[i] = 9e-3 + 0.3e-3 * std::pow(20.0 / 0.3, i / 63.0);
  return z;
}

void per_second(benchmark::State& state, double calls_per_iteration) {
  state.counters["per_second"] = benchmark::Counter(calls_per_iteration, benchmark::Counter::kIsIterationInvariantRate);
}

void straightforward(benchmark::State& state) {
  const coilwright::benchmarks::PaperPair pair{3e-3, 9.5e-3, 12e-3, 15, 30, 10e-3, 6e-3, 1.44};
  const std::vector<double> z = distances();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(coilwright::benchmarks::straightforward_force(pair, z[i++ % z.size()]));
  per_second(state, 1);
}
BENCHMARK(straightforward)->Name("axial_force/straightforward");

void axial(benchmark::State& state, CurrentDistribution winding) {
  const ThickCoil coil = prototype_coil(winding);
  const std::vector<double> z = distances();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(axial_force(coil, 1.0, magnet, z[i++ % z.size()]));
  per_second(state, 1);
}
BENCHMARK_CAPTURE(axial, paper_shells, CurrentDistribution::paper_shells)->Name("axial_force/paper_shells");
BENCHMARK_CAPTURE(axial, layer_centres, CurrentDistribution::layer_centres)->Name("axial_force/layer_centres");
BENCHMARK_CAPTURE(axial, uniform, CurrentDistribution::uniform)->Name("axial_force/uniform");

void axial_batch(benchmark::State& state, CurrentDistribution winding) {
  const ThickCoil coil = prototype_coil(winding);
  const std::vector<double> z = distances();
  std::vector<double> force(z.size());
  for (auto _ : state) {
    axial_force_per_ampere(coil, magnet, z, force);
    benchmark::DoNotOptimize(force.data());
  }
  per_second(state, static_cast<double>(z.size()));
}
BENCHMARK_CAPTURE(axial_batch, paper_shells, CurrentDistribution::paper_shells)->Name("axial_force_batch/paper_shells");
BENCHMARK_CAPTURE(axial_batch, layer_centres, CurrentDistribution::layer_centres)
    ->Name("axial_force_batch/layer_centres");
BENCHMARK_CAPTURE(axial_batch, uniform, CurrentDistribution::uniform)->Name("axial_force_batch/uniform");

void two_magnets(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(axial_force(magnet, magnet, 19.8e-3));
  per_second(state, 1);
}
BENCHMARK(two_magnets)->Name("axial_force/two_magnets");

void two_coils(benchmark::State& state) {
  const ThickCoil coil = prototype_coil(CurrentDistribution::uniform);
  for (auto _ : state) benchmark::DoNotOptimize(axial_force(coil, 1.0, coil, 1.0, 12.6e-3));
  per_second(state, 1);
}
BENCHMARK(two_coils)->Name("axial_force/two_coils");

/// Displaced and tilted, gap around 3 mm: nothing symmetric.
void pose_general(benchmark::State& state, CurrentDistribution winding) {
  const ThickCoil coil = prototype_coil(winding);
  const std::array<Pose, 4> poses{{{.position = {4e-3, 1e-3, 14e-3}, .axis = {0.3, -0.1, 0.9}},
                                   {.position = {1e-3, -2e-3, 13e-3}, .axis = {-0.1, 0.2, 1.0}},
                                   {.position = {15e-3, 10e-3, 35e-3}, .axis = {0.5, -0.2, 1.0}},
                                   {.position = {-6e-3, 3e-3, 16e-3}, .axis = {0.4, 0.3, 0.8}}}};
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(wrench(coil, 1.0, magnet, poses[i++ % poses.size()]).force.z());
  per_second(state, 1);
}
BENCHMARK_CAPTURE(pose_general, uniform, CurrentDistribution::uniform)->Name("wrench/uniform");
BENCHMARK_CAPTURE(pose_general, paper_shells, CurrentDistribution::paper_shells)->Name("wrench/paper_shells");

/// Poses with a mirror plane, as every hinge has: tilted, displaced or both.
void pose_planar(benchmark::State& state) {
  const ThickCoil coil = prototype_coil(CurrentDistribution::uniform);
  const std::array<Pose, 4> poses{{{.position = {0.0, 0.0, 15.5e-3}, .axis = {0.5, 0.0, 0.866}},
                                   {.position = {4e-3, 0.0, 13e-3}, .axis = {0.34, 0.0, 0.94}},
                                   {.position = {5e-3, 0.0, 9.9e-3}, .axis = {0.0, 0.0, 1.0}},
                                   {.position = {21e-3, 0.0, 1e-3}, .axis = {0.0, 0.0, 1.0}}}};
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(wrench(coil, 1.0, magnet, poses[i++ % poses.size()]).force.z());
  per_second(state, 1);
}
BENCHMARK(pose_planar)->Name("wrench/planar");

void torque(benchmark::State& state, Fidelity fidelity) {
  const ThickCoil coil = prototype_coil(CurrentDistribution::uniform);
  double angle = 0.0;
  for (auto _ : state) {
    angle = angle > 90.0 ? 0.0 : angle + 1.7;
    benchmark::DoNotOptimize(hinge_torque_per_ampere(coil, magnet, hinge, fidelity, angle * degree));
  }
  per_second(state, 1);
}
BENCHMARK_CAPTURE(torque, line_of_centres, Fidelity::line_of_centres)->Name("hinge_torque/line_of_centres");
BENCHMARK_CAPTURE(torque, exact, Fidelity::exact)->Name("hinge_torque/exact");

void build(benchmark::State& state, Fidelity fidelity, CurrentDistribution winding, double lower, double tolerance) {
  const ThickCoil coil = prototype_coil(winding);
  int evaluations = 0;
  for (auto _ : state) {
    const Curve curve = torque_curve(coil, magnet, hinge, fidelity,
                                     {.lower = lower * degree, .upper = 120 * degree, .tolerance = tolerance});
    evaluations = curve.evaluations();
    benchmark::DoNotOptimize(&curve);
  }
  state.counters["evaluations"] = evaluations;
}
BENCHMARK_CAPTURE(build, line_of_centres_uniform, Fidelity::line_of_centres, CurrentDistribution::uniform, -3.0, 1e-8);
BENCHMARK_CAPTURE(build, line_of_centres_shells, Fidelity::line_of_centres, CurrentDistribution::paper_shells, -3.0,
                  1e-8);
BENCHMARK_CAPTURE(build, exact_uniform, Fidelity::exact, CurrentDistribution::uniform, -1.0, 1e-7);
BENCHMARK_CAPTURE(build, exact_shells, Fidelity::exact, CurrentDistribution::paper_shells, -1.0, 1e-7);

// Tilted ones are integrated over their faces.
void two_blocks(benchmark::State& state, double tilt) {
  const Body first{.part = Magnet{.shape = Cuboid{.size = {8e-3, 6e-3, 5e-3}}, .remanence = {0.0, 0.0, 1.2}}};
  Body second = first;
  second.pose = {.position = {2e-3, 1e-3, 8e-3}, .axis = {0.0, tilt, 1.0}};
  const std::vector<Body> both{first, second};
  for (auto _ : state) benchmark::DoNotOptimize(forces(both));
}
BENCHMARK_CAPTURE(two_blocks, parallel, 0.0)->Name("forces/parallel_blocks");
BENCHMARK_CAPTURE(two_blocks, tilted, 0.01)->Name("forces/tilted_blocks");

void evaluate(benchmark::State& state) {
  const Curve curve =
      torque_curve(prototype_coil(CurrentDistribution::uniform), magnet, hinge, Fidelity::line_of_centres,
                   {.lower = -3 * degree, .upper = 120 * degree, .tolerance = 1e-8});
  double angle = 0.1;
  for (auto _ : state) {
    const Curve::Sample s = curve.sample(angle);
    // The next angle depends on this value, as in an integration.
    angle = 0.1 + 0.5 * s.value;
    benchmark::DoNotOptimize(angle);
  }
}
BENCHMARK(evaluate)->Name("curve_sample");

}  // namespace

BENCHMARK_MAIN();
