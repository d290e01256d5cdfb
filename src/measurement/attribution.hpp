#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/diagnosis.hpp"
#include "fit.hpp"

namespace coilwright::measurement {

/// A hypothesis and how well it does.
struct Scored {
  Hypothesis hypothesis;
  Fit fit{};
  Adequacy adequacy{};
};

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
  std::span<const Record> records{};
  const DeclaredModel* declared{};
  std::uint64_t seed = 1;  ///< of the starts that are drawn beside those that effects propose
  std::function<void(const std::string&)> progress{};
};
/// Throws std::runtime_error where the declared model cannot be simulated.
[[nodiscard]] Attribution attribute(const AttributionRequest& request);

/// By how much hypothesis `b` predicts runs that it was not fitted to better than `a`: each fit run is left out in turn
/// (one Gauss-Newton step from the fit to all), and the share of the squared residual above the noise that b removes is
/// taken. NaN for a single run.
[[nodiscard]] double cross_validated_gain(std::span<const Record> records, const DeclaredModel& declared,
                                          const Scored& a, const Scored& b);

/// Chi^2 that counts as one independent piece of evidence: 1 where the residual is white noise of the known level, more
/// where it is larger or correlated.
[[nodiscard]] double unit_of_evidence(std::span<const Record> records, const Scored& reference);

}  // namespace coilwright::measurement
