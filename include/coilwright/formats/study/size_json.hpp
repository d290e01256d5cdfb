#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "coilwright/sizing/search/search.hpp"
#include "coilwright/sizing/study/assumption_effects.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// Number of builds by fresh dice with which `size` ends a study with a spread.
inline constexpr std::size_t builds_of_answer = 2000;

/// The results of `size` that are to be written. Everything referred to must outlive it.
struct SizeReport {
  const sizing::Study& study;           ///< with the options that were used
  const sizing::SearchResult& result;   ///< of the search
  const sizing::DesignResult* best{};   ///< `result.best` evaluated again; nullptr if nothing was evaluated
  const sizing::DesignResult& base;     ///< the actuator that the study starts from
  const sizing::Evaluation& base_seen;  ///< evaluation of that actuator as the search would see it
  std::vector<sizing::AssumptionEffect> assumptions{};  ///< of a feasible answer; empty if none was looked at
  std::size_t
      assumptions_left{};  ///< number of other choices not evaluated: the run was interrupted, or did not ask for them
  std::optional<sizing::Yield> built{};  ///< builds of a feasible answer to a study with a spread, unless left out
};

/// Number of designs evaluated under other modelling choices, beyond those of the search and around its answer.
[[nodiscard]] std::size_t evaluations_of_choices(const SizeReport& report);

/// The limit or variable of a study that a result names; it must be there.
[[nodiscard]] const sizing::Limit& limit_named(const sizing::Study& study, std::string_view name);
[[nodiscard]] const sizing::StudyVariable& variable_named(const sizing::Study& study, std::string_view name);

/// A binding limit as the search relaxed it.
[[nodiscard]] sizing::Limit relaxed(const sizing::Limit& limit, const sizing::BindingConstraint& binding);

/// A variable whose best value is an end of its range, so that the search could not go further.
struct RangeEnd {
  std::size_t variable;  ///< index in the study
  std::string_view end;  ///< "lower" or "upper"
};
[[nodiscard]] std::vector<RangeEnd> range_ends(const SizeReport& report);

/// result.json of `size`; its keys are in docs/formats-results.md.
[[nodiscard]] text::Json to_json(const SizeReport& report);

/// The output of `yield --json`; its keys are in docs/formats-results.md.
[[nodiscard]] text::Json to_json(const sizing::Yield& yield);

}  // namespace coilwright::formats
