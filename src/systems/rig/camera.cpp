#include "coilwright/systems/rig/camera.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/transient.hpp"
#include "systems/check.hpp"
#include "systems/rig/models_of.hpp"

namespace coilwright::systems::rig {
namespace {

using actuator::Model;
using simulation::State;

constexpr double step_time = 0.1;      // s, from the start of a record
constexpr double shortest_sine = 1.0;  // s

void require_each_once(std::vector<double> values, std::string_view name, std::string_view unit) {
  std::ranges::sort(values);
  if (const auto twice = std::ranges::adjacent_find(values); twice != values.end())
    throw std::invalid_argument(fmt::format("{} must not be there twice; got {:.6g} {}", name, *twice, unit));
}

void check(const Camera& camera) {
  require(camera.frame_rate > 0.0, "frame rate", "finite and > 0", camera.frame_rate, "Hz");
  require(camera.step_duration > step_time, "step duration", "finite and > 0.1", camera.step_duration, "s");
  require(camera.step_duration * camera.frame_rate <= simulation::most_samples, "frames of a step",
          fmt::format("at most {}", simulation::most_samples), camera.step_duration * camera.frame_rate, "frames");
  require(true, "amplitude", "finite", camera.amplitude, "A");
  require(true, "offset", "finite", camera.offset, "A");
  require_some(!camera.steps.empty() || !camera.frequencies.empty(), "steps and sines");
  for (const double step : camera.steps) require(true, "step", "finite", step, "A");
  for (const double frequency : camera.frequencies) {
    require(frequency > 0.0 && frequency <= 0.1 * camera.frame_rate, "frequency",
            "> 0 and at most a tenth of the frame rate", frequency, "Hz");
    require(2.0 / frequency * camera.frame_rate <= simulation::most_samples, "frames of a sine",
            fmt::format("at most {}", simulation::most_samples), 2.0 / frequency * camera.frame_rate, "frames");
  }
  require_each_once(camera.steps, "step", "A");
  require_each_once(camera.frequencies, "frequency", "Hz");
}

template <class Current>
CameraRecord planned(CameraInput input, double level, double duration, double frame_rate, const Current& current) {
  CameraRecord out{.input = input, .level = level};
  const auto frames = static_cast<std::size_t>(std::llround(duration * frame_rate)) + 1;
  for (std::size_t i = 0; i < frames; ++i) {
    out.times.push_back(static_cast<double>(i) / frame_rate);
    out.currents.push_back(current(out.times.back()));
  }
  return out;
}

std::vector<CameraRecord> planned(const Camera& camera) {
  std::vector<CameraRecord> out;
  for (const double step : camera.steps)
    out.push_back(planned(CameraInput::step, step, camera.step_duration, camera.frame_rate, [&](double time) {
      // Half a frame before, so that rounding does not move the edge.
      return time > step_time - 0.5 / camera.frame_rate ? step : 0.0;
    }));
  for (const double frequency : camera.frequencies)
    out.push_back(planned(CameraInput::sine, frequency, std::max(shortest_sine, 2.0 / frequency), camera.frame_rate,
                          [&](double time) {
                            const double phase = 2.0 * std::numbers::pi * frequency * time;
                            return camera.offset + camera.amplitude * std::sin(phase);
                          }));
  return out;
}

std::vector<double> bending_of(const Model& model, const CameraRecord& record) {
  simulation::CommandedInput command{
      .drive = simulation::Drive::current, .addressing = simulation::Addressing::common, .times = record.times};
  for (const double current : record.currents) command.rows.push_back({current});
  const simulation::ModelInput input = simulation::model_input(model, command);
  const auto start = simulation::equilibrium_at_first_input(model, input);
  if (!start) throw std::runtime_error("has no stable pose to start from");
  std::vector<double> out;
  for (const State& state : simulation::simulate_as_observed(model, input, *start)) {
    const std::span<const double> internal(state.internal.data(), static_cast<std::size_t>(state.internal.size()));
    const mechanics::JointVector angles = model.shown(state.angles, state.rates, internal).angles;
    out.push_back(model.observed(Model::bending_angle(angles)));
  }
  return out;
}

}  // namespace

std::string CameraRecord::name() const {
  return input == CameraInput::step ? fmt::format("step_{}A", level) : fmt::format("sine_{}Hz", level);
}

std::vector<CameraRecord> readings(const actuator::Design& design, const Camera& camera) {
  check(camera);
  const auto models = models_of(design);
  std::vector<CameraRecord> out = planned(camera);
  for (CameraRecord& record : out)
    record.bending =
        per_fidelity([&](magnetics::Fidelity fidelity) { return bending_of(models.of(fidelity), record); });
  return out;
}

ResponseFigures figures(const CameraRecord& record, magnetics::Fidelity fidelity) {
  const std::vector<double>& angles = record.bending.of(fidelity);
  ResponseFigures out{.first = angles.front(), .last = angles.back(), .largest = *std::ranges::max_element(angles)};
  for (std::size_t i = 1; i < angles.size(); ++i)
    out.fastest = std::max(out.fastest, (angles[i] - angles[i - 1]) / (record.times[i] - record.times[i - 1]));
  const double end = record.times.back();
  const double late = record.input == CameraInput::sine ? 1.0 / record.level : 0.1 * end;
  const double frame = record.times[1] - record.times[0];
  // Open at its beginning by half a frame: a whole period has its frames once.
  const auto first = std::ranges::upper_bound(record.times, end - late + 0.5 * frame) - record.times.begin();
  const std::span<const double> part = std::span(angles).subspan(static_cast<std::size_t>(first));
  for (const double angle : part) out.late_mean += angle / static_cast<double>(part.size());
  const auto [low, high] = std::ranges::minmax_element(part);
  out.peak_to_peak = *high - *low;
  return out;
}

double mean_difference(const CameraRecord& record) {
  double sum = 0.0;
  for (std::size_t i = 0; i < record.times.size(); ++i)
    sum += std::abs(record.bending.exact[i] - record.bending.line_of_centres[i]);
  return sum / static_cast<double>(record.times.size());
}

}  // namespace coilwright::systems::rig
