#include "measurement/replay/window_input.hpp"

#include "measurement/replay/rig_change.hpp"

#include <algorithm>
#include <boost/math/interpolators/cubic_hermite.hpp>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

namespace coilwright::measurement::replay {
namespace {

using simulation::ModelInput;

// Less than this share of what the input does in a window is no bend.
constexpr double least_bend = 0.003;

// A row that is off a parabola by less than this share of what the input does in a window is no corner: an angle of 50
// deg is then 5e-4 deg off at most.
constexpr double least_corner = 1e-5;

// Between rows at most this far apart a cubic gives the motion of a finger at 10 Hz within 1e-5 of its amplitude.
constexpr double densest_needed = 0.004;  // s
// The input reaches so far beyond the samples for each standard deviation of the clocks.
constexpr double clock_deviations = 4.0;
// And always so far: a camera may stamp its pictures early (measurement_delay, down to -50 ms).
constexpr double least_reach = 0.05;  // s
// A step between two samples counts as an edge where it exceeds this share of what the input does in the run ...
constexpr double edge_share = 0.2;
// ... and this many times the median step that is not zero.
constexpr double edge_over_median = 4.0;

using Row = std::vector<double>;

Row between(const Row& from, const Row& to, double share) {
  Row out(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) out[i] = (1.0 - share) * from[i] + share * to[i];
  return out;
}

// Rows of the command and the time from which each is in force.
struct Rows {
  std::vector<double> times{};
  std::vector<Row> rows{};
  std::vector<std::size_t> samples{};  // of the input from which each is
  std::vector<double> shares{};        // of the way to the next sample at which it is
  std::vector<double> half_widths{};   // of the edge with which a row begins; 0 where it begins at a known time
  std::vector<Row> bends{};            // what a smooth curve has more than the row
  std::vector<char> straight{};        // whether the input goes straight to the next row instead of being held

  void add(double time, Row row, std::size_t sample, double half_width = 0.0) {
    times.push_back(time);
    samples.push_back(sample);
    shares.push_back(0.0);
    bends.emplace_back(row.size(), 0.0);
    rows.push_back(std::move(row));
    half_widths.push_back(half_width);
    straight.push_back(0);
  }
  void add_straight(double time, Row row, std::size_t sample, double share) {
    add(time, std::move(row), sample);
    shares.back() = share;
    straight.back() = 1;
  }
  // Towards a smooth curve that meets the straight one at both samples, `parts` rows apart. A polygon of so many parts
  // under an arc has 1 - 1 / parts^2 of its area: the bend is larger by that, so that the impulse is the curve's.
  void bend_last(const Row& smooth, std::size_t parts) {
    const double square = static_cast<double>(parts) * static_cast<double>(parts);
    for (std::size_t i = 0; i < smooth.size(); ++i)
      bends.back()[i] = square / (square - 1.0) * (smooth[i] - rows.back()[i]);
  }
  // At a time from that of row `row` to that of the next one.
  [[nodiscard]] Row at(std::size_t row, double time) const {
    if (straight[row] == 0) return rows[row];
    return between(rows[row], rows[row + 1], (time - times[row]) / (times[row + 1] - times[row]));
  }
};

double size_of_step(const Row& from, const Row& to) {
  double size = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) size = std::max(size, std::abs(to[i] - from[i]));
  return size;
}

// The smallest step between two samples of the input that counts as an edge.
double edge_of(const std::vector<Row>& rows) {
  Row least = rows.front();
  Row most = rows.front();
  std::vector<double> steps;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t c = 0; c < least.size(); ++c) {
      least[c] = std::min(least[c], rows[i][c]);
      most[c] = std::max(most[c], rows[i][c]);
    }
    if (i == 0) continue;
    if (const double step = size_of_step(rows[i - 1], rows[i]); step > 0.0) steps.push_back(step);
  }
  const double range = size_of_step(least, most);
  if (steps.empty()) return range;
  // A few edges and nothing else: they are their own median.
  constexpr std::size_t few = 20;
  if (10 * steps.size() < rows.size() || steps.size() < few) return edge_share * range;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return std::max(edge_share * range, edge_over_median * *middle);
}

