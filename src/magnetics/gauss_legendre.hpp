#pragma once

#include <cstddef>

namespace coilwright::magnetics {

/// Nodes on (-1, 1) and weights of a mean value (they sum to 1), padded with zero weights to a multiple of 8 so that
/// vector code reads whole blocks; the padding repeats the last node, so that it is as harmless as the rest.
struct QuadratureRule {
  const double* node;
  const double* weight;
  std::size_t count;         ///< true number of nodes
  std::size_t padded_count;  ///< multiple of 8
};

inline constexpr int max_gauss_order = 64;

/// Gauss-Legendre rule of 1 to max_gauss_order nodes; lives as long as the program.
[[nodiscard]] QuadratureRule gauss_legendre(int order);

/// Nodes that integrate to a relative error of about exp(-digits) a function analytic inside the ellipse with foci at
/// the ends of the interval that passes the nearest singularity: `reach` = (sum of the distances from the singularity
/// to the two ends) / (length of the interval), >= 1. The error of n nodes falls as rho^(-2n) with
/// rho = reach + sqrt(reach^2 - 1) (Trefethen, Approximation Theory and Approximation Practice, th. 19.3). Not capped.
[[nodiscard]] double gauss_nodes_needed(double reach, double digits);

}  // namespace coilwright::magnetics
