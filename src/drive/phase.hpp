#pragma once

#include "coilwright/drive/coil_bank.hpp"
#include "coilwright/drive/driver.hpp"

namespace coilwright::drive {

/// The current along one path: i(t) = goal + (i(0) - goal) exp(-t / time_constant).
struct Phase {
  Phase(const Circuit& circuit, const Path& path);

  double goal;           ///< A
  double time_constant;  ///< s

  /// After `time` (s) without regard to its sign, A.
  [[nodiscard]] double current(double start, double time) const;
  /// Until it comes from `start` down to zero, s; infinite if never.
  [[nodiscard]] double time_to_zero(double start) const;
  /// Until it comes from `start` up to `level`, s; 0 where it is there already, infinite if never.
  [[nodiscard]] double time_to_reach(double start, double level) const;
  /// Integrals of the current (A s) and of its square (A^2 s) over `time`.
  [[nodiscard]] double charge(double start, double time) const;
  [[nodiscard]] double square(double start, double time) const;
};

}  // namespace coilwright::drive
