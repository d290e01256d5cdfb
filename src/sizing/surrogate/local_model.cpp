#include "sizing/surrogate/local_model.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "sizing/sampling/eigen_vectors.hpp"

namespace coilwright::sizing {
namespace {

// By how much the model's constraints must hold (in their scale): the optimum lies on them, and the model's error is a
// few roundings.
constexpr double model_margin = 1e-6;
// Range of a constraint over a model's nodes above which it is compressed; constraints are scaled to order 1.
constexpr double steep = 50.0;

// Structure that noise does not reach by chance: with 90 nodes its standard deviation is 0.1.
constexpr double least_structure = 0.35;
// An axis along which all of the residual is structure counts ten times as far.
constexpr double largest_axis_weight = 100.0;

// Enough nodes for a full quadratic and half as many again, within what a factorisation costs (100 nodes: 0.2 ms).
std::size_t node_count(std::size_t dimension) {
  const std::size_t quadratic = (dimension + 1) * (dimension + 2) / 2;
  return std::min<std::size_t>(quadratic + quadratic / 2 + 8, 90);
}

// The values of a constraint that runs over decades would hide its own limit, so its logarithm is modelled beyond order
// 1. The limit stays where it is, and constraints of order 1 everywhere (as any is near the answer) stay as they are.
void compress_steep_constraints(Eigen::Ref<Eigen::MatrixXd> values) {
  for (auto column : values.colwise()) {
    if (column.maxCoeff() - column.minCoeff() > steep)
      column = column.unaryExpr([](double v) { return std::asinh(v); });
  }
}

// Structure of `residual` along an axis: 1 minus the ratio of von Neumann, half the mean square of successive
// differences over the variance, of the nodes in the order of that coordinate. 0 for noise, towards 1 for a smooth
// function of it.
double structure_along(const Eigen::VectorXd& residual, const std::vector<Eigen::Index>& order) {
  double sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i) sum += std::pow(residual[order[i]] - residual[order[i - 1]], 2);
  return 1 - sum / (2 * residual.squaredNorm());
}

}  // namespace

LocalModel::LocalModel(const Samples& samples, const Goal& goal, const Region& region)
    : goal_{goal}, samples_{samples} {
  const Sample& from = samples[region.from];
  const Sample& to = samples[region.to];
  const std::size_t wanted = node_count(samples.space().dimension());
  const std::vector<double> a = at_level(region, from), b = at_level(region, to);
  Samples::Neighbourhood where{
      .combination = from.combination, .a = a, .b = b, .count = wanted, .spacing = region.node_spacing};
  if (region.level) where.weighted_axis = region.level->axis;
  nodes_ = samples.nearest(where, Samples::Wanted::evaluated);
  if (nodes_.size() < 3) return;
  if (region.node_spacing == 0 && nodes_.size() == wanted && samples.space().is_wide()) {
    axis_weights_ = weights_of_axes();
    where.weights = axis_weights_;
    if (!where.weights.empty()) nodes_ = samples.nearest(where, Samples::Wanted::evaluated);
  }
  fit_values();
  set_box(region.margin);
  if (region.trust > 0) narrow_box(region.trust, a, b);
  fit_failures(where);
}

// The nodes in ascending order of one coordinate. Equal ones (many lie at an end of a range) in an order that has
// nothing to do with their distance.
std::vector<Eigen::Index> LocalModel::order_along(const Eigen::VectorXd& coordinate) const {
  std::vector<std::tuple<double, std::uint64_t, Eigen::Index>> keys;
  for (Eigen::Index i = 0; i < coordinate.size(); ++i) {
    const std::uint64_t index = nodes_[static_cast<std::size_t>(i)];
    keys.emplace_back(coordinate[i], index * 0x9E3779B97F4A7C15ULL, i);
  }
  std::ranges::sort(keys);
  std::vector<Eigen::Index> order;
  for (const auto& key : keys) order.push_back(std::get<2>(key));
  return order;
}

// With as many variables as a front in tens of dimensions has, quantities bend along few of them. There the nodes are
// taken nearer, and the model bends more: where a straight trend through the nodes leaves a structure along an axis.
std::vector<double> LocalModel::weights_of_axes() const {
  const auto count = static_cast<Eigen::Index>(nodes_.size());
  const auto dimension = static_cast<Eigen::Index>(samples_.space().dimension());
  if (count < dimension + 10) return {};
  const auto [at, outputs] = nodes_and_values();
  Eigen::MatrixXd trend(count, dimension + 1);
  trend << at, Eigen::VectorXd::Ones(count);
  const Eigen::MatrixXd residual = outputs - trend * trend.colPivHouseholderQr().solve(outputs);
  std::vector<double> weights(nodes_.empty() ? 0 : static_cast<std::size_t>(dimension), 1.0);
  bool any = false;
  for (Eigen::Index axis = 0; axis < dimension; ++axis) {
    const std::vector<Eigen::Index> order = order_along(at.col(axis));
    double structure = 0;
    for (Eigen::Index k = 0; k < residual.cols(); ++k) {
      if (residual.col(k).squaredNorm() <= 1e-16 * outputs.col(k).squaredNorm()) continue;
      structure = std::max(structure, structure_along(residual.col(k), order));
    }
    if (structure < least_structure) continue;
    weights[static_cast<std::size_t>(axis)] = 1 + largest_axis_weight * structure * structure;
    any = true;
  }
  return any ? weights : std::vector<double>{};
}

