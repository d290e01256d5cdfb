#include "measurement/correction/correction_basis.hpp"

#include <algorithm>
#include <cmath>

#include "coilwright/algebra/spectral.hpp"

namespace coilwright::measurement::correction {
namespace {

using actuator::CorrectionAxis;
using actuator::CorrectionVariable;
using actuator::TorqueCorrection;

// The corrected motion goes a little further than that of the model without.
constexpr double widening = 0.03;
// A rate matters in all its orders of magnitude: a third of the nodes lie within a twentieth of the largest.
constexpr double linear_share = 1.0 / 30.0;
// Of the variance along the motions, what the directions that are left out may have together.
constexpr double variance_left_out = 3e-4;
// Share of a smooth random function that is the same over all of a variable: with it a torque over two variables is a
// sum of a constant, one function of each, and one of both.
constexpr double constant_share = 0.5;

struct Range {
  double lower, upper;
};

Range visited_range(CorrectionVariable variable, std::span<const JointSample> samples) {
  Range range{samples.front().of(variable), samples.front().of(variable)};
  for (const JointSample& each : samples) {
    range.lower = std::min(range.lower, each.of(variable));
    range.upper = std::max(range.upper, each.of(variable));
  }
  return range;
}

double coordinate(const CorrectionAxis& axis, double x) {
  return axis.linear_below ? std::asinh(x / *axis.linear_below) : x;
}

std::optional<CorrectionAxis> axis_of(const CorrectionShape::Variable& asked, std::span<const JointSample> samples) {
  Range range = visited_range(asked.variable, samples);
  if (!(range.upper - range.lower > 0.0)) return std::nullopt;
  CorrectionAxis axis{.variable = asked.variable};
  if (asked.variable == CorrectionVariable::rate) {
    range.upper = std::max(-range.lower, range.upper);
    range.lower = -range.upper;
    axis.linear_below = linear_share * range.upper;
  }
  const double wider = widening * (range.upper - range.lower);
  const double from = coordinate(axis, range.lower - wider);
  const double step = (coordinate(axis, range.upper + wider) - from) / (asked.nodes - 1);
  for (int i = 0; i < asked.nodes; ++i) {
    const double at = from + step * i;
    axis.nodes.push_back(axis.linear_below ? *axis.linear_below * std::sinh(at) : at);
  }
  // The middle of a symmetric axis is zero to the bit.
  if (axis.linear_below && asked.nodes % 2 == 1) axis.nodes[axis.nodes.size() / 2] = 0.0;
  return axis;
}

// Place of a value among the nodes of an axis, in distances of nodes.
double place(const CorrectionAxis& axis, double x) {
  const double from = coordinate(axis, axis.nodes.front());
  return (coordinate(axis, x) - from) / (coordinate(axis, axis.nodes.back()) - from) *
         static_cast<double>(axis.nodes.size() - 1);
}

// Covariance of a smooth random function at the nodes of an axis.
Eigen::MatrixXd covariance(const CorrectionShape::Variable& variable) {
  const double length = variable.correlation_length * (variable.nodes - 1);
  Eigen::MatrixXd out(variable.nodes, variable.nodes);
  for (int i = 0; i < variable.nodes; ++i)
    for (int k = 0; k < variable.nodes; ++k)
      out(i, k) = constant_share + (1.0 - constant_share) * std::exp(-0.5 * std::pow((i - k) / length, 2));
  return out;
}

Eigen::MatrixXd covariance(const CorrectionShape& shape) {
  Eigen::MatrixXd first = covariance(shape.variables[0]);
  if (shape.variables.size() == 1) return first;
  const Eigen::MatrixXd second = covariance(shape.variables[1]);
  const Eigen::Index n = second.rows();
  Eigen::MatrixXd out(first.rows() * n, first.rows() * n);
  for (Eigen::Index i = 0; i < first.rows(); ++i)
    for (Eigen::Index k = 0; k < first.rows(); ++k) out.block(i * n, k * n, n, n) = first(i, k) * second;
  return out;
}

// The cells between nodes, and how many samples lie in each. A cell has the number of its first node.
struct Cells {
  std::vector<std::size_t> of_sample{};
  std::vector<int> counts{};  // one per node
};

Cells cells_of(const std::vector<CorrectionAxis>& axes, std::span<const JointSample> samples) {
  const std::size_t columns = axes.size() == 2 ? axes[1].nodes.size() : 1;
  Cells out{.counts = std::vector<int>(axes[0].nodes.size() * columns, 0)};
  const auto before = [](const CorrectionAxis& axis, const JointSample& sample) {
    const double at = std::floor(place(axis, sample.of(axis.variable)));
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(axis.nodes.size() - 2)));
  };
  for (const JointSample& sample : samples) {
    const std::size_t cell = before(axes[0], sample) * columns + (axes.size() == 2 ? before(axes[1], sample) : 0);
    out.of_sample.push_back(cell);
    ++out.counts[cell];
  }
  return out;
}

