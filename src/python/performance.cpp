#include "python/performance.hpp"

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/report/simulation/correction_text.hpp"
#include "coilwright/report/simulation/part_limits_text.hpp"
#include "coilwright/report/simulation/performance_text.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/correction_reach.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/simulation/pressed_joints.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/one_line.hpp"
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
  const simulation::DesignView design = performance.evaluated()->view();
  return out.set("part_limits", formats::to_json(simulation::told_part_limits(design)));
}

report::Document document_of(const Performance& performance) {
  if (const auto* lumped = performance.lumped())
    return {.sections = {report::quantities_section(lumped->motion, lumped->current)}};
  return report::document_of(performance.evaluated()->view(), {});
}

// What the program says of it beside its numbers. Of a limit that is broken without the numbers, so that a loop over
// currents is told once and not at each of them.
std::vector<std::string> remarks_on(const Performance& performance, const Actuator& actuator) {
  std::vector<std::string> out;
  const auto say = [&](std::string_view sentence) { out.push_back(fmt::format("{}: {}", actuator.origin, sentence)); };
  if (const auto* lumped = performance.lumped()) {
    const auto& model = std::get<actuator::Model>(actuator.content.content);
    const std::string text =
        simulation::pressed_joints_text(simulation::pressed_joints(model, lumped->motion.rest_angles),
                                        simulation::pressed_joints(model, lumped->motion.steady_angles));
    if (!text.empty()) say(text);
    return out;
  }
  const simulation::EvaluatedDesign& design = *performance.evaluated();
  for (const simulation::PartLimit& limit : simulation::broken_part_limits(design.view()))
    if (!limit.conditional) say(fmt::format("breaks the limit of {}: {}", limit.quantity, limit.consequence));
  for (const std::string& doubt : report::doubts_of(design.design)) say(text::lines_of(doubt).front());
  const std::vector<simulation::CorrectionReach> reach =
      simulation::correction_reach(design.assembly.model, design.performance.cold, design.point.current);
  if (std::ranges::any_of(reach, &simulation::CorrectionReach::is_beyond)) say(report::to_text(reach));
  return out;
}

std::vector<simulation::ChoiceEffect> choices_of(const Performance& performance) {
  const py::gil_scoped_release others_run;
  if (performance.lumped() != nullptr) return {};
  return simulation::choice_effects(performance.evaluated()->view());
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
      .def_property_readonly("text", [](const Performance& self) { return report::to_text(document_of(self)); })
      .def_property_readonly("html", [](const Performance& self) { return report::to_html(document_of(self)); });
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
    Performance performance = evaluate(actuator, words);
    return py::make_tuple(performance, remarks_on(performance, actuator));
  });
}

}  // namespace coilwright::python
