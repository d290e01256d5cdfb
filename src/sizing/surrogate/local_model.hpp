#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "sizing/nlopt/goal_program.hpp"
#include "sizing/sampling/goal.hpp"
#include "sizing/sampling/samples.hpp"
#include "sizing/surrogate/region.hpp"
#include "sizing/surrogate/surrogate.hpp"

namespace coilwright::sizing {

/// A goal on surrogates of the objectives and constraints of one region. Immutable.
class LocalModel {
 public:
  /// `samples` and `goal` must outlive it.
  LocalModel(const Samples& samples, const Goal& goal, const Region& region);

  /// False where too few samples are known; then nothing else may be asked.
  [[nodiscard]] bool usable() const { return values_.has_value(); }
  /// Where the model is used.
  [[nodiscard]] const Box& box() const { return box_; }
  /// Indices of the samples that it goes through.
  [[nodiscard]] const std::vector<std::size_t>& nodes() const { return nodes_; }

  /// The goal plus a penalty on predicted violation, by which designs are ranked.
  [[nodiscard]] double merit(const Eigen::VectorXd& x) const;

  /// The smallest error of the model, in the goal or in a constraint, with which `x` would be progress.
  [[nodiscard]] double required_error(const Eigen::VectorXd& x) const;

  /// Minimises the goal over the box with SLSQP, from `start`, moving only the axes `free`.
  [[nodiscard]] Eigen::VectorXd minimise(const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free) const;

 private:
  struct NodesAndValues {
    Eigen::MatrixXd nodes, values;  // a row for each node
  };
  [[nodiscard]] NodesAndValues nodes_and_values() const;
  [[nodiscard]] std::vector<Eigen::Index> order_along(const Eigen::VectorXd& coordinate) const;
  [[nodiscard]] std::vector<double> weights_of_axes() const;
  void fit_values();
  void set_box(double margin);
  void narrow_box(double trust, const std::vector<double>& a, const std::vector<double>& b);
  void fit_failures(Samples::Neighbourhood where);
  [[nodiscard]] Linearisation linearised(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::Index objectives() const { return static_cast<Eigen::Index>(samples_.objective_count()); }
  [[nodiscard]] Eigen::Index constraints() const { return static_cast<Eigen::Index>(samples_.constraint_count()); }

  const Goal& goal_;
  const Samples& samples_;
  std::vector<std::size_t> nodes_;
  std::vector<double> axis_weights_;  // empty: all alike
  std::optional<Surrogate> values_, failure_;
  Box box_;
};

}  // namespace coilwright::sizing
