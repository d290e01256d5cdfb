#include "coilwright/actuator/model/torque_correction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace coilwright::actuator {
namespace {

constexpr std::size_t fewest_nodes = 3;

[[noreturn]] void refuse(std::string_view rule) {
  throw std::invalid_argument(fmt::format("torque_correction: {}", rule));
}

void validate(const CorrectionAxis& axis) {
  const std::string_view name = name_of(axis.variable);
  if (axis.nodes.size() < fewest_nodes)
    refuse(fmt::format("{} must have at least {} nodes; got {}", name, fewest_nodes, axis.nodes.size()));
  for (std::size_t i = 0; i < axis.nodes.size(); ++i) {
    if (!std::isfinite(axis.nodes[i])) refuse(fmt::format("nodes of {} must be finite; got {}", name, axis.nodes[i]));
    if (i > 0 && axis.nodes[i] <= axis.nodes[i - 1])
      refuse(fmt::format("nodes of {} must increase; got {:.6g} after {:.6g}", name, axis.nodes[i], axis.nodes[i - 1]));
  }
  if (axis.linear_below && !(std::isfinite(*axis.linear_below) && *axis.linear_below > 0.0))
    refuse(fmt::format("{} must be linear below a finite value > 0; got {}", name, *axis.linear_below));
}

// Of the natural cubic spline through `values` at `at`, the second derivative at each node: the tridiagonal system of
// its continuity, solved by elimination. Strided, so that rows and columns of a table are the same to it.
void second_derivatives(const std::vector<double>& at, const double* values, double* out, std::size_t stride) {
  const std::size_t n = at.size();
  std::vector<double> diagonal(n, 0.0);
  std::vector<double> right(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = at[i] - at[i - 1];
    const double after = at[i + 1] - at[i];
    diagonal[i] = (before + after) / 3.0;
    right[i] = (values[(i + 1) * stride] - values[i * stride]) / after -
               (values[i * stride] - values[(i - 1) * stride]) / before;
    if (i == 1) continue;
    const double factor = before / 6.0 / diagonal[i - 1];
    diagonal[i] -= factor * before / 6.0;
    right[i] -= factor * right[i - 1];
  }
  out[0] = 0.0;
  out[(n - 1) * stride] = 0.0;
  for (std::size_t i = n - 1; i-- > 1;)
    out[i * stride] = (right[i] - (at[i + 1] - at[i]) / 6.0 * out[(i + 1) * stride]) / diagonal[i];
}

// 1 at 0 and 0 from 1 on, twice differentiable: the quintic whose first and second derivatives vanish at both ends.
struct Fading {
  double value{};
  double slope{};
};
Fading fading(double share) {
  if (share <= 0.0) return {.value = 1.0};
  if (share >= 1.0) return {};
  const double rest = 1.0 - share;
  return {.value = 1.0 - share * share * share * (10.0 + share * (6.0 * share - 15.0)),
          .slope = -30.0 * share * share * rest * rest};
}

}  // namespace

std::string_view name_of(CorrectionVariable variable) {
  switch (variable) {
    case CorrectionVariable::angle:
      return "angle";
    case CorrectionVariable::rate:
      return "rate";
    case CorrectionVariable::current:
      return "current";
  }
  return "";
}

void validate(const TorqueCorrection& correction) {
  if (correction.axes.empty() || correction.axes.size() > 2)
    refuse(fmt::format("must be over one or two variables; got {}", correction.axes.size()));
  std::size_t nodes = 1;
  for (const CorrectionAxis& axis : correction.axes) {
    validate(axis);
    nodes *= axis.nodes.size();
  }
  if (correction.axes.size() == 2 && correction.axes[0].variable == correction.axes[1].variable)
    refuse(fmt::format("its variables must differ; got {} twice", name_of(correction.axes[0].variable)));
  if (correction.torques.size() != nodes)
    refuse(fmt::format("must have one torque per node, {} here; got {}", nodes, correction.torques.size()));
  for (const double torque : correction.torques)
    if (!std::isfinite(torque)) refuse(fmt::format("torques must be finite; got {}", torque));
}

double TorqueSurface::Axis::coordinate(double x) const {
  return linear_below ? std::asinh(x / *linear_below) : x;
}

double TorqueSurface::Axis::slope(double x) const {
  return linear_below ? 1.0 / std::hypot(x, *linear_below) : 1.0;
}

