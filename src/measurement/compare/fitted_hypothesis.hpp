#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/compare/evidence.hpp"
#include "coilwright/measurement/whiteness/whiteness_test.hpp"
#include "measurement/fit/fit.hpp"

namespace coilwright::measurement::compare {

/// A hypothesis and how well it does on the fit runs.
struct Scored {
  fit::Hypothesis hypothesis;
  fit::Fit fit{};
  whiteness::Adequacy adequacy{};

  /// Chi^2 above what noise alone gives.
  [[nodiscard]] double excess() const;
  [[nodiscard]] std::vector<const actuator::EffectKind*> kinds() const;
};
[[nodiscard]] Scored scored(std::span<const replay::Record> records, fit::Hypothesis hypothesis, fit::Fit fitted);

/// Chi^2 that counts as one independent piece of evidence: 1 where the residual is white noise of the known level, more
/// where it is larger or correlated.
[[nodiscard]] double unit_of_evidence(std::span<const replay::Record> records, const Scored& reference);

/// What speaks against a hypothesis, in pieces of evidence: misfit, and a charge for every number (Schwarz 1978, with
/// the number of independent samples).
[[nodiscard]] double criterion(const Scored& s, double unit);

/// What `with` explains beyond `without`. Its cross-validated gain is left NaN: see cross_validation.hpp.
[[nodiscard]] Evidence evidence(std::span<const replay::Record> records, const Scored& without, const Scored& with,
                                double unit);

}  // namespace coilwright::measurement::compare
