#include "coilwright/simulation/choice_effects.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <utility>

#include "coilwright/simulation/part_limits.hpp"

namespace coilwright::simulation {
namespace {

// As of the builds of a spread: figures move by up to 5e-6 of themselves, at less than half the cost.
constexpr double curve_tolerance_of_effects = 1e-4;

std::variant<EvaluatedDesign, NoPerformance> evaluated(actuator::Design design, const OperatingPoint& point) {
  try {
    return evaluate(std::move(design), point);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& reason) {
    return NoPerformance{reason.what()};
  }
}

double change_of(std::string_view name, const DesignView& taken, const DesignView& other) {
  const ResultQuantity& quantity = standard_quantities().at(name);
  const std::optional<double> value = quantity.value(other);
  const std::optional<double> reference = quantity.value(taken);
  if (value == reference) return 0.0;
  if (!value || !reference) return 1.0;
  return std::abs(*value - *reference) / std::max(std::abs(*reference), 1e-3 * quantity.scale);
}

std::vector<PartLimit> broken_limits(const DesignView& design) {
  std::vector<PartLimit> out = part_limits(design);
  std::erase_if(out, [](const PartLimit& each) { return each.conditional || !each.is_broken(); });
  return out;
}

ChoiceEffect effect_of(actuator::OtherChoice choice, const DesignView& taken, const std::vector<PartLimit>& broken) {
  actuator::Design design = choice.design;
  if (!choice.number.empty()) design.curve_tolerance = curve_tolerance_of_effects;
  ChoiceEffect out{.choice = std::move(choice), .result = evaluated(std::move(design), taken.point)};
  const auto* other = std::get_if<EvaluatedDesign>(&out.result);
  if (other == nullptr) {
    out.breaks = true;
    return out;
  }
  for (const std::string_view name : main_figures)
    out.change = std::max(out.change, change_of(name, taken, other->view()));
  out.breaks = std::ranges::any_of(broken_limits(other->view()), [&](const PartLimit& each) {
    return std::ranges::find(broken, each.quantity, &PartLimit::quantity) == broken.end();
  });
  return out;
}

}  // namespace

std::vector<ChoiceEffect> choice_effects(const DesignView& taken) {
  const std::vector<PartLimit> broken = broken_limits(taken);
  std::vector<ChoiceEffect> out;
  for (auto* others : {&actuator::other_choices, &actuator::other_numbers})
    for (actuator::OtherChoice& choice : others(taken.design))
      out.push_back(effect_of(std::move(choice), taken, broken));
  using Weight = std::pair<bool, double>;
  std::map<std::string_view, Weight> weights;
  for (const ChoiceEffect& each : out) {
    Weight& weight = weights[each.choice.subject];
    weight = std::max(weight, Weight(each.breaks, each.change));
  }
  std::ranges::stable_sort(out, std::greater(),
                           [&](const ChoiceEffect& each) { return weights.at(each.choice.subject); });
  return out;
}

}  // namespace coilwright::simulation