// Slope at a node of the polynomial through it and the nodes around it, by Lagrange's formula.
double slope_at(const std::vector<double>& x, const std::vector<double>& y, std::size_t node, std::size_t from,
                std::size_t to) {
  double slope = 0.0;
  for (std::size_t k = from; k < to; ++k) {
    if (k == node) continue;
    double weight = 1.0 / (x[k] - x[node]);
    for (std::size_t j = from; j < to; ++j)
      if (j != node && j != k) weight *= (x[node] - x[j]) / (x[k] - x[j]);
    slope += weight * (y[k] - y[node]);
  }
  return slope;
}

// A smooth input between its samples: cubics whose slopes are those of polynomials through five samples. At six samples
// a period a sine keeps 99.6 % of its amplitude (straight lines: 91 %).
class SmoothInput {
 public:
  // Of the samples from `first` to one before `last`; at least two.
  SmoothInput(const std::vector<double>& times, const std::vector<Row>& rows, std::size_t first, std::size_t last) {
    constexpr std::size_t around = 5;
    const std::vector<double> x(times.begin() + static_cast<std::ptrdiff_t>(first),
                                times.begin() + static_cast<std::ptrdiff_t>(last));
    for (std::size_t column = 0; column < rows[first].size(); ++column) {
      std::vector<double> y;
      for (std::size_t i = first; i < last; ++i) y.push_back(rows[i][column]);
      std::vector<double> slopes;
      for (std::size_t i = 0; i < x.size(); ++i) {
        const std::size_t begin = std::min(i > around / 2 ? i - around / 2 : 0, x.size() - std::min(around, x.size()));
        slopes.push_back(slope_at(x, y, i, begin, std::min(begin + around, x.size())));
      }
      columns_.emplace_back(std::vector<double>(x), std::move(y), std::move(slopes));
    }
  }
  [[nodiscard]] Row at(double time) const {
    Row out;
    for (const auto& column : columns_) out.push_back(column(time));
    return out;
  }

 private:
  std::vector<boost::math::interpolators::cubic_hermite<std::vector<double>>> columns_;
};

// Into how many a straight part is cut, so that rows are dense and what bends between samples longer apart than 2 ms is
// seen (below, a sine of 10 Hz bends by less than least_bend).
std::size_t parts_of(double duration) {
  constexpr double never_bent = 0.002;  // s
  const auto dense = static_cast<std::size_t>(std::ceil(duration / densest_needed - 1e-6));
  return std::max<std::size_t>(dense, duration > never_bent * (1.0 + 1e-6) ? 2 : 1);
}

// Whether the rows between two lie on the parabola through these and the middle one (Newton's form), within `most`.
bool is_parabola(const std::vector<double>& times, const std::vector<Row>& rows, std::size_t first, std::size_t last,
                 double most) {
  const std::size_t middle = first + (last - first) / 2;
  for (std::size_t column = 0; column < rows[first].size(); ++column) {
    const auto slope = [&](std::size_t a, std::size_t b) {
      return (rows[b][column] - rows[a][column]) / (times[b] - times[a]);
    };
    const double early = slope(first, middle);
    const double bend = (slope(first, last) - early) / (times[last] - times[middle]);
    for (std::size_t i = first + 1; i < last; ++i) {
      const double on_it =
          rows[first][column] + (times[i] - times[first]) * (early + bend * (times[i] - times[middle]));
      if (!(std::abs(rows[i][column] - on_it) <= most)) return false;
    }
  }
  return true;
}

