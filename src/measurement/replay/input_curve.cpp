#include "measurement/replay/input_curve.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace coilwright::measurement::replay {
namespace {

using Row = InputRow;

std::vector<double> flat(const std::vector<Row>& rows, std::size_t first, std::size_t last) {
  std::vector<double> out;
  for (std::size_t i = first; i <= last; ++i) out.insert(out.end(), rows[i].begin(), rows[i].end());
  return out;
}

// The integrals of an input over a time, and over the time since a first one times the input: what it does to speeds
// and places of what is slow.
struct Impulse {
  Row whole, moment;
  explicit Impulse(std::size_t width) : whole(width, 0.0), moment(width, 0.0) {}
  // Of v + d (slope + d (bend + d twist)) from `begin` on, over `duration`.
  void add(std::size_t column, const algebra::SmoothCurve::Cubic& u, double begin, double duration) {
    const double h = duration;
    const double part = h * (u.value + h * (u.slope / 2.0 + h * (u.bend / 3.0 + h * u.twist / 4.0)));
    whole[column] += part;
    moment[column] +=
        begin * part + h * h * (u.value / 2.0 + h * (u.slope / 3.0 + h * (u.bend / 4.0 + h * u.twist / 5.0)));
  }
  void add_line(const Row& from, const Row& to, double begin, double duration) {
    for (std::size_t c = 0; c < from.size(); ++c)
      add(c, {.value = from[c], .slope = (to[c] - from[c]) / duration}, begin, duration);
  }
};

Impulse impulse_of(const algebra::SmoothCurve& curve) {
  Impulse out(curve.width());
  const std::span<const double> times = curve.times();
  for (std::size_t i = 0; i + 1 < times.size(); ++i)
    for (std::size_t c = 0; c < curve.width(); ++c)
      out.add(c, curve.cubic(i, c), times[i] - times.front(), times[i + 1] - times[i]);
  return out;
}

// Moves the second and the last but one of rows at `times` so that the curve through all has this impulse: whatever its
// slopes at the ends are, which noise may make large, it then leaves speeds and places behind as they should be.
void give_impulse(const std::vector<double>& times, std::vector<Row>& rows, const Impulse& wanted) {
  const std::size_t last = rows.size() - 1;
  const std::size_t width = rows.front().size();
  const std::vector<Row> none(rows.size(), Row(width, 0.0));
  const Impulse has = impulse_of(curve_through(times, rows, 0, last));
  const auto of_one = [&](std::size_t row) {
    std::vector<Row> one = none;
    one[row] = Row(width, 1.0);
    return impulse_of(curve_through(times, one, 0, last));
  };
  const Impulse early = of_one(1);
  const Impulse late = of_one(last - 1);
  for (std::size_t c = 0; c < width; ++c) {
    const double whole = wanted.whole[c] - has.whole[c];
    const double moment = wanted.moment[c] - has.moment[c];
    const double determinant = early.whole[c] * late.moment[c] - late.whole[c] * early.moment[c];
    rows[1][c] += (whole * late.moment[c] - late.whole[c] * moment) / determinant;
    rows[last - 1][c] += (early.whole[c] * moment - whole * early.moment[c]) / determinant;
  }
}

}  // namespace

algebra::SmoothCurve curve_through(const std::vector<double>& times, const std::vector<Row>& rows, std::size_t first,
                                   std::size_t last) {
  return {std::span(times).subspan(first, last + 1 - first), flat(rows, first, last), rows[first].size()};
}

Row row_at(const algebra::SmoothCurve& curve, double time) {
  Row out(curve.width());
  curve.at(time, out);
  return out;
}

double range_of(const std::vector<Row>& rows) {
  Row least = rows.front();
  Row most = rows.front();
  for (const Row& row : rows)
    for (std::size_t c = 0; c < least.size(); ++c) {
      least[c] = std::min(least[c], row[c]);
      most[c] = std::max(most[c], row[c]);
    }
  return size_of_step(least, most);
}

bool is_of_a_curve(const std::vector<Row>& rows) {
  constexpr double rough = 0.5;     // of second differences
  constexpr double little = 0.004;  // of the range: noise of a two-thousandth of it
  if (rows.size() < 5) return false;
  double fourth = 0.0;
  double second = 0.0;
  for (std::size_t i = 2; i + 2 < rows.size(); ++i)
    for (std::size_t c = 0; c < rows[i].size(); ++c) {
      const auto bend = [&](std::size_t k) { return rows[k + 1][c] - 2.0 * rows[k][c] + rows[k - 1][c]; };
      const double change = bend(i + 1) - 2.0 * bend(i) + bend(i - 1);
      fourth += change * change;
      second += bend(i) * bend(i);
    }
  const auto count = static_cast<double>(rows.size() - 4);
  return std::sqrt(fourth / count) <= rough * std::sqrt(second / count) + little * range_of(rows);
}

std::vector<Row> lines_as_curve(const std::vector<double>& times, const std::vector<Row>& rows) {
  // Lines take (w h)^2 / 12 from a sine of frequency w: the error of the trapezoidal rule, h^3 / 12 of the second
  // derivative for each.
  std::vector<Row> out = rows;
  for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
    const double before = times[i] - times[i - 1];
    const double after = times[i + 1] - times[i];
    const double apart = before + after;
    for (std::size_t c = 0; c < rows[i].size(); ++c) {
      const double second =
          2.0 / apart * ((rows[i + 1][c] - rows[i][c]) / after - (rows[i][c] - rows[i - 1][c]) / before);
      out[i][c] += second * (before * before * before + after * after * after) / (12.0 * apart);
    }
  }
  Impulse wanted(rows.front().size());
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    wanted.add_line(rows[i], rows[i + 1], times[i] - times.front(), times[i + 1] - times[i]);
  give_impulse(times, out, wanted);
  return out;
}

std::vector<Row> steps_as_curve(const std::vector<double>& middles, const std::vector<double>& times,
                                const std::vector<Row>& rows) {
  // Steps take (w h)^2 / 24.
  std::vector<Row> out = rows;
  for (std::size_t i = 1; i + 1 < rows.size(); ++i)
    for (std::size_t c = 0; c < rows[i].size(); ++c)
      out[i][c] += (rows[i + 1][c] - 2.0 * rows[i][c] + rows[i - 1][c]) / 24.0;
  Impulse wanted(rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double begin = i == 0 ? middles[i] : times[i];
    const double end = i + 1 < rows.size() ? times[i + 1] : middles[i];
    if (end > begin) wanted.add_line(rows[i], rows[i], begin - middles.front(), end - begin);
  }
  give_impulse(middles, out, wanted);
  return out;
}

}  // namespace coilwright::measurement::replay
