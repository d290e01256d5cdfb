#include "measurement/replay/window_input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "measurement/replay/input_curve.hpp"
#include "measurement/replay/input_rows.hpp"
#include "measurement/replay/rig_change.hpp"

namespace coilwright::measurement::replay {
namespace {

using simulation::ModelInput;
using Row = InputRow;

// Less than this share of what the input does in a window is no bend.
constexpr double least_bend = 0.003;

// The input reaches so far beyond the samples for each standard deviation of the clocks.
constexpr double clock_deviations = 4.0;
// And always so far: a camera may stamp its pictures early (measurement_delay, down to -50 ms).
constexpr double least_reach = 0.05;  // s

// So much of an input before the first sample counts, s: a finger has long forgotten how it swung before that, and what
// friction, creep and heat keep of it is left out.
constexpr double longest_lead = 60.0;
// Less than this share of what the input does in a run is no change of what is held before the first sample.
constexpr double least_change = 0.01;

// How far beyond its samples a window may be shown.
double reach_of(const data::Run& run, double duration) {
  const data::RecordingClock& clock = run.clock;
  return least_reach + clock_deviations * (clock.offset_sigma + clock.rate_sigma * duration) + 0.5 * clock.exposure;
}

// The errors of samples as those of the rows that come from them; of those that reach the window.
std::vector<InputRowErrors> row_errors(const std::vector<InputError>& errors, const std::vector<std::size_t>& samples,
                                       const std::vector<double>& shares, const simulation::CommandedInput& command,
                                       const actuator::Model& nominal) {
  std::vector<InputRowErrors> out;
  for (const InputError& error : errors) {
    const auto row_of = [&](std::size_t sample) {
      return static_cast<std::size_t>(std::ranges::lower_bound(samples, sample) - samples.begin());
    };
    const std::size_t first = row_of(error.first);
    const std::size_t last = row_of(error.first + error.shape.size());
    if (first == last) continue;
    simulation::CommandedInput changed = command;
    changed.times.assign(command.times.begin() + static_cast<std::ptrdiff_t>(first),
                         command.times.begin() + static_cast<std::ptrdiff_t>(last));
    changed.rows.clear();
    for (std::size_t row = first; row < last; ++row) {
      changed.rows.emplace_back(command.rows.front().size(), 0.0);
      const std::size_t at = samples[row] - error.first;
      const double next = at + 1 < error.shape.size() ? error.shape[at + 1] : error.shape[at];
      changed.rows.back()[error.column] = error.shape[at] + shares[row] * (next - error.shape[at]);
    }
    ModelInput input = simulation::model_input(nominal, changed);
    out.push_back(
        {.first_row = first, .currents = std::move(input.currents), .joint_torques = std::move(input.joint_torques)});
  }
  return out;
}

// From when on the input drives a window. A run that starts at rest does so under its first input, which a clock of its
// own may have put before the first sample; of a longer lead what came before the last long hold is forgotten.
double begin_of(const Window& window, const data::Run& run, const std::vector<Row>& rows) {
  const double first = run.times[window.range.first];
  if (window.range.first > 0 || run.start != data::Start::at_rest) return first;
  const std::vector<double>& times = run.times_of_inputs();
  if (first - times.front() <= longest_lead) return std::min(first, times.front());
  const double no_change = least_change * replay::range_of(rows);
  double out = first - longest_lead;
  double held_since = out;
  auto next = static_cast<std::size_t>(std::ranges::upper_bound(times, out) - times.begin());
  for (std::size_t held = next - 1; next < times.size() && times[next] <= first; ++next) {
    if (size_of_step(rows[held], rows[next]) <= no_change) continue;
    if (times[next] - held_since >= ringing_time) out = held_since;
    held_since = times[next];
    held = next;
  }
  return first - held_since >= ringing_time ? held_since : out;
}

}  // namespace

void set_input(Window& window, const data::Run& run, const CleanInput& clean, const actuator::Model& nominal) {
  const std::vector<Row>& rows = clean.rows;
  const InputRows all = input_rows(run, clean);
  const double first = run.times[window.range.first];
  const double last = run.times[window.range.last - 1];
  const double end = last + reach_of(run, last - first);
  const double begin = begin_of(window, run, rows);
  // Nobody looks at the motion before that, and a finger has forgotten it but for what it was long held at.
  const double dense_from = std::max(begin, first - ringing_time);
  const double no_change = least_change * replay::range_of(rows);
  const Row flat(rows.front().size(), 0.0);
  simulation::CommandedInput command = run.command();
  command.times.clear();
  command.rows.clear();
  simulation::CommandedInput bend = command;
  window.edges.clear();
  std::vector<std::size_t> samples;  // of the input behind each row
  std::vector<double> shares;        // of the way from it to the next
  std::vector<char> straight;
  std::vector<char> smooth;
  const auto add = [&](double time, Row row, Row more, std::size_t sample, double share, bool goes_straight,
                       bool goes_smoothly) {
    command.times.push_back(time);
    command.rows.push_back(std::move(row));
    bend.times.push_back(time);
    bend.rows.push_back(std::move(more));
    samples.push_back(sample);
    shares.push_back(share);
    straight.push_back(goes_straight ? 1 : 0);
    smooth.push_back(goes_smoothly ? 1 : 0);
  };
  const auto add_row = [&](std::size_t row) {
    add(all.times[row], all.rows[row], all.bends[row], all.samples[row], all.shares[row], all.straight[row] != 0,
        all.smooth[row] != 0);
  };
  const auto hold_at = [&](double time) {
    add(time, Row(command.rows.back()), Row(bend.rows.back()), samples.back(), shares.back(), false, false);
  };
  // What is held: straight parts are dense already.
  const auto fill_until = [&](double until) {
    if (until <= dense_from) return;
    if (straight.back() == 0 && command.times.back() < dense_from) hold_at(dense_from);
    const double from = command.times.back();
    const auto parts = static_cast<std::size_t>(std::ceil((until - from) / densest_needed - 1e-6));
    for (std::size_t k = 1; k < parts; ++k)
      hold_at(from + (until - from) * static_cast<double>(k) / static_cast<double>(parts));
  };
  // Before the motion is looked at, what hardly changes is held.
  const auto is_passed_over = [&](std::size_t row) {
    if (all.times[row] >= dense_from || all.smooth[row] != 0 || smooth.back() != 0) return false;
    if (size_of_step(command.rows.back(), all.rows[row]) > no_change) return false;
    straight.back() = 0;
    bend.rows.back() = flat;
    return true;
  };
  // The row in force when it begins.
  const auto after = std::upper_bound(all.times.begin(), all.times.end(), begin);
  auto row = static_cast<std::size_t>(after - all.times.begin());
  if (row > 0) --row;
  const bool has_begun = all.times[row] <= begin;
  if (run.hold == data::InputHold::zero_order) {
    add(begin, has_begun ? all.at(row, begin) : all.rows[row], flat, all.samples[row], all.shares[row],
        has_begun && all.straight[row] != 0, has_begun && all.smooth[row] != 0);
  } else {
    // A run starts at rest under its first sample.
    constexpr double instant = 1e-6;  // s
    const std::vector<double>& times = run.times_of_inputs();
    const auto next = std::upper_bound(times.begin(), times.end(), begin);
    const std::size_t sample = next == times.begin() ? 0 : static_cast<std::size_t>(next - times.begin()) - 1;
    add(begin, rows[sample], flat, sample, 0.0, false, false);
    if (has_begun)
      add(begin + instant, all.at(row, begin + instant), all.bends[row], all.samples[row], all.shares[row],
          all.straight[row] != 0, all.smooth[row] != 0);
  }
  for (row += has_begun ? 1 : 0; row < all.times.size() && all.times[row] <= end; ++row) {
    if (all.times[row] <= command.times.back() || is_passed_over(row)) continue;
    fill_until(all.times[row]);
    if (all.half_widths[row] > 0.0 && all.times[row] > dense_from)
      window.edges.push_back({.row = command.times.size(), .half_width = all.half_widths[row]});
    add_row(row);
  }
  if (command.times.back() < end) {
    fill_until(end);
    const bool was_straight = straight.back() != 0;
    add(end, was_straight ? all.at(row - 1, end) : Row(command.rows.back()), flat, samples.back(), shares.back(), false,
        false);
  }
  window.input = simulation::model_input(nominal, command);
  double largest_bend = 0.0;
  double largest = 0.0;
  for (const Row& each : bend.rows) largest_bend = std::max(largest_bend, size_of_step(flat, each));
  for (const Row& each : command.rows) largest = std::max(largest, size_of_step(command.rows.front(), each));
  window.bend = {};
  if (largest_bend > least_bend * largest) window.bend = simulation::model_input(nominal, bend);
  if (std::ranges::find(straight, 1) != straight.end()) {
    window.input.passed.assign(smooth.size(), 0);
    for (std::size_t i = 1; i + 1 < smooth.size(); ++i)
      window.input.passed[i] = smooth[i - 1] != 0 && smooth[i] != 0 ? 1 : 0;
    window.input.straight = std::move(straight);
  }
  window.errors = row_errors(clean.errors, samples, shares, command, nominal);
  if (current_flows(run.rig)) return;
  window.bend = {};
  window.errors.clear();
  for (actuator::CoilCurrents& currents : window.input.currents) currents.setZero();
}

ModelInput as_driven(const Window& window, const InputChange& change) {
  ModelInput out = window.input;
  for (std::size_t i = 0; i < window.bend.times.size(); ++i) {
    out.currents[i] += change.bend * window.bend.currents[i];
    if (!out.joint_torques.empty()) out.joint_torques[i] += change.bend * window.bend.joint_torques[i];
  }
  for (std::size_t e = 0; e < change.errors.size(); ++e) {
    const InputRowErrors& error = window.errors[e];
    for (std::size_t k = 0; k < error.currents.size(); ++k)
      out.currents[error.first_row + k] += change.errors[e] * error.currents[k];
    for (std::size_t k = 0; k < error.joint_torques.size(); ++k)
      out.joint_torques[error.first_row + k] += change.errors[e] * error.joint_torques[k];
  }
  for (std::size_t e = 0; e < window.edges.size(); ++e) {
    const InputEdge& edge = window.edges[e];
    const double middle = window.input.times[edge.row];
    const double shift = edge.shift(change.edges[e]);
    // The rows between the two samples stretch on one side of the edge and close up on the other.
    const auto moved = [&](double time) { return time + shift * (1.0 - std::abs(time - middle) / edge.half_width); };
    out.times[edge.row] = middle + shift;
    for (std::size_t i = edge.row; i-- > 0 && window.input.times[i] > middle - edge.half_width;)
      out.times[i] = moved(window.input.times[i]);
    for (std::size_t i = edge.row + 1; i < out.times.size() && window.input.times[i] < middle + edge.half_width; ++i)
      out.times[i] = moved(window.input.times[i]);
  }
  return out;
}

ModelInput at_samples(const Window& window, const data::Run& run) {
  const ModelInput& input = window.input;
  ModelInput out;
  std::size_t row = 0;
  for (std::size_t i = window.range.first; i < window.range.last; ++i) {
    while (row + 1 < input.times.size() && input.times[row + 1] <= run.times[i]) ++row;
    const std::size_t next = input.goes_straight(row) ? row + 1 : row;
    const double share = next == row ? 0.0 : (run.times[i] - input.times[row]) / (input.times[next] - input.times[row]);
    const auto between_rows = [&](const auto& values) {
      return std::decay_t<decltype(values[row])>((1.0 - share) * values[row] + share * values[next]);
    };
    out.times.push_back(run.times[i]);
    out.currents.push_back(between_rows(input.currents));
    if (!input.joint_torques.empty()) out.joint_torques.push_back(between_rows(input.joint_torques));
  }
  return out;
}

}  // namespace coilwright::measurement::replay
