#include "measurement/replay/input_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "coilwright/algebra/smooth_curve.hpp"
#include "measurement/replay/input_curve.hpp"

namespace coilwright::measurement::replay {
namespace {

using Row = InputRow;

// A step between two samples counts as an edge where it exceeds this share of what the input does in the run ...
constexpr double edge_share = 0.2;
// ... and this many times the median step that is not zero.
constexpr double edge_over_median_step = 4.0;

Row between(const Row& from, const Row& to, double share) {
  Row out(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) out[i] = (1.0 - share) * from[i] + share * to[i];
  return out;
}

// The smallest step between two samples of the input that counts as an edge.
double edge_of(const std::vector<Row>& rows) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (const double step = size_of_step(rows[i - 1], rows[i]); step > 0.0) steps.push_back(step);
  const double range = range_of(rows);
  if (steps.empty()) return range;
  // A few edges and nothing else: they are their own median.
  constexpr std::size_t few = 20;
  if (10 * steps.size() < rows.size() || steps.size() < few) return edge_share * range;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return std::max(edge_share * range, edge_over_median_step * *middle);
}

// A constant stretch of so many samples is held, and no part of what moves.
constexpr std::size_t least_hold = 8;

// Which intervals between two samples may belong to a smooth curve: no edge, and no part of a long hold.
template <class Allowed>
std::vector<char> smooth_intervals(const std::vector<Row>& rows, const Allowed& allowed) {
  constexpr double rounding = 1e-9;  // of the range
  const double nothing = rounding * range_of(rows);
  const auto is_flat = [&](std::size_t i) { return size_of_step(rows[i], rows[i + 1]) <= nothing; };
  const std::size_t intervals = rows.size() - 1;
  std::vector<char> out(rows.size(), 0);
  for (std::size_t i = 0; i < intervals; ++i) out[i] = allowed(i) ? 1 : 0;
  for (std::size_t i = 0; i < intervals; ++i) {
    std::size_t end = i;
    while (end < intervals && is_flat(end)) ++end;
    if (end - i < least_hold) continue;
    for (; i < end; ++i) out[i] = 0;
  }
  // A part neither begins nor ends with what is held.
  for (std::size_t i = 0; i < intervals; ++i)
    if (is_flat(i) && (i == 0 || out[i - 1] == 0)) out[i] = 0;
  for (std::size_t i = intervals; i-- > 0;)
    if (is_flat(i) && out[i + 1] == 0) out[i] = 0;
  return out;
}

// One past the last of the marked intervals from `first` on.
std::size_t end_of_part(const std::vector<char>& marked, std::size_t first) {
  std::size_t end = first;
  while (end < marked.size() && marked[end] != 0) ++end;
  return end;
}

template <class Values>
std::vector<Values> part_of(const std::vector<Values>& all, std::size_t first, std::size_t last) {
  return {all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

// Rows as they are put together.
class RowsBuilder {
 public:
  void add(double time, Row row, std::size_t sample, double half_width = 0.0) {
    out_.times.push_back(time);
    out_.samples.push_back(sample);
    out_.shares.push_back(0.0);
    out_.bends.emplace_back(row.size(), 0.0);
    out_.rows.push_back(std::move(row));
    out_.half_widths.push_back(half_width);
    out_.straight.push_back(0);
    out_.smooth.push_back(0);
  }
  void add_straight(double time, Row row, std::size_t sample, double share) {
    add(time, std::move(row), sample);
    out_.shares.back() = share;
    out_.straight.back() = 1;
  }
  // Of a curve that goes on to the next row.
  void add_smooth(double time, Row row, std::size_t sample, double share = 0.0) {
    add_straight(time, std::move(row), sample, share);
    out_.smooth.back() = 1;
  }
  void set_last_bend(Row bend) { out_.bends.back() = std::move(bend); }
  // Whether the last row holds `row` until the next one.
  [[nodiscard]] bool holds(const Row& row) const {
    return !out_.rows.empty() && out_.straight.back() == 0 && out_.rows.back() == row;
  }
  [[nodiscard]] InputRows take() { return std::move(out_); }

 private:
  InputRows out_{};
};

// Into how many an interval is cut, so that rows are dense.
std::size_t parts_of(double duration) {
  return static_cast<std::size_t>(std::ceil(duration / densest_needed - 1e-6));
}

// Samples that are closer go along a smooth curve that moves a finger as straight lines between them do; of a sine of
// 10 Hz at 10 ms the curve keeps 8e-4 more than lines do.
constexpr double closest_apart = 0.01 * (1.0 + 1e-6);  // s

Row sum_of(const Row& a, const Row& b, double factor = 1.0) {
  Row out(a.size());
  for (std::size_t c = 0; c < a.size(); ++c) out[c] = a[c] + factor * b[c];
  return out;
}

// The samples from `first` to one before `last`, and what lies between them, of a part that is smooth.
void add_smooth_part(RowsBuilder& out, const std::vector<double>& all_times, const std::vector<Row>& all_rows,
                     std::size_t first, std::size_t last) {
  const std::vector<double> times = part_of(all_times, first, last);
  const std::vector<Row> rows = part_of(all_rows, first, last);
  const algebra::SmoothCurve through_samples = curve_through(times, rows, 0, rows.size() - 1);
  const algebra::SmoothCurve of_lines = curve_through(times, lines_as_curve(times, rows), 0, rows.size() - 1);
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const double duration = times[i + 1] - times[i];
    const std::size_t parts = parts_of(duration);
    for (std::size_t k = 0; k < parts; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(parts);
      const double time = times[i] + share * duration;
      const Row line = row_at(of_lines, time);
      out.add_smooth(time, line, first + i, share);
      out.set_last_bend(sum_of(row_at(through_samples, time), line, -1.0));
    }
  }
}

// A straight line between two samples that lie far apart. Towards a smooth curve that meets it at both, `parts` rows
// apart, a polygon of so many parts under an arc has 1 - 1 / parts^2 of its area: the bend is larger by that, so that
// the impulse is the curve's.
void add_line(RowsBuilder& out, const std::vector<double>& times, const std::vector<Row>& rows, std::size_t i,
              const algebra::SmoothCurve* smooth) {
  const double duration = times[i + 1] - times[i];
  constexpr double never_bent = 0.002;  // s: a sine of 10 Hz bends by less than least_bend
  const std::size_t parts = std::max<std::size_t>(parts_of(duration), duration > never_bent * (1.0 + 1e-6) ? 2 : 1);
  const double square = static_cast<double>(parts) * static_cast<double>(parts);
  for (std::size_t k = 0; k < parts; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(parts);
    const double time = times[i] + share * duration;
    const Row line = between(rows[i], rows[i + 1], share);
    out.add_straight(time, line, i, share);
    if (smooth == nullptr || k == 0) continue;
    Row bend = sum_of(row_at(*smooth, time), line, -1.0);
    for (double& each : bend) each *= square / (square - 1.0);
    out.set_last_bend(std::move(bend));
  }
}

// From sample to sample, straight, and what a smooth curve from edge to edge has more: a step of at least `edge` is an
// edge in the middle.
InputRows between_samples(const data::Run& run, const std::vector<Row>& rows, std::optional<double> edge) {
  const std::vector<double>& times = run.times_of_inputs();
  RowsBuilder out;
  std::optional<algebra::SmoothCurve> smooth;
  // Straight lines may have corners, which smooth curves round off as little as edges.
  const double corner = edge ? *edge : edge_of(rows);
  const auto is_corner = [&](std::size_t i) { return size_of_step(rows[i], rows[i + 1]) >= corner; };
  const std::vector<char> close =
      smooth_intervals(rows, [&](std::size_t i) { return !is_corner(i) && times[i + 1] - times[i] <= closest_apart; });
  std::size_t known = 0;  // until where it is known that no curve goes on
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    if (i >= known) {
      known = std::max(end_of_part(close, i), i + 1);
      if (is_of_a_curve(part_of(rows, i, known))) {
        add_smooth_part(out, times, rows, i, known);
        smooth.reset();
        i = known - 1;
        continue;
      }
    }
    const Row& from = rows[i];
    const Row& to = rows[i + 1];
    const double step = size_of_step(from, to);
    if (step < corner && (i == 0 || is_corner(i - 1) || !smooth)) {
      std::size_t last = i + 1;
      while (last + 1 < rows.size() && !is_corner(last)) ++last;
      smooth = curve_through(times, rows, i, last);
    }
    if (step == 0.0) {
      // What is held already goes on.
      if (!out.holds(from)) out.add(times[i], from, i);
    } else if (edge && step >= *edge) {
      const double duration = times[i + 1] - times[i];
      out.add(times[i], from, i);
      out.add(times[i] + 0.5 * duration, to, i + 1, 0.5 * duration);
    } else {
      add_line(out, times, rows, i, smooth && step < corner ? &*smooth : nullptr);
    }
  }
  out.add(times.back(), rows.back(), rows.size() - 1);
  return out.take();
}

// Held from sample to sample, in steps so fine that a smooth curve through the middles of what is held moves a finger
// as they do: of a sine of 10 Hz at 4 ms the two differ by 1e-5. Steps that are coarse, uneven, few or rough stay what
// they are, but for those of a smoothed reading, which are none. An edge stays one.
InputRows between_middles(const data::Run& run, const CleanInput& clean) {
  constexpr double least_uneven = 1e-3;  // of a step
  const std::vector<Row>& rows = clean.rows;
  const std::vector<double>& times = run.times_of_inputs();
  const double edge = edge_of(rows);
  const auto length = [&](std::size_t i) {
    return i + 1 < rows.size() ? times[i + 1] - times[i] : times[i] - times[i - 1];
  };
  std::vector<char> goes_on = smooth_intervals(rows, [&](std::size_t i) {
    const double most = densest_needed * (1.0 + 1e-6);
    const bool even = clean.sigma > 0.0 || std::abs(length(i + 1) - length(i)) <= least_uneven * length(i);
    return length(i) <= most && length(i + 1) <= most && even && size_of_step(rows[i], rows[i + 1]) < edge;
  });
  RowsBuilder out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t end = end_of_part(goes_on, i);  // its last row
    const bool is_curve = end > i && !clean.as_steps && is_of_a_curve(part_of(rows, i, end));
    if (end == i || (clean.sigma == 0.0 && !is_curve)) {
      for (std::size_t k = i; k <= end; ++k)
        if (clean.sigma == 0.0 || !out.holds(rows[k])) out.add(times[k], rows[k], k);
      i = end;
      continue;
    }
    if (!out.holds(rows[i])) out.add(times[i], rows[i], i);
    std::vector<double> middles;
    for (std::size_t k = i; k <= end; ++k) middles.push_back(times[k] + 0.5 * length(k));
    std::vector<Row> values = part_of(rows, i, end);
    if (is_curve) values = steps_as_curve(middles, part_of(times, i, end), values);
    for (std::size_t k = i; k < end; ++k) {
      if (is_curve)
        out.add_smooth(middles[k - i], values[k - i], k);
      else
        out.add_straight(middles[k - i], values[k - i], k, 0.0);
    }
    out.add(middles.back(), rows[end], end);
    i = end;
  }
  return out.take();
}

}  // namespace

InputRow InputRows::at(std::size_t row, double time) const {
  if (straight[row] == 0) return rows[row];
  constexpr std::size_t around = 3;
  std::size_t first = row;
  std::size_t last = row + 1;
  while (smooth[row] != 0 && first > 0 && smooth[first - 1] != 0 && row - first < around) --first;
  while (smooth[row] != 0 && smooth[last] != 0 && last - row < around) ++last;
  return row_at(curve_through(times, rows, first, last), time);
}

double size_of_step(const Row& from, const Row& to) {
  double size = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) size = std::max(size, std::abs(to[i] - from[i]));
  return size;
}

InputRows input_rows(const data::Run& run, const CleanInput& clean) {
  const std::vector<Row>& rows = clean.rows;
  switch (run.hold) {
    case data::InputHold::zero_order:
      break;
    case data::InputHold::linear:
      return between_samples(run, rows, std::nullopt);
    case data::InputHold::unknown_within_sample:
      return between_samples(run, rows, edge_of(rows));
  }
  return between_middles(run, clean);
}

}  // namespace coilwright::measurement::replay
