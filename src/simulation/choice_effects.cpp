#include "coilwright/simulation/choice_effects.hpp"

#include <new>
#include <utility>

namespace coilwright::simulation {
namespace {

std::variant<EvaluatedDesign, NoPerformance> evaluated(const actuator::Design& design, const OperatingPoint& point) {
  try {
    return evaluate(design, point);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& reason) {
    return NoPerformance{reason.what()};
  }
}

}  // namespace

std::vector<ChoiceEffect> choice_effects(const actuator::Design& design, const OperatingPoint& point) {
  std::vector<ChoiceEffect> out;
  for (actuator::OtherChoice& choice : actuator::other_choices(design)) {
    std::variant<EvaluatedDesign, NoPerformance> result = evaluated(choice.design, point);
    out.push_back({.choice = std::move(choice), .result = std::move(result)});
  }
  return out;
}

}  // namespace coilwright::simulation
