#pragma once

#include <optional>
#include <span>

#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// A hypothesis to be fitted, and from where.
struct Trial {
  fit::Hypothesis hypothesis;
  Eigen::VectorXd start{};
  const fit::Fit* starts_from{};  ///< of the windows; null: from the measurement
};
[[nodiscard]] fit::FitRequest asking(std::span<const replay::Record> records, const Trial& trial);
/// Nothing where the model cannot be simulated.
[[nodiscard]] std::optional<Scored> fitted_to_end(std::span<const replay::Record> records, const Trial& trial);

/// `base` at its fit with some effects more, each as strong as given. Refers to `base`.
[[nodiscard]] Trial with(const Scored& base, std::span<const actuator::Effect> added);

/// The best of a few iterations from each of several starts of one more effect.
struct Glance {
  Trial trial;  ///< where it began
  fit::Fit fitted{};
};
/// Nothing where none of them can be simulated. Refers to `base`.
[[nodiscard]] std::optional<Glance> glance_at(std::span<const replay::Record> records, const Scored& base,
                                              std::span<const actuator::Effect> starts);
/// A glance followed to the end of its fit.
[[nodiscard]] std::optional<Scored> followed_to_end(std::span<const replay::Record> records, const Glance& glance);

}  // namespace coilwright::measurement::compare
