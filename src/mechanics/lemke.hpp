#pragma once

#include <Eigen/Core>
#include <optional>

namespace coilwright::mechanics {

/// How large a number must be to count in Lemke's method, for a problem whose entries are of the order of one.
struct LemkeTolerances {
  double pivot{};  ///< below it an entry of the entering column is rounding
  double tie{};    ///< below it, relative, two ratios are equal and the lexicographic rule decides
};

/// z >= 0 with w = matrix z + constant >= 0 and z . w = 0 by Lemke's method with the lexicographic rule (Cottle, Pang
/// and Stone, The Linear Complementarity Problem, 1992, algorithms 4.4.5 and 4.9.3), on a condensed tableau. Nothing
/// where it ends on a ray.
[[nodiscard]] std::optional<Eigen::VectorXd> lemke(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& constant,
                                                   const LemkeTolerances& tolerances);

}  // namespace coilwright::mechanics
