#include "design_text.hpp"

#include <optional>
#include <variant>

#include "coilwright/formats/actuator/actuator_json.hpp"

namespace coilwright::cli {

std::string design_text(const sizing::DesignProblem& problem, std::span<const double> point, const std::string& name) {
  const sizing::DesignResult result = problem.evaluate(point);
  std::optional<simulation::OperatingPoint> operating;
  if (const auto* evaluated = std::get_if<sizing::EvaluatedDesign>(&result)) operating = evaluated->point;
  return formats::to_json(problem.design_at(point), name, operating).text();
}

}  // namespace coilwright::cli