// Whether any sample lies in a cell of which a node is a corner.
std::vector<char> visited_nodes(const std::vector<CorrectionAxis>& axes, const Cells& cells) {
  const std::size_t columns = axes.size() == 2 ? axes[1].nodes.size() : 1;
  std::vector<char> out(cells.counts.size(), 0);
  for (std::size_t cell = 0; cell < out.size(); ++cell) {
    if (cells.counts[cell] == 0) continue;
    for (const std::size_t corner : {cell, cell + 1, cell + columns, cell + columns + 1})  // one axis: cell + 1 twice
      if (corner < out.size()) out[corner] = 1;
  }
  return out;
}

double value_or_zero(const TorqueCorrection& correction, std::size_t axis, const JointSample& sample) {
  return axis < correction.axes.size() ? sample.of(correction.axes[axis].variable) : 0.0;
}

// What each node contributes to the torque at each sample: (samples, nodes).
Eigen::MatrixXd contributions(const std::vector<CorrectionAxis>& axes, std::span<const JointSample> samples,
                              std::size_t nodes) {
  Eigen::MatrixXd out(static_cast<Eigen::Index>(samples.size()), static_cast<Eigen::Index>(nodes));
  TorqueCorrection one{.axes = axes, .torques = std::vector<double>(nodes, 0.0)};
  for (std::size_t node = 0; node < nodes; ++node) {
    one.torques[node] = 1.0;
    out.col(static_cast<Eigen::Index>(node)) = torques_at(one, samples);
    one.torques[node] = 0.0;
  }
  return out;
}

}  // namespace

TorqueCorrection CorrectionBasis::correction(std::span<const double> coefficients, double scale) const {
  const Eigen::Map<const Eigen::VectorXd> z(coefficients.data(), directions.cols());
  const Eigen::VectorXd torques = scale * (directions * z);
  return {.axes = axes, .torques = {torques.data(), torques.data() + torques.size()}};
}

std::optional<CorrectionBasis> correction_basis(const CorrectionShape& shape, std::span<const JointSample> samples) {
  if (samples.empty()) return std::nullopt;
  CorrectionBasis out;
  for (const CorrectionShape::Variable& variable : shape.variables) {
    const auto axis = axis_of(variable, samples);
    if (!axis) return std::nullopt;
    out.axes.push_back(*axis);
  }
  const Cells cells = cells_of(out.axes, samples);
  out.visited = visited_nodes(out.axes, cells);
  const auto nodes = static_cast<Eigen::Index>(out.visited.size());
  Eigen::VectorXd near(nodes);
  for (Eigen::Index i = 0; i < nodes; ++i) near[i] = out.visited[static_cast<std::size_t>(i)] != 0 ? 1.0 : 0.0;
  // A square root of the covariance, of which nodes that the motion never came near have no part.
  const algebra::SymmetricModes smooth = algebra::symmetric_modes(covariance(shape));
  const Eigen::MatrixXd root =
      near.asDiagonal() * smooth.vectors * smooth.values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  Eigen::MatrixXd along = contributions(out.axes, samples, out.visited.size()) * root;
  // A pose in which the motion rested for long says little more than one through which it went.
  double weights = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double weight = 1.0 / static_cast<double>(cells.counts[cells.of_sample[i]]);
    along.row(static_cast<Eigen::Index>(i)) *= std::sqrt(std::sqrt(weight));
    weights += std::sqrt(weight);
  }
  const algebra::SymmetricModes varying = algebra::symmetric_modes(along.transpose() * along / weights);
  const double whole = varying.values.sum();
  Eigen::Index count = 0;
  double left = whole;
  while (count < std::min<Eigen::Index>(shape.most_directions, nodes) && left > variance_left_out * whole)
    left -= varying.values[nodes - 1 - count++];
  out.directions = root * varying.vectors.rightCols(count).rowwise().reverse();
  return out;
}

Eigen::VectorXd torques_at(const TorqueCorrection& correction, std::span<const JointSample> samples) {
  const actuator::TorqueSurface surface(correction);
  Eigen::VectorXd out(static_cast<Eigen::Index>(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i)
    out[static_cast<Eigen::Index>(i)] =
        surface.at(value_or_zero(correction, 0, samples[i]), value_or_zero(correction, 1, samples[i])).torque;
  return out;
}

}  // namespace coilwright::measurement::correction
