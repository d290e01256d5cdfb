#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numbers>
#include <thread>
#include <utility>
#include <vector>

#include "coilwright/actuator/calibrate.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/step_response.hpp"
#include "coilwright/simulation/transient.hpp"
#include "straightforward.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;
using actuator::Design;

// The prototype with Table II as its calibration: line_of_centres with the paper's shells, exact with a uniform
// winding.
Design finger(magnetics::Fidelity torque, Configuration configuration = Configuration::B,
              actuator::ContactChoice faces = actuator::ContactChoice::hard_parts) {
  Design design;
  design.choices = {.winding = magnetics::CurrentDistribution::paper_shells,
                    .torque = torque,
                    .faces = faces,
                    .masses = actuator::SegmentMass::on_axis_points};
  design.calibration = actuator::calibrate(design, {.joint_stiffness = 12.5e-3,
                                                    .joint_damping = 1.29e-4,
                                                    .axis_offset = 11.5e-3,
                                                    .magnet_segment_mass = 16.5e-3,
                                                    .tip_segment_mass = 22.5e-3,
                                                    .tip_com = 9.1e-3,
                                                    .continuous_current = 1.1});
  design.layout = actuator::layout_of(configuration);
  if (torque == magnetics::Fidelity::exact) design.choices.winding = magnetics::CurrentDistribution::uniform;
  return design;
}

// No two evaluations alike: the gap wanders over a tenth of a millimetre.
double evaluate(Design& design, int number) {
  design.body.gap = 0.9e-3 + 1e-7 * (number % 1000);
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  const auto result = performance_of(design, assembly, {.current = 1.4});
  return std::get<Performance>(result).cold.peak_bending_speed;
}

void whole_evaluation(benchmark::State& state, magnetics::Fidelity torque, Configuration configuration,
                      actuator::ContactChoice faces = actuator::ContactChoice::hard_parts) {
  Design design = finger(torque, configuration, faces);
  int number = 0;
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(design, number++));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK_CAPTURE(whole_evaluation, B_line_of_centres, magnetics::Fidelity::line_of_centres, Configuration::B);
BENCHMARK_CAPTURE(whole_evaluation, B_exact, magnetics::Fidelity::exact, Configuration::B);
BENCHMARK_CAPTURE(whole_evaluation, A_line_of_centres, magnetics::Fidelity::line_of_centres, Configuration::A);
BENCHMARK_CAPTURE(whole_evaluation, C_line_of_centres, magnetics::Fidelity::line_of_centres, Configuration::C);
BENCHMARK_CAPTURE(whole_evaluation, D_line_of_centres, magnetics::Fidelity::line_of_centres, Configuration::D);
BENCHMARK_CAPTURE(whole_evaluation, C_exact, magnetics::Fidelity::exact, Configuration::C);
BENCHMARK_CAPTURE(whole_evaluation, D_exact, magnetics::Fidelity::exact, Configuration::D);
BENCHMARK_CAPTURE(whole_evaluation, C_exact_walls, magnetics::Fidelity::exact, Configuration::C,
                  actuator::ContactChoice::walls);
BENCHMARK_CAPTURE(whole_evaluation, D_exact_walls, magnetics::Fidelity::exact, Configuration::D,
                  actuator::ContactChoice::walls);

void assembly_alone(benchmark::State& state, magnetics::Fidelity torque) {
  const Design design = finger(torque);
  for (auto _ : state) benchmark::DoNotOptimize(actuator::assemble_or_throw(design));
}
BENCHMARK_CAPTURE(assembly_alone, line_of_centres, magnetics::Fidelity::line_of_centres);
BENCHMARK_CAPTURE(assembly_alone, exact, magnetics::Fidelity::exact);

void step_of_the_prototype(benchmark::State& state) {
  const actuator::Model model = actuator::assemble_or_throw(finger(magnetics::Fidelity::line_of_centres)).model;
  const mechanics::JointVector rest =
      find_equilibrium(model, model.all_coils(0.0), mechanics::JointVector::Zero(2)).value();
  for (auto _ : state) benchmark::DoNotOptimize(step_response(model, model.all_coils(1.4), rest));
}
BENCHMARK(step_of_the_prototype);

// A twentieth of the motion that step_of_the_prototype follows.
void straightforward_twentieth(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(peak_speed({.current = 1.4, .duration = 0.058}));
}
BENCHMARK(straightforward_twentieth)->Unit(benchmark::kMillisecond);

