#pragma once

#include <string>

#include "coilwright/measurement/planning/experiment_plan.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// What an experiment could show, with the files that it was planned for.
struct PlanReport {
  const measurement::planning::ExperimentPlan& plan;
  std::string experiment{};  ///< file, as it was given
  std::string actuator{};
};

/// The plan as JSON; its keys are in docs/how_to/plan_experiment.md.
[[nodiscard]] text::Json to_json(const PlanReport& report);

}  // namespace coilwright::formats
