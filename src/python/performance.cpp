#include "python/performance.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/formats/simulation/performance_json.hpp"
#include "coilwright/report/simulation/performance_text.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/simulation/part_limits.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/units/unit.hpp"
#include "python/actuator.hpp"
#include "python/bindings.hpp"
#include "python/json_objects.hpp"
#include "python/no_performance.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;
using simulation::OperatingPoint;

// What a caller says of the operating point; the rest is that of the actuator's file.
struct Asked {
  std::optional<double> current, duty, grasp_opening_deg, grasp_height_mm, supply_resistance, supply_voltage;
  std::optional<bool> in_series;
};

actuator::GraspPoint grasp_of(actuator::GraspPoint grasp, const Asked& asked) {
  if (asked.grasp_opening_deg) grasp.opening = units::to_memory(*asked.grasp_opening_deg, "grasp_opening_deg");
  if (asked.grasp_height_mm) grasp.height = units::to_memory(*asked.grasp_height_mm, "grasp_height_mm");
  return grasp;
}

text::InputError fault(const Actuator& actuator, std::string rule) {
  return text::InputError({.file = actuator.origin, .rule = std::move(rule)});
}

OperatingPoint point_of(const Actuator& actuator, const Asked& asked) {
  OperatingPoint point = actuator.content.operating_point.value_or(OperatingPoint{});
  if (!asked.current && !actuator.content.operating_point)
    throw fault(actuator, "has no operating_point: give a current");
  point.current = asked.current.value_or(point.current);
  point.duty = asked.duty.value_or(point.duty);
  point.grasp = grasp_of(point.grasp, asked);
  if (asked.in_series) point.supply.wiring = *asked.in_series ? actuator::Wiring::series : actuator::Wiring::parallel;
  point.supply.resistance = asked.supply_resistance.value_or(point.supply.resistance);
  if (asked.supply_voltage) point.supply.voltage = asked.supply_voltage;
  return point;
}

Performance evaluate_design(const Actuator& actuator, const actuator::Design& design, const Asked& asked) {
  const OperatingPoint point = point_of(actuator, asked);
  if (point.supply.wiring == actuator::Wiring::series && !has_one_current(design))
    throw fault(actuator,
                "must be wired in parallel: the coils have shares of the current, and in series there is one");
  try {
    return Performance(simulation::evaluate(design, point));
  } catch (const std::invalid_argument& mistake) {
    throw fault(actuator, mistake.what());
  } catch (const std::runtime_error& reason) {
    throw NoPerformanceError(actuator.origin + ": " + reason.what());
  }
}

Performance evaluate_model(const Actuator& actuator, const actuator::Model& model, const Asked& asked) {
  if (!asked.current) throw fault(actuator, "has no operating_point: give a current");
  const auto result = simulation::motion_of(model, *asked.current, grasp_of({}, asked));
  if (const auto* why = std::get_if<simulation::NoPerformance>(&result))
    throw NoPerformanceError(actuator.origin + ": " + why->reason);
  return Performance(LumpedPerformance{std::get<simulation::MotionSummary>(result), *asked.current});
}

Performance evaluate(const Actuator& actuator, const Asked& asked) {
  const py::gil_scoped_release others_run;
  if (const auto* design = std::get_if<actuator::Design>(&actuator.content.content))
    return evaluate_design(actuator, *design, asked);
  return evaluate_model(actuator, std::get<actuator::Model>(actuator.content.content), asked);
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
  module.def(
      "evaluate",
      [](const Actuator& actuator, std::optional<double> current, std::optional<double> duty,
         std::optional<double> grasp_opening_deg, std::optional<double> grasp_height_mm, std::optional<bool> in_series,
         std::optional<double> supply_resistance, std::optional<double> supply_voltage) {
        return evaluate(actuator, {.current = current,
                                   .duty = duty,
                                   .grasp_opening_deg = grasp_opening_deg,
                                   .grasp_height_mm = grasp_height_mm,
                                   .supply_resistance = supply_resistance,
                                   .supply_voltage = supply_voltage,
                                   .in_series = in_series});
      },
      py::arg("actuator"), py::arg("current"), py::arg("duty"), py::arg("grasp_opening_deg"),
      py::arg("grasp_height_mm"), py::arg("in_series"), py::arg("supply_resistance"), py::arg("supply_voltage"));
}

}  // namespace coilwright::python
