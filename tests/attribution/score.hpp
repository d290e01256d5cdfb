#pragma once

#include <optional>
#include <string>
#include <vector>

#include "attribution/count.hpp"
#include "attribution/plan.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "truth/data_set.hpp"

namespace attribution {

/// A diagnosis compared with the answer.
struct Outcome {
  int number{};
  Category category{};
  truth::Answer answer;
  coilwright::measurement::Verdict verdict{};
  std::vector<std::string> reported{};                ///< ids, in the order in which they were added
  std::vector<std::vector<std::string>> ambiguous{};  ///< sets of effects that the diagnosis could not distinguish
  /// With one hidden effect: whether it is reported first, or is in an ambiguity set with the first. With two: whether
  /// each is reported, or is in an ambiguity set with one that is.
  bool found = false;
  /// Whether exactly the hidden effects are reported, without ambiguity sets.
  bool alone = false;
  /// Whether the data distinguish every hidden effect from any other single one, according to the simulation.
  bool determined = false;
  std::optional<double>
      error_over_floor{};         ///< rmse on the validate runs over the true noise, of the worst kind of channel
  Count effect_intervals{};       ///< true values inside 95 % intervals, if exactly the hidden effects are reported
  Count calibration_intervals{};  ///< the same for stiffness and damping
};

[[nodiscard]] Outcome score(const Case& asked, const truth::Answer& answer,
                            const coilwright::measurement::Diagnosis& diagnosis);

}  // namespace attribution