// What the values and the second derivatives at the two nodes around a place contribute to value and slope there.
struct TorqueSurface::Weights {
  std::size_t before{};
  double value[2]{}, value_slope[2]{};
  double second[2]{}, second_slope[2]{};

  Weights(const Axis& axis, double x) {
    const double u = axis.coordinate(x);
    const std::vector<double>& at = axis.at;
    const auto upper = std::upper_bound(at.begin() + 1, at.end() - 1, u);
    before = static_cast<std::size_t>(upper - at.begin()) - 1;
    const double h = at[before + 1] - at[before];
    const double inside = std::clamp(u, at.front(), at.back());
    const double b = (inside - at[before]) / h;
    const double a = 1.0 - b;
    const double beyond = u - inside;
    const double width = std::copysign(fading_share * (at.back() - at.front()), beyond);
    const Fading fade = fading(beyond / width);
    const double fade_slope = fade.slope / width;
    const double per_x = axis.slope(x);
    // At an edge the slope is that of the spline, and the second derivative is zero: going on straight is smooth.
    const auto set = [&](double at_edge, double edge_slope, double& out, double& out_slope) {
      const double straight = at_edge + beyond * edge_slope;
      out = fade.value * straight;
      out_slope = (fade.value * edge_slope + (beyond != 0.0 ? fade_slope * straight : 0.0)) * per_x;
    };
    set(a, -1.0 / h, value[0], value_slope[0]);
    set(b, 1.0 / h, value[1], value_slope[1]);
    set((a * a * a - a) * h * h / 6.0, -(3.0 * a * a - 1.0) * h / 6.0, second[0], second_slope[0]);
    set((b * b * b - b) * h * h / 6.0, (3.0 * b * b - 1.0) * h / 6.0, second[1], second_slope[1]);
  }
};

TorqueSurface::TorqueSurface(const TorqueCorrection& correction) {
  validate(correction);
  for (const CorrectionAxis& axis : correction.axes) {
    Axis made{.at = {}, .linear_below = axis.linear_below};
    for (const double node : axis.nodes) made.at.push_back(made.coordinate(node));
    axes_.push_back(std::move(made));
  }
  values_ = correction.torques;
  const std::size_t rows = axes_[0].at.size();
  const std::size_t columns = axes_.size() == 2 ? axes_[1].at.size() : 1;
  along_first_.resize(values_.size());
  for (std::size_t c = 0; c < columns; ++c) second_derivatives(axes_[0].at, &values_[c], &along_first_[c], columns);
  if (axes_.size() == 1) return;
  along_second_.resize(values_.size());
  along_both_.resize(values_.size());
  for (std::size_t r = 0; r < rows; ++r) {
    second_derivatives(axes_[1].at, &values_[r * columns], &along_second_[r * columns], 1);
    second_derivatives(axes_[1].at, &along_first_[r * columns], &along_both_[r * columns], 1);
  }
}

TorqueSurface::Value TorqueSurface::at(double first, double second) const {
  const Weights x(axes_[0], first);
  Value out;
  if (axes_.size() == 1) {
    for (std::size_t i = 0; i < 2; ++i) {
      out.torque += x.value[i] * values_[x.before + i] + x.second[i] * along_first_[x.before + i];
      out.slopes[0] += x.value_slope[i] * values_[x.before + i] + x.second_slope[i] * along_first_[x.before + i];
    }
    return out;
  }
  const Weights y(axes_[1], second);
  const std::size_t columns = axes_[1].at.size();
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t node = (x.before + i) * columns + y.before + k;
      const double along_y = y.value[k] * values_[node] + y.second[k] * along_second_[node];
      const double bent = y.value[k] * along_first_[node] + y.second[k] * along_both_[node];
      const double slope_y = y.value_slope[k] * values_[node] + y.second_slope[k] * along_second_[node];
      const double slope_bent = y.value_slope[k] * along_first_[node] + y.second_slope[k] * along_both_[node];
      out.torque += x.value[i] * along_y + x.second[i] * bent;
      out.slopes[0] += x.value_slope[i] * along_y + x.second_slope[i] * bent;
      out.slopes[1] += x.value[i] * slope_y + x.second[i] * slope_bent;
    }
  }
  return out;
}

}  // namespace coilwright::actuator
