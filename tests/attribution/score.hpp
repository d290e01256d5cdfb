#pragma once

#include <optional>
#include <string>
#include <vector>

#include "attribution/plan.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "truth/data_set.hpp"

namespace attribution {

/// How many of how many.
struct Count {
  int hits{};
  int of{};

  void add(bool hit) {
    hits += hit ? 1 : 0;
    ++of;
  }
  Count& operator+=(const Count& other) {
    hits += other.hits;
    of += other.of;
    return *this;
  }
};

/// A diagnosis beside the answer.
struct Outcome {
  int number{};
  Category category{};
  truth::Answer answer;
  coilwright::measurement::Verdict verdict{};
  std::vector<std::string> reported{};                ///< ids, in the order in which they were added
  std::vector<std::vector<std::string>> ambiguous{};  ///< sets that the diagnosis could not tell apart
  /// One hidden effect: it is the first reported, or in an ambiguity set with the first. Two: each is reported, or in
  /// an ambiguity set with one that is.
  bool found = false;
  /// What is hidden, and nothing else, is reported, and no ambiguity set is.
  bool alone = false;
  /// The data tell every hidden effect from any other single one, by the truth's own reckoning.
  bool determined = false;
  std::optional<double> error_over_floor{};  ///< rmse on the validate runs over the true noise, worst quantity
  Count effect_intervals{};       ///< true values inside 95 % intervals, where exactly what is hidden is reported
  Count calibration_intervals{};  ///< the same for stiffness and damping
};

[[nodiscard]] Outcome score(const Case& asked, const truth::Answer& answer,
                            const coilwright::measurement::Diagnosis& diagnosis);

}  // namespace attribution
