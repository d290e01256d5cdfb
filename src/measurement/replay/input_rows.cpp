#include "measurement/replay/input_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "measurement/replay/smooth_input.hpp"

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
  return std::max(edge_share * range, edge_over_median_step * *middle);
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
  }
  void add_straight(double time, Row row, std::size_t sample, double share) {
    add(time, std::move(row), sample);
    out_.shares.back() = share;
    out_.straight.back() = 1;
  }
  // Towards a smooth curve that meets the straight one at both samples, `parts` rows apart. A polygon of so many parts
  // under an arc has 1 - 1 / parts^2 of its area: the bend is larger by that, so that the impulse is the curve's.
  void bend_last(const Row& smooth, std::size_t parts) {
    const double square = static_cast<double>(parts) * static_cast<double>(parts);
    for (std::size_t i = 0; i < smooth.size(); ++i)
      out_.bends.back()[i] = square / (square - 1.0) * (smooth[i] - out_.rows.back()[i]);
  }
  // Whether the last row holds `row` until the next one.
  [[nodiscard]] bool holds(const Row& row) const {
    return !out_.rows.empty() && out_.straight.back() == 0 && out_.rows.back() == row;
  }
  [[nodiscard]] InputRows take() { return std::move(out_); }

 private:
  InputRows out_{};
};

// Into how many a straight part is cut, so that rows are dense and what bends between samples longer apart than 2 ms is
// seen (below, a sine of 10 Hz bends by less than least_bend).
std::size_t parts_of(double duration) {
  constexpr double never_bent = 0.002;  // s
  const auto dense = static_cast<std::size_t>(std::ceil(duration / densest_needed - 1e-6));
  return std::max<std::size_t>(dense, duration > never_bent * (1.0 + 1e-6) ? 2 : 1);
}

// From sample to sample, straight, and what a smooth curve from edge to edge has more: a step of at least `edge` is an
// edge in the middle.
InputRows between_samples(const data::Run& run, const std::vector<Row>& rows, std::optional<double> edge) {
  const std::vector<double>& times = run.times_of_inputs();
  RowsBuilder out;
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
      if (!out.holds(from)) out.add(times[i], from, i);
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
  return out.take();
}

// Held from sample to sample, in steps so fine that a straight line through the middles of what is held moves a finger
// as they do: it takes (w h)^2 / 24 more from a sine of frequency w than steps of h, 7e-4 at 10 Hz and 2 ms. An edge
// stays one.
InputRows between_middles(const data::Run& run, const std::vector<Row>& rows) {
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
  RowsBuilder out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool comes_straight = i > 0 && goes_on(i - 1);
    if (!comes_straight && !out.holds(rows[i])) out.add(times[i], rows[i], i);
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
  return out.take();
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

}  // namespace

InputRow InputRows::at(std::size_t row, double time) const {
  if (straight[row] == 0) return rows[row];
  return between(rows[row], rows[row + 1], (time - times[row]) / (times[row + 1] - times[row]));
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
  // Steps that a command has made are exact; those of a smoothed reading are none.
  if (clean.sigma > 0.0) return between_middles(run, rows);
  RowsBuilder out;
  for (std::size_t i = 0; i < rows.size(); ++i) out.add(run.times_of_inputs()[i], rows[i], i);
  return out.take();
}

// Pieces as long as they are parabolas, each of the lengths tried twice the one before.
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

}  // namespace coilwright::measurement::replay
