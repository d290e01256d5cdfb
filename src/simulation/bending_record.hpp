#pragma once

#include <optional>
#include <vector>

#include "stepper.hpp"

namespace coilwright::simulation {

/// The bending angle over one motion, at the ends of the integrator's steps. Between two of them the quintic through
/// both angles, speeds and accelerations stands for the motion; what that is worth is in docs/theory/simulation.md.
class BendingRecord {
 public:
  struct Peak {
    double speed{};  ///< largest |speed|, rad/s
    double time{};   ///< s
  };

  explicit BendingRecord(const Stepper::Bending& start);
  void add(const Stepper::Bending& sample) { samples_.push_back(sample); }
  [[nodiscard]] const Stepper::Bending& last() const { return samples_.back(); }

  [[nodiscard]] Peak fastest() const;
  /// Farthest that the motion goes beyond `end` on the side away from its start, rad; >= 0.
  [[nodiscard]] double beyond(double end) const;
  /// Largest angle, the start's included, rad; signed.
  [[nodiscard]] double largest() const;
  /// First time at which the angle is at `level`, s.
  [[nodiscard]] std::optional<double> first_passage(double level) const;
  /// Last time at which the angle is more than `band` from `end`, s; 0 if it never is.
  [[nodiscard]] double last_outside(double end, double band) const;

 private:
  std::vector<Stepper::Bending> samples_;
};

}  // namespace coilwright::simulation