double LocalModel::merit(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd y = values_->values(x);
  const Eigen::VectorXd limits = y.tail(constraints());
  double worst = goal_.kind == Goal::Kind::feasibility || limits.size() == 0 ? 0.0 : limits.maxCoeff();
  if (failure_) worst = std::max(worst, failure_->values(x)[0]);
  return penalised(goal_.scalar(y.head(objectives()), limits), worst);
}

double LocalModel::required_error(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd y = values_->values(x);
  const Eigen::VectorXd limits = y.tail(constraints());
  double worst = goal_.scalar(y.head(objectives()), limits) - goal_.to_beat;
  if (limits.size() > 0) worst = std::max(worst, limits.maxCoeff());
  return failure_ ? std::max(worst, failure_->values(x)[0]) : worst;
}

Eigen::VectorXd LocalModel::minimise(const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free) const {
  const DesignFunctions functions{
      .at = [this](const Eigen::VectorXd& x, DesignFunctions::Wanted) { return linearised(x); },
      .objectives = objectives(),
      .constraints = constraints() + (failure_ ? 1 : 0),
      .margin = model_margin};
  // SLSQP needs tens of steps; with a looser tolerance it ended half way on the 30 variables of ZDT1.
  return sizing::minimise(functions, goal_, box_, start, free,
                          {.algorithm = Algorithm::slsqp, .max_calls = 120, .relative_tolerance = 1e-8});
}

LocalModel::NodesAndValues LocalModel::nodes_and_values() const {
  const auto count = static_cast<Eigen::Index>(nodes_.size());
  const auto dimension = static_cast<Eigen::Index>(samples_.space().dimension());
  NodesAndValues result{.nodes = Eigen::MatrixXd(count, dimension),
                        .values = Eigen::MatrixXd(count, objectives() + constraints())};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Sample& sample = samples_[nodes_[static_cast<std::size_t>(i)]];
    result.nodes.row(i) = as_vector(sample.unit).transpose();
    result.values.row(i) << as_vector(sample.values).transpose(), as_vector(sample.constraints).transpose();
  }
  compress_steep_constraints(result.values.rightCols(constraints()));
  return result;
}

void LocalModel::fit_values() {
  const auto [at, outputs] = nodes_and_values();
  values_.emplace(at, outputs, axis_weights_);
  box_ = {.lower = at.colwise().minCoeff().transpose(), .upper = at.colwise().maxCoeff().transpose()};
}

void LocalModel::set_box(double margin) {
  const Eigen::VectorXd range = box_.upper - box_.lower;
  const double widest = range.size() > 0 ? range.maxCoeff() : 0;
  for (Eigen::Index axis = 0; axis < range.size(); ++axis) {
    const double spacing = samples_.space().spacing(static_cast<std::size_t>(axis));
    const double extra = std::max({margin * range[axis], 0.05 * widest, 1.01 * spacing, 1e-6});
    box_.lower[axis] = std::max(0.0, box_.lower[axis] - extra);
    box_.upper[axis] = std::min(samples_.space().ceiling(static_cast<std::size_t>(axis)), box_.upper[axis] + extra);
  }
}

void LocalModel::narrow_box(double trust, const std::vector<double>& a, const std::vector<double>& b) {
  for (Eigen::Index axis = 0; axis < box_.lower.size(); ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double reach =
        std::max({trust * (box_.upper[axis] - box_.lower[axis]), 1.01 * samples_.space().spacing(i), 1e-6});
    box_.lower[axis] = std::max(box_.lower[axis], std::min(a[i], b[i]) - reach);
    box_.upper[axis] = std::min(box_.upper[axis], std::max(a[i], b[i]) + reach);
  }
}

// Failed designs have no values. A second surrogate, through -1 at evaluated and +1 at failed designs, is one more
// constraint.
void LocalModel::fit_failures(Samples::Neighbourhood where) {
  where.count /= 2;
  std::vector<std::size_t> failed = samples_.nearest(where, Samples::Wanted::failed);
  std::erase_if(failed, [&](std::size_t i) {
    const auto x = as_vector(samples_[i].unit);
    return (x.array() < box_.lower.array()).any() || (x.array() > box_.upper.array()).any();
  });
  if (failed.empty()) return;
  const std::size_t good = std::min(nodes_.size(), where.count);
  Eigen::MatrixXd at(static_cast<Eigen::Index>(good + failed.size()), box_.lower.size());
  Eigen::MatrixXd label(at.rows(), 1);
  for (std::size_t i = 0; i < good + failed.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    at.row(row) = as_vector(samples_[i < good ? nodes_[i] : failed[i - good]].unit).transpose();
    label(row, 0) = i < good ? -1.0 : 1.0;
  }
  failure_.emplace(at, label);
}

Linearisation LocalModel::linearised(const Eigen::VectorXd& x) const {
  Linearisation all = values_->linearised(x);
  if (!failure_) return all;
  const Linearisation failure = failure_->linearised(x);
  const Eigen::Index last = all.values.size();
  all.values.conservativeResize(last + 1);
  all.jacobian.conservativeResize(last + 1, Eigen::NoChange);
  all.values[last] = failure.values[0];
  all.jacobian.row(last) = failure.jacobian.row(0);
  return all;
}

}  // namespace coilwright::sizing
