#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/effect_catalogue.hpp"
#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {

/// What the comparison of all hypotheses came to.
struct Attribution {
  std::vector<Scored> steps{};   ///< the declared model recalibrated, then with one effect more at each step
  std::vector<Scored> rivals{};  ///< other hypotheses that these data cannot tell from the last step
  /// One set per effect of the last step that has rivals: the effect first.
  std::vector<std::vector<const actuator::EffectKind*>> indistinguishable{};
  std::vector<Candidate> candidates{};  ///< all that were compared, best first
  double unit{1.0};                     ///< chi^2 per independent sample of the last step's residual: 1 for noise
  [[nodiscard]] const Scored& before() const { return steps.front(); }
  [[nodiscard]] const Scored& after() const { return steps.back(); }
};

/// Compares the declared model with every effect, then pairs and triples where a rest remains, all recalibrated.
struct AttributionRequest {
  std::span<const replay::Record> records{};
  const replay::DeclaredModel* declared{};
  std::uint64_t seed = 1;  ///< of the starts that are drawn beside those that effects propose
  std::function<void(const std::string&)> progress{};
  actuator::EffectCatalogue effects = actuator::standard_effects();  ///< that the declared model may lack
};
/// Throws std::runtime_error where the declared model cannot be simulated.
[[nodiscard]] Attribution attribute(const AttributionRequest& request);

}  // namespace coilwright::measurement::compare
