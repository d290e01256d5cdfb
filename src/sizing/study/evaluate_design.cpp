#include "sizing/study/evaluate_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <string>
#include <utility>

namespace coilwright::sizing {
namespace {

NotEvaluated not_buildable(const actuator::ConstructionFaults& faults) {
  double excess = 0.0;
  for (const actuator::ConstructionFault& fault : faults) excess += fault.excess;
  return {.reason = faults.front().rule, .infeasibility = 1.0 + excess};
}

DesignResult evaluate_buildable(actuator::Design design, simulation::Settings settings,
                                const OperatingPointOf& operating_point, const std::optional<StudyDriver>& driver) {
  std::variant<actuator::Assembly, actuator::ConstructionFaults> assembled = actuator::assemble(design);
  if (const auto* faults = std::get_if<actuator::ConstructionFaults>(&assembled)) return not_buildable(*faults);
  actuator::Assembly assembly = std::get<actuator::Assembly>(std::move(assembled));
  const actuator::OperatingPoint operating = operating_point(design, assembly, settings);
  std::variant<simulation::Performance, simulation::NoPerformance> performance =
      simulation::performance_of(design, assembly, operating);
  if (const auto* none = std::get_if<simulation::NoPerformance>(&performance))
    return NotEvaluated{.reason = none->reason, .infeasibility = 1.0};
  EvaluatedDesign out{.design = std::move(design),
                      .assembly = std::move(assembly),
                      .point = operating,
                      .performance = std::get<simulation::Performance>(std::move(performance)),
                      .settings = std::move(settings)};
  if (driver && !driver->duty.value(out.view())) {
    simulation::NoValue why = driver->duty.why_absent(out.view());
    return NotEvaluated{.reason = std::move(why.reason), .infeasibility = why.infeasibility};
  }
  return out;
}

}  // namespace

DesignResult evaluate_design(actuator::Design design, simulation::Settings settings,
                             const OperatingPointOf& operating_point, const std::optional<StudyDriver>& driver) {
  try {
    return evaluate_buildable(std::move(design), std::move(settings), operating_point, driver);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    return NotEvaluated{.reason = failure.what(), .infeasibility = 1.0};
  }
}

NotEvaluated without_value(const simulation::ResultQuantity& quantity, const simulation::DesignView& design) {
  if (quantity.why_absent) {
    const simulation::NoValue why = quantity.why_absent(design);
    return {.reason = fmt::format("{} has no value: {}", quantity.name, why.reason),
            .infeasibility = why.infeasibility};
  }
  const std::string why = quantity.absence.empty() ? "it is not finite" : quantity.absence;
  std::string reason = fmt::format("{} has no value: {}", quantity.name, why);
  const simulation::Heat& free = design.performance.free.heat;
  const simulation::Heat& gripping = design.performance.gripping.heat;
  if (free.coil_temperature && gripping.coil_temperature) return {.reason = std::move(reason), .infeasibility = 1.0};
  const double rms = std::abs(design.point.current) * std::sqrt(design.point.duty);
  return {.reason = std::move(reason), .infeasibility = rms / std::min(free.runaway_current, gripping.runaway_current)};
}

}  // namespace coilwright::sizing
