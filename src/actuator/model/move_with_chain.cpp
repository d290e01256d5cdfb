#include "actuator/model/move_with_chain.hpp"

#include <cstddef>

#include "coilwright/mechanics/ldlt.hpp"

namespace coilwright::actuator {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;

using BodyMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_bodies, max_bodies>;
// A column for each body.
using Couplings =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mechanics::max_joints, max_bodies>;

// For sizes that the compiler knows, or any_count for the one met at run time.
constexpr int any_count = 0;

// With a0 what the chain would do by itself, theta'' = a0 - M^-1 C u'' leaves (m - C^T M^-1 C) u'' = f - C^T a0 for the
// bodies, whose masses m are a diagonal. With M = U^T D U and Y = U^-T C, C^T M^-1 C is Y^T D^-1 Y.
template <int Joints, int Bodies>
void move(JointMatrix& mass, std::span<const EffectTerm::Body> bodies, JointVector& accelerations, double* moved) {
  const int n = Joints == any_count ? static_cast<int>(accelerations.size()) : Joints;
  const int count = Bodies == any_count ? static_cast<int>(bodies.size()) : Bodies;
  mechanics::factorize_ldlt(mass, n);
  Couplings reduced(n, count);
  BodyMatrix free_mass(count, count);
  for (int b = 0; b < count; ++b) {
    const EffectTerm::Body& body = bodies[static_cast<std::size_t>(b)];
    auto column = reduced.col(b);
    moved[b] = body.force;
    for (int j = 0; j < n; ++j) {
      column[j] = body.coupling[j];
      moved[b] -= body.coupling[j] * accelerations[j];
    }
    mechanics::solve_lower_ldlt(mass, n, column);
    for (int other = 0; other <= b; ++other) {
      double shared = 0.0;
      for (int j = 0; j < n; ++j) shared += reduced(j, other) * mass(j, j) * column[j];
      free_mass(other, b) = (other == b ? body.mass : 0.0) - shared;
    }
  }
  mechanics::factorize_ldlt(free_mass, count);
  mechanics::solve_lower_ldlt(free_mass, count, moved);
  mechanics::solve_upper_ldlt(free_mass, count, moved);

  JointVector given_way = JointVector::Zero(n);
  for (int b = 0; b < count; ++b)
    for (int j = 0; j < n; ++j) given_way[j] += reduced(j, b) * moved[b];
  mechanics::solve_upper_ldlt(mass, n, given_way);
  for (int j = 0; j < n; ++j) accelerations[j] -= given_way[j];
}

}  // namespace

// With a0 what the chain would do by itself, M a = M a0 + what holds them: of the others, M a' = M a0' + M' a0 of
// these.
void hold_at_rest(std::span<const int> joints, JointMatrix& mass, JointVector& accelerations) {
  const auto n = static_cast<int>(accelerations.size());
  JointVector carried = JointVector::Zero(n);
  for (const int held : joints) {
    for (int j = 0; j < n; ++j) carried[j] += mass(j, held) * accelerations[held];
    accelerations[held] = 0.0;
  }
  for (const int held : joints) {
    const double own = mass(held, held);
    mass.row(held).setZero();
    mass.col(held).setZero();
    mass(held, held) = own;
    carried[held] = 0.0;
  }
  JointMatrix factors = mass;
  mechanics::factorize_ldlt(factors, n);
  mechanics::solve_lower_ldlt(factors, n, carried);
  mechanics::solve_upper_ldlt(factors, n, carried);
  accelerations += carried;
}

void move_with_chain(JointMatrix mass, std::span<const EffectTerm::Body> bodies, JointVector& accelerations,
                     std::span<double> moved) {
  // The paper's finger has two joints, and on it a mount, two loose magnets or both.
  if (accelerations.size() == 2 && bodies.size() == 1) return move<2, 1>(mass, bodies, accelerations, moved.data());
  if (accelerations.size() == 2 && bodies.size() == 2) return move<2, 2>(mass, bodies, accelerations, moved.data());
  if (accelerations.size() == 2 && bodies.size() == 3) return move<2, 3>(mass, bodies, accelerations, moved.data());
  move<any_count, any_count>(mass, bodies, accelerations, moved.data());
}

}  // namespace coilwright::actuator
