#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "coilwright/actuator/model/torque_correction.hpp"
#include "measurement/correction/visited_states.hpp"

namespace coilwright::measurement::correction {

/// The variables of a correction, and how finely it may follow each.
struct CorrectionShape {
  struct Variable {
    actuator::CorrectionVariable variable{};
    int nodes{};
    /// Distance, as a share of the visited range, over which the torque may change by itself.
    double correlation_length{};
  };
  std::vector<Variable> variables{};  ///< one or two
  int most_directions{};              ///< free numbers at most
};

/// Smooth torques over one or two variables as a sum of a few directions: those in which a smooth random torque varies
/// most along the motions that were measured (Karhunen and Loeve).
struct CorrectionBasis {
  std::vector<actuator::CorrectionAxis> axes{};
  /// (nodes, directions). With independent standard normal coefficients the torques at the nodes are a smooth random
  /// function of rms about 1 where the motion was, and 0 at nodes that it never came near.
  Eigen::MatrixXd directions{};
  std::vector<char> visited{};  ///< for each node whether the motion came near

  [[nodiscard]] int size() const { return static_cast<int>(directions.cols()); }
  /// The correction whose torques are `scale` (N m) times these coefficients.
  [[nodiscard]] actuator::TorqueCorrection correction(std::span<const double> coefficients, double scale) const;
};

/// Nothing if a variable has no range.
[[nodiscard]] std::optional<CorrectionBasis> correction_basis(const CorrectionShape& shape,
                                                              std::span<const JointSample> samples);

/// The torque of a correction at the samples: (samples), N m.
[[nodiscard]] Eigen::VectorXd torques_at(const actuator::TorqueCorrection& correction,
                                         std::span<const JointSample> samples);

}  // namespace coilwright::measurement::correction
