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

/// How fast Gauss-Legendre converges on a function analytic inside the ellipse with foci at the ends of the interval
/// that passes the nearest singularity: n nodes err by about rate^(-2n) (Trefethen, Approximation Theory and
/// Approximation Practice, th. 19.3). `to_ends` is the sum of the distances from the singularity to the two ends.
[[nodiscard]] double gauss_rate(double to_ends, double length);

/// Least multiple of 8 with rate^(-2n) <= error, at most max_gauss_order + 8, which says that no rule is enough.
[[nodiscard]] int gauss_order_of_blocks(double rate, double error);

/// Nodes n at which rate^(-2n) is the error whose natural logarithm is given; not capped.
[[nodiscard]] double gauss_nodes_needed(double rate, double log_error);

}  // namespace coilwright::magnetics
