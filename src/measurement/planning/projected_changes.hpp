#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "measurement/planning/linearised_records.hpp"
#include "measurement/planning/smallest_strength.hpp"

namespace coilwright::measurement::planning {

/// An effect whose changes are compared with those of others: at one strength, and what its other numbers change there.
struct ComparedEffect {
  actuator::Effect effect{};
  bool visible{};
  Eigen::Index numbers{};  ///< that a fit of it would have
};

/// Scalar products of what effects change in some records, from which all comparisons follow; those of further records
/// are added. Columns: of each effect its change, then one for each of its other numbers.
class ProjectedChanges {
 public:
  /// Simulates the runs once for each column.
  ProjectedChanges(const LinearisedRecords& records, const std::vector<ComparedEffect>& effects);

  /// The same with the runs of both.
  [[nodiscard]] ProjectedChanges with(const ProjectedChanges& more) const;

  [[nodiscard]] double samples() const noexcept { return samples_; }
  /// Length of what an effect changes beyond the declared numbers.
  [[nodiscard]] double length(std::size_t effect) const;
  /// The part of that which another effect, at any strength and shape nearby, cannot imitate.
  [[nodiscard]] double length_beyond(std::size_t effect, std::size_t other) const;
  [[nodiscard]] double cosine(std::size_t effect, std::size_t other) const;

 private:
  void project();

  std::vector<Eigen::Index> first_;  // column of each effect; at the end the number of columns
  std::vector<bool> either_sign_;    // of each effect
  Eigen::MatrixXd products_;         // of changes: (columns, columns)
  Eigen::MatrixXd on_declared_;      // of declared numbers' derivatives with changes: (p, columns)
  Eigen::MatrixXd normal_matrix_;    // of declared numbers, their priors included: (p, p)
  Eigen::MatrixXd prior_;            // share of the priors in it
  Eigen::MatrixXd projected_;        // of changes beyond the declared numbers: (columns, columns)
  double samples_ = 0.0;
};

}  // namespace coilwright::measurement::planning
