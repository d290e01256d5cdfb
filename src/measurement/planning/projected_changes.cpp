#include "measurement/planning/projected_changes.hpp"

#include <algorithm>
#include <cmath>

#include "coilwright/algebra/minimum_norm.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/identification/effect_strength.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::Effect;

// How far a number is moved to see what it changes: far enough that it is no rounding, near enough to be a slope.
constexpr double step_of_a_shape = 0.2;

// The effect itself, then with each of its other numbers moved.
std::vector<Effect> variants(const Effect& effect) {
  std::vector<Effect> out{effect};
  const auto numbers = effect.kind->parameters();
  const auto main = main_number(*effect.kind);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i == main || !numbers[i].choices.empty()) continue;
    Effect moved = effect;
    const double size = std::abs(moved.values[i]);
    double step = step_of_a_shape * size;
    if (size == 0.0) step = std::isfinite(numbers[i].upper) ? 0.1 * step_of_a_shape * numbers[i].upper : 1e-6;
    moved.values[i] += moved.values[i] + step <= numbers[i].upper ? step : -step;
    moved.values[i] = std::clamp(moved.values[i], numbers[i].lower, numbers[i].upper);
    out.push_back(std::move(moved));
  }
  return out;
}

}  // namespace

ProjectedChanges::ProjectedChanges(const LinearisedRecords& records, const std::vector<ComparedEffect>& effects) {
  std::vector<Effect> columns;
  for (const ComparedEffect& each : effects) {
    first_.push_back(static_cast<Eigen::Index>(columns.size()));
    either_sign_.push_back(identification::may_be_negative(*each.effect.kind));
    for (Effect& variant : variants(each.effect)) columns.push_back(std::move(variant));
  }
  first_.push_back(static_cast<Eigen::Index>(columns.size()));
  const fit::Fit& base = records.base().fit;
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(base.stacked_residuals.size(), first_.back());
  std::vector<char> known(columns.size(), 0);
  fit::in_parallel(columns.size(), [&](std::size_t i) {
    const auto change = records.change_by(columns[i]);
    if (!change || !change->allFinite()) return;
    changes.col(static_cast<Eigen::Index>(i)) = *change;
    known[i] = 1;
  });
  for (std::size_t e = 0; e < effects.size(); ++e)
    for (Eigen::Index i = first_[e] + 1; i < first_[e + 1]; ++i)
      if (known[static_cast<std::size_t>(i)] != 0) changes.col(i) -= changes.col(first_[e]);
  products_ = changes.transpose() * changes;
  on_declared_ = base.jacobian.transpose() * changes;
  normal_matrix_ = base.normal_matrix;
  const Eigen::MatrixXd prior = records.base().hypothesis.prior_jacobian(records.base().fit.values);
  prior_ = prior.transpose() * prior;
  samples_ = static_cast<double>(base.samples());
  project();
}

ProjectedChanges ProjectedChanges::with(const ProjectedChanges& more) const {
  ProjectedChanges out = *this;
  out.products_ += more.products_;
  out.on_declared_ += more.on_declared_;
  out.normal_matrix_ += more.normal_matrix_ - more.prior_;  // numbers of one rig have one prior
  out.samples_ += more.samples_;
  out.project();
  return out;
}

void ProjectedChanges::project() {
  projected_ = products_;
  if (normal_matrix_.cols() > 0)
    projected_ -= on_declared_.transpose() * algebra::minimum_norm_columns(normal_matrix_, on_declared_);
}

double ProjectedChanges::length(std::size_t effect) const {
  return std::sqrt(std::max(0.0, projected_(first_[effect], first_[effect])));
}

double ProjectedChanges::length_beyond(std::size_t effect, std::size_t other) const {
  const Eigen::Index at = first_[effect];
  const Eigen::Index from = first_[other];
  const Eigen::Index count = first_[other + 1] - from;
  const Eigen::VectorXd along = projected_.col(at).segment(from, count);
  // Columns of unit length: numbers of very different sizes stay in the rank.
  const Eigen::VectorXd lengths =
      projected_.diagonal().segment(from, count).cwiseMax(0.0).cwiseSqrt().unaryExpr([](double each) {
        return each > 0.0 ? each : 1.0;
      });
  const Eigen::MatrixXd scaled = lengths.cwiseInverse().asDiagonal() * projected_.block(from, from, count, count) *
                                 lengths.cwiseInverse().asDiagonal();
  const Eigen::VectorXd right = along.cwiseQuotient(lengths);
  const Eigen::VectorXd shares = algebra::minimum_norm(scaled, right, 1e-6);
  if (shares[0] < 0.0 && !either_sign_[other]) return length(effect);
  return std::sqrt(std::max(0.0, projected_(at, at) - right.dot(shares)));
}

double ProjectedChanges::cosine(std::size_t effect, std::size_t other) const {
  const double lengths = length(effect) * length(other);
  return lengths > 0.0 ? projected_(first_[effect], first_[other]) / lengths : 0.0;
}

}  // namespace coilwright::measurement::planning
