#pragma once

#include <string>

#include "coilwright/measurement/planning/experiment_plan.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The answer of `plan`, with the files for which it was made.
struct PlanReport {
  const measurement::planning::ExperimentPlan& plan;
  std::string experiment{};  ///< file, as it was given
  std::string actuator{};
};

/// The plan as JSON; its keys are in docs/how_to/plan_experiment.md.
[[nodiscard]] text::Json to_json(const PlanReport& report);

}  // namespace coilwright::formats