// Rows of a straight input at which an integration need not stop: pieces as long as they are parabolas, each of the
// lengths tried twice the one before. Empty: none.
std::vector<char> passed_rows(const std::vector<double>& times, const std::vector<Row>& rows,
                              const std::vector<char>& straight, double most) {
  constexpr std::size_t longest = 32;  // rows
  std::vector<char> out(rows.size(), 0);
  bool any = false;
  for (std::size_t first = 0; first + 1 < rows.size();) {
    std::size_t end = first;  // of what goes straight on from there
    while (end + 1 < rows.size() && straight[end] != 0 && end - first < longest) ++end;
    std::size_t last = first + 1;
    for (std::size_t length = 2; first + length <= end; length *= 2) {
      if (!is_parabola(times, rows, first, first + length, most)) break;
      last = first + length;
    }
    for (std::size_t i = first + 1; i < last; ++i) {
      out[i] = 1;
      any = true;
    }
    first = last;
  }
  return any ? out : std::vector<char>{};
}

// From sample to sample, straight, and what a smooth curve from edge to edge has more: a step of at least `edge` is an
// edge in the middle.
Rows between_samples(const data::Run& run, const std::vector<Row>& rows, std::optional<double> edge) {
  const std::vector<double>& times = run.times_of_inputs();
  Rows out;
  std::optional<SmoothInput> smooth;
  // Straight lines may have corners, which smooth curves round off as little as edges.
  const double corner = edge ? *edge : edge_of(rows);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const Row& from = rows[i];
    const Row& to = rows[i + 1];
    const double step = size_of_step(from, to);
    const double duration = times[i + 1] - times[i];
    const bool starts_a_part = i == 0 || size_of_step(rows[i - 1], from) >= corner;
    if (step < corner && starts_a_part) {
      std::size_t last = i + 1;
      while (last < rows.size() && size_of_step(rows[last - 1], rows[last]) < corner) ++last;
      smooth.emplace(times, rows, i, last);
    }
    if (step == 0.0) {
      // What is held already goes on.
      if (i == 0 || out.straight.back() != 0 || out.rows.back() != from) out.add(times[i], from, i);
    } else if (edge && step >= *edge) {
      out.add(times[i], from, i);
      out.add(times[i] + 0.5 * duration, to, i + 1, 0.5 * duration);
    } else {
      const std::size_t parts = parts_of(duration);
      for (std::size_t k = 0; k < parts; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(parts);
        const double time = times[i] + share * duration;
        out.add_straight(time, between(from, to, share), i, share);
        if (smooth && step < corner && k > 0) out.bend_last(smooth->at(time), parts);
      }
    }
  }
  out.add(times.back(), rows.back(), rows.size() - 1);
  return out;
}

// Held from sample to sample, in steps so fine that a straight line through the middles of what is held moves a finger
// as they do: it takes (w h)^2 / 24 more from a sine of frequency w than steps of h, 7e-4 at 10 Hz and 2 ms. An edge
// stays one.
Rows between_middles(const data::Run& run, const std::vector<Row>& rows) {
  const std::vector<double>& times = run.times_of_inputs();
  const double edge = edge_of(rows);
  const auto is_fine = [&](std::size_t i) {
    return i + 1 == rows.size() || times[i + 1] - times[i] <= densest_needed * (1.0 + 1e-6);
  };
  const auto goes_on = [&](std::size_t i) {
    if (i + 1 == rows.size() || !is_fine(i) || !is_fine(i + 1)) return false;
    const double step = size_of_step(rows[i], rows[i + 1]);
    return step > 0.0 && step < edge;
  };
  Rows out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool comes_straight = i > 0 && goes_on(i - 1);
    if (!comes_straight && (i == 0 || out.straight.back() != 0 || out.rows.back() != rows[i]))
      out.add(times[i], rows[i], i);
    if (i + 1 == rows.size()) {
      if (comes_straight) out.add(times[i], rows[i], i);
      break;
    }
    const double middle = 0.5 * (times[i] + times[i + 1]);
    if (goes_on(i))
      out.add_straight(middle, rows[i], i, 0.0);
    else if (comes_straight)
      out.add(middle, rows[i], i);
  }
  return out;
}

