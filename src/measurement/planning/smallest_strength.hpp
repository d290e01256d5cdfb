#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "measurement/planning/linearised_records.hpp"

namespace coilwright::measurement::planning {

/// What decides whether a change of the residuals is found. Lengths are in units of the noise.
struct DetectionLimit {
  double samples{};
  double overdispersion = 1.0;

  /// The length that a change must have for a decisive gain of the quasi-BIC in 80 % of all noise, where the one
  /// hypothesis has so many numbers more than the other (fewer, if negative).
  [[nodiscard]] double length(Eigen::Index more_numbers) const;
};

/// An effect at its smallest strength that would be found.
struct SmallestStrength {
  actuator::Effect effect{};
  Eigen::VectorXd change{};  ///< LinearisedRecords::change_by at that strength; empty if it cannot be simulated at all
  double over_limit{};       ///< length of the change beyond the declared numbers, over the limit
  bool visible{};
  std::string remark{};  ///< why it is not visible
};

/// The number of an effect that is its strength: the first whose value says whether it is there. Nothing if none does.
[[nodiscard]] std::optional<std::size_t> main_number(const actuator::EffectKind& kind);

/// Scales the start of the effect that shows best until its change has the length of the limit within 5 %.
[[nodiscard]] SmallestStrength smallest_strength(const LinearisedRecords& records, const actuator::EffectKind& kind,
                                                 const actuator::RigScale& scale, const DetectionLimit& limit);

}  // namespace coilwright::measurement::planning
