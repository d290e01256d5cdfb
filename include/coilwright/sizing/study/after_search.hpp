#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "coilwright/sizing/search/search.hpp"
#include "coilwright/sizing/study/assumption_effects.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/sweep.hpp"
#include "coilwright/sizing/study/yield.hpp"

namespace coilwright::sizing {

/// Evaluates anew the design at a point that an answer recommends. Throws std::logic_error if the result differs from
/// `found`.
[[nodiscard]] DesignResult evaluated_again(const DesignProblem& problem, std::span<const double> point,
                                           const Evaluation& found);

/// Evaluates anew every design of a front or of a sweep's leaders, each of which must break no limit. @{
[[nodiscard]] std::vector<DesignResult> evaluated_again(const DesignProblem& problem, std::span<const Record> designs);
[[nodiscard]] std::vector<DesignResult> evaluated_again(const DesignProblem& problem,
                                                        std::span<const SweptDesign> designs);
///@}

/// Results that are computed after the search for one objective, beside the surroundings of its answer.
struct AfterSearch {
  std::optional<DesignResult> best{};           ///< the design found, evaluated again; absent if nothing was evaluated
  DesignResult base;                            ///< the actuator that the study starts from
  Evaluation base_seen{};                       ///< evaluation of that actuator as the search would see it
  std::optional<Yield> built{};                 ///< builds of a feasible answer to a study with a spread
  std::vector<AssumptionEffect> assumptions{};  ///< of a feasible answer
  std::size_t assumptions_left{};               ///< number of choices and numbers not evaluated
};

/// Options of after_search(). A study whose search has `Afterwards::nothing` has neither builds nor choices.
struct AfterSearchOptions {
  std::size_t builds = 2000;  ///< by fresh dice
  std::stop_token stop{};     ///< ends the work early; missing results are left out
  /// Evaluates a point under another modelling choice, as in AssumptionOptions. May be empty.
  decltype(AssumptionOptions::evaluate) evaluate{};
  ///@{
  /// Told how many builds and modelling choices were looked at, of how many. May be empty.
  std::function<void(std::size_t done, std::size_t of)> builds_done{};
  std::function<void(std::size_t done, std::size_t of)> choices_done{};
  ///@}
  /// Told each design on which the answer rests, by the name of the modelling choice it is under (empty: the study's
  /// own), before anything is made of it: for who keeps evaluations and must not be believed. May be empty.
  std::function<void(const std::string& choice, std::span<const double> point)> stated{};
};

/// Computes all of AfterSearch. Pure except for the clock of a stop. Throws as evaluated_again().
[[nodiscard]] AfterSearch after_search(const DesignProblem& problem, const SearchResult& result,
                                       const AfterSearchOptions& options);

}  // namespace coilwright::sizing