// simulate() over 2 s of a sine, 500 samples a second and a curve through them, as a diagnosis replays one, with
// effects of the catalogue by their ids.
void simulated_sine(benchmark::State& state, const std::vector<std::pair<const char*, std::vector<double>>>& effects) {
  actuator::ModelSpec spec =
      actuator::assemble_or_throw(finger(magnetics::Fidelity::line_of_centres)).model.nominal_spec();
  for (const auto& effect : effects)
    spec.effects.push_back({actuator::standard_effects().find(effect.first), effect.second});
  const actuator::Model model(spec);
  ModelInput input =
      sine_input(model, {.amplitude = 0.7, .offset = 0.7, .frequency = 2.0, .duration = 2.0, .interval = 2e-3});
  input.straight.assign(input.times.size(), 1);
  input.straight.back() = 0;
  input.passed = input.straight;
  input.passed.front() = 0;
  const State start{.angles = mechanics::JointVector::Zero(2), .rates = mechanics::JointVector::Zero(2)};
  for (auto _ : state)
    benchmark::DoNotOptimize(simulate(model, input, start, {.relative = 1e-6, .ends_at_rest = true}));
}
BENCHMARK_CAPTURE(simulated_sine, without_effects, {})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(simulated_sine, one_that_does_nothing, {{"force_gain", {1.0 + 1e-15}}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(simulated_sine, creep, {{"viscoelastic_creep", {0.2, 0.3}}})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(simulated_sine, dry_friction, {{"dry_friction", {3e-4}}})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(simulated_sine, coil_lag, {{"coil_lag", {3e-4}}})->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(simulated_sine, gain_creep_and_drag,
                  {{"force_gain", {0.9}}, {"viscoelastic_creep", {0.2, 0.3}}, {"quadratic_drag", {1e-7}}})
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(simulated_sine, lag_creep_and_friction,
                  {{"coil_lag", {3e-4}}, {"viscoelastic_creep", {0.2, 0.3}}, {"dry_friction", {3e-4}}})
    ->Unit(benchmark::kMicrosecond);

template <typename Call>
double seconds(Call&& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double evaluations_per_second(int threads) {
  constexpr int each = 3000;
  const auto work = [] {
    Design design = finger(magnetics::Fidelity::line_of_centres);
    for (int i = 0; i < each; ++i) benchmark::DoNotOptimize(evaluate(design, i));
  };
  const double elapsed = seconds([&] {
    std::vector<std::jthread> pool;
    for (int i = 0; i < threads; ++i) pool.emplace_back(work);
  });
  return threads * each / elapsed;
}

// Time of an evaluation, s: the best of a few, for a machine that is not ours alone.
double time_of(Configuration configuration, actuator::ContactChoice faces) {
  Design design = finger(magnetics::Fidelity::exact, configuration, faces);
  double best = 1e9;
  for (int i = 0; i < 20; ++i) best = std::min(best, seconds([&] { benchmark::DoNotOptimize(evaluate(design, i)); }));
  return best;
}

void print_configurations() {
  using actuator::ContactChoice;
  for (const ContactChoice faces : {ContactChoice::hard_parts, ContactChoice::walls}) {
    const double b = time_of(Configuration::B, faces);
    const double c = time_of(Configuration::C, faces);
    const double d = time_of(Configuration::D, faces);
    std::printf("exact, faces %s: B %.2f ms, C %.2f ms (%.1f of B), D %.2f ms (%.1f of B)\n",
                faces == ContactChoice::walls ? "with walls" : "of hard parts", 1e3 * b, 1e3 * c, c / b, 1e3 * d,
                d / b);
  }
}

// The two comparisons of the project's goals: best of a few, for a machine that is not ours alone.
void print_ratios() {
  double naive = 1e9;
  double ours = 1e9;
  Design design = finger(magnetics::Fidelity::line_of_centres);
  for (int i = 0; i < 3; ++i) {
    // Its cost is that of its steps, each like the other: a twentieth of the motion is enough to time.
    naive = std::min(naive,
                     20.0 * seconds([] { benchmark::DoNotOptimize(peak_speed({.current = 1.4, .duration = 0.058})); }));
    ours = std::min(ours, seconds([&] {
                            for (int j = 0; j < 200; ++j) benchmark::DoNotOptimize(evaluate(design, j));
                          }) / 200);
  }
  constexpr double degree = std::numbers::pi / 180.0;
  std::printf(
      "straightforward: %.4f N at the rest gap, peak %.1f deg/s, %.1f ms; whole evaluation %.3f ms: %.0f times\n",
      shell_force(9.9e-3, 1.4), peak_speed({.current = 1.4, .duration = 0.06}) / degree, 1e3 * naive, 1e3 * ours,
      naive / ours);
  double one = 0.0;
  double two = 0.0;
  for (int i = 0; i < 5; ++i) {
    one = std::max(one, evaluations_per_second(1));
    two = std::max(two, evaluations_per_second(2));
  }
  std::printf("one thread %.0f evaluations/s, two %.0f: %.2f times\n", one, two, two / one);
}

}  // namespace
}  // namespace coilwright::simulation

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  coilwright::simulation::print_configurations();
  coilwright::simulation::print_ratios();
  return 0;
}