Rows rows_of(const data::Run& run, const CleanInput& clean) {
  const std::vector<Row>& rows = clean.rows;
  switch (run.hold) {
    case data::InputHold::zero_order:
      break;
    case data::InputHold::linear:
      return between_samples(run, rows, std::nullopt);
    case data::InputHold::unknown_within_sample:
      return between_samples(run, rows, edge_of(rows));
  }
  // Steps that a command has made are exact; those of a smoothed reading are none.
  if (clean.sigma > 0.0) return between_middles(run, rows);
  Rows out;
  for (std::size_t i = 0; i < rows.size(); ++i) out.add(run.times_of_inputs()[i], rows[i], i);
  return out;
}

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

}  // namespace

void set_input(Window& window, const data::Run& run, const CleanInput& clean, const actuator::Model& nominal) {
  const std::vector<Row>& rows = clean.rows;
  const Rows all = rows_of(run, clean);
  const double first = run.times[window.range.first];
  const double last = run.times[window.range.last - 1];
  const double end = last + reach_of(run, last - first);
  const Row flat(rows.front().size(), 0.0);
  simulation::CommandedInput command = run.command();
  command.times.clear();
  command.rows.clear();
  simulation::CommandedInput bend = command;
  window.edges.clear();
  std::vector<std::size_t> samples;  // of the input behind each row
  std::vector<double> shares;        // of the way from it to the next
  std::vector<char> straight;
  const auto add = [&](double time, Row row, Row more, std::size_t sample, double share, bool goes_straight) {
    command.times.push_back(time);
    command.rows.push_back(std::move(row));
    bend.times.push_back(time);
    bend.rows.push_back(std::move(more));
    samples.push_back(sample);
    shares.push_back(share);
    straight.push_back(goes_straight ? 1 : 0);
  };
  const auto add_row = [&](std::size_t row) {
    add(all.times[row], all.rows[row], all.bends[row], all.samples[row], all.shares[row], all.straight[row] != 0);
  };
  // What is held: straight parts are dense already.
  const auto fill_until = [&](double until) {
    const double from = command.times.back();
    const auto parts = static_cast<std::size_t>(std::ceil((until - from) / densest_needed - 1e-6));
    for (std::size_t k = 1; k < parts; ++k)
      add(from + (until - from) * static_cast<double>(k) / static_cast<double>(parts), Row(command.rows.back()),
          Row(bend.rows.back()), samples.back(), shares.back(), false);
  };
  // The row in force at the first sample.
  const auto after = std::upper_bound(all.times.begin(), all.times.end(), first);
  auto row = static_cast<std::size_t>(after - all.times.begin());
  if (row > 0) --row;
  const bool has_begun = all.times[row] <= first;
  if (run.hold == data::InputHold::zero_order) {
    add(first, has_begun ? all.at(row, first) : all.rows[row], flat, all.samples[row], all.shares[row],
        has_begun && all.straight[row] != 0);
  } else {
    // A run starts at rest under its first sample.
    constexpr double instant = 1e-6;  // s
    const std::vector<double>& times = run.times_of_inputs();
    const auto next = std::upper_bound(times.begin(), times.end(), first);
    const std::size_t sample = next == times.begin() ? 0 : static_cast<std::size_t>(next - times.begin()) - 1;
    add(first, rows[sample], flat, sample, 0.0, false);
    if (has_begun)
      add(first + instant, all.at(row, first + instant), all.bends[row], all.samples[row], all.shares[row],
          all.straight[row] != 0);
  }
  for (row += has_begun ? 1 : 0; row < all.times.size() && all.times[row] <= end; ++row) {
    if (all.times[row] <= command.times.back()) continue;
    fill_until(all.times[row]);
    if (all.half_widths[row] > 0.0)
      window.edges.push_back({.row = command.times.size(), .half_width = all.half_widths[row]});
    add_row(row);
  }
  if (command.times.back() < end) {
    fill_until(end);
    const bool was_straight = straight.back() != 0;
    add(end, was_straight ? all.at(row - 1, end) : Row(command.rows.back()), flat, samples.back(), shares.back(),
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
    // A bend lies in the middle between two samples, which are corners then.
    if (window.bend.times.empty())
      window.input.passed = passed_rows(command.times, command.rows, straight, least_corner * largest);
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
