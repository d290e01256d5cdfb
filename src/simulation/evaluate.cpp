#include "coilwright/simulation/evaluate.hpp"

#include <stdexcept>
#include <utility>
#include <variant>

namespace coilwright::simulation {

EvaluatedDesign evaluate(actuator::Design design, const OperatingPoint& point) {
  actuator::Assembly assembly = actuator::assemble_or_throw(design);
  std::variant<Performance, NoPerformance> performance = performance_of(design, assembly, point);
  if (const auto* none = std::get_if<NoPerformance>(&performance)) throw std::runtime_error(none->reason);
  return {.design = std::move(design),
          .assembly = std::move(assembly),
          .point = point,
          .performance = std::get<Performance>(std::move(performance))};
}

}  // namespace coilwright::simulation
