#include "found_designs.hpp"

#include <optional>
#include <stdexcept>
#include <variant>

#include "coilwright/formats/actuator/actuator_json.hpp"

namespace coilwright::cli {

sizing::DesignResult evaluated_again(const sizing::DesignProblem& problem, std::span<const double> point,
                                     const sizing::Evaluation& found) {
  sizing::DesignResult result = problem.evaluate(point);
  if (problem.assess(result) != found)
    throw std::logic_error("a design that the search found gives other numbers when it is evaluated again");
  return result;
}

std::string design_text(const sizing::DesignProblem& problem, std::span<const double> point,
                        const sizing::DesignResult& result, const std::string& name) {
  std::optional<simulation::OperatingPoint> operating;
  if (const auto* evaluated = std::get_if<sizing::EvaluatedDesign>(&result)) operating = evaluated->point;
  return formats::to_json(problem.design_at(point), name, operating).text();
}

}  // namespace coilwright::cli
