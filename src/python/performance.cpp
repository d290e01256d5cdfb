#include "python/performance.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/report/simulation/performance_text.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/text/input_error.hpp"
#include "python/actuator.hpp"
#include "python/bindings.hpp"
#include "python/json_objects.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;
using formats::OperatingWords;
using simulation::OperatingPoint;

Performance evaluate_design(const Actuator& actuator, const actuator::Design& design, const OperatingPoint& point) {
  try {
    return Performance(simulation::evaluate(design, point));
  } catch (const std::invalid_argument& mistake) {
    throw text::InputError({.file = actuator.origin, .rule = mistake.what()});
  } catch (const std::runtime_error& reason) {
    throw NoPerformanceError(actuator.origin + ": " + reason.what());
  }
}

Performance evaluate_model(const Actuator& actuator, const actuator::Model& model, const OperatingPoint& point) {
  const auto result = simulation::motion_of(model, point.current, point.grasp);
  if (const auto* why = std::get_if<simulation::NoPerformance>(&result))
    throw NoPerformanceError(actuator.origin + ": " + why->reason);
  return Performance(LumpedPerformance{std::get<simulation::MotionSummary>(result), point.current});
}

Performance evaluate(const Actuator& actuator, const OperatingWords& said) {
  const py::gil_scoped_release others_run;
  const OperatingPoint point = formats::operating_point_of(actuator.content, said, actuator.origin, "give a current");
  if (const auto* design = std::get_if<actuator::Design>(&actuator.content.content))
    return evaluate_design(actuator, *design, point);
  return evaluate_model(actuator, std::get<actuator::Model>(actuator.content.content), point);
}

text::Json json_of(const Performance& performance) {
  if (const auto* lumped = performance.lumped()) return formats::to_json(lumped->motion, lumped->current);
  text::Json out = formats::to_json(performance.evaluated()->view());
  out.set("operating_point", formats::to_json(performance.evaluated()->point));
  return out.set("part_limits", formats::to_json(simulation::part_limits(performance.evaluated()->view())));
}

std::string text_of(const Performance& performance) {
  if (const auto* lumped = performance.lumped()) return report::to_text(lumped->motion, lumped->current);
  return report::to_text(performance.evaluated()->view());
}

std::vector<simulation::ChoiceEffect> choices_of(const Performance& performance) {
  const py::gil_scoped_release others_run;
  if (performance.lumped() != nullptr) return {};
  return simulation::choice_effects(performance.evaluated()->design, performance.evaluated()->point);
}

Actuator actuator_in(const Performance& performance) {
  const simulation::EvaluatedDesign* design = performance.evaluated();
  if (design == nullptr) throw std::logic_error("a lumped model is kept by who evaluated it");
  return actuator_of(design->design, "design", design->point);
}

py::list quantities() {
  py::list out;
  for (const simulation::ResultQuantity& each : simulation::standard_quantities())
    out.append(py::make_tuple(each.name, each.meaning, each.absence));
  return out;
}

}  // namespace

std::optional<double> Performance::value(const std::string& name) const {
  const simulation::ResultQuantity& quantity = simulation::standard_quantities().at(name);
  if (const auto* design = evaluated()) return quantity.value(design->view());
  if (!quantity.value_of_lumped) return std::nullopt;
  return quantity.value_of_lumped(lumped()->motion, lumped()->current);
}

const simulation::EvaluatedDesign* Performance::evaluated() const {
  const auto* design = std::get_if<0>(&content_);
  return design == nullptr ? nullptr : design->get();
}

void bind_performance(py::module_& module) {
  py::class_<Performance>(module, "Performance")
      .def("value", &Performance::value, py::arg("name"))
      .def("actuator", &actuator_in)
      .def("to_dict", [](const Performance& self) { return to_python(json_of(self)); })
      .def("choices", [](const Performance& self) { return to_python(formats::to_json(choices_of(self))); })
      .def_property_readonly("text", &text_of);
  module.def("quantities", &quantities);
  module.def("evaluate", [](const Actuator& actuator, std::optional<bool> in_series, const py::kwargs& said) {
    const auto number = [&](const char* name) { return said[name].cast<std::optional<double>>(); };
    OperatingWords words{.current = number("current"),
                         .duty = number("duty"),
                         .grasp_opening = number("grasp_opening_deg"),
                         .grasp_height = number("grasp_height_mm"),
                         .supply_resistance = number("supply_resistance"),
                         .supply_voltage = number("supply_voltage")};
    if (in_series) words.wiring = *in_series ? actuator::Wiring::series : actuator::Wiring::parallel;
    return evaluate(actuator, words);
  });
}

}  // namespace coilwright::python
