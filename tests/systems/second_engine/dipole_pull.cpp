#include "systems/second_engine/dipole_pull.hpp"

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstddef>

namespace second_engine {

double dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

DipolePull dipole_pull(const Vector& first, const Vector& second, const Vector& r) {
  constexpr double mu0_over_4pi = 1e-7;
  const double distance = mju_norm3(r.data());
  Vector n{};
  for (std::size_t i = 0; i < 3; ++i) n[i] = r[i] / distance;
  const double a = dot(first.data(), n.data());
  const double b = dot(second.data(), n.data());
  const double ab = dot(first.data(), second.data());
  const double strength = 3.0 * mu0_over_4pi / std::pow(distance, 4);
  DipolePull out{};
  Vector field{};
  for (std::size_t i = 0; i < 3; ++i) {
    out.force[i] = strength * (a * second[i] + b * first[i] + (ab - 5.0 * a * b) * n[i]);
    field[i] = mu0_over_4pi * (3.0 * a * n[i] - first[i]) / std::pow(distance, 3);
  }
  mju_cross(out.torque_on_second.data(), second.data(), field.data());
  // Nothing outside holds the two: their couples and that of their forces cancel.
  Vector couple{};
  mju_cross(couple.data(), r.data(), out.force.data());
  for (std::size_t i = 0; i < 3; ++i) out.torque_on_first[i] = -out.torque_on_second[i] - couple[i];
  return out;
}

}  // namespace second_engine
