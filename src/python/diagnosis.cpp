#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <sstream>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/actuator/actuator_argument.hpp"
#include "coilwright/formats/data/diagnosis_tables.hpp"
#include "coilwright/formats/data/experiment_file.hpp"
#include "coilwright/formats/data/plan_json.hpp"
#include "coilwright/measurement/planning/experiment_plan.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "coilwright/report/diagnosis/plan_text.hpp"
#include "coilwright/results/diagnosis/asked_diagnosis.hpp"
#include "coilwright/results/diagnosis/diagnosis_files.hpp"
#include "coilwright/results/page/page_file.hpp"
#include "coilwright/text/output/file_name.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "python/actuator.hpp"
#include "python/bindings.hpp"
#include "python/held_function.hpp"
#include "python/interruptible.hpp"
#include "python/json_objects.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;
using measurement::planning::Experiment;

// A diagnosis with all that it is of.
struct Diagnosed {
  results::AskedDiagnosis asked;
  measurement::Diagnosis diagnosis;
  results::DiagnosisAnswer answer;

  [[nodiscard]] std::string residuals() const {
    std::ostringstream out;
    formats::write_residuals(out, diagnosis.replays);
    return out.str();
  }
  void write(const std::string& out) const {
    const py::gil_scoped_release others_run;
    text::OutputFolder folder(out);
    results::write_diagnosis(diagnosis, asked, answer, folder);
  }
};

struct Interrupted {};

// A diagnosis knows nothing of a stop; it is ended from what it calls.
measurement::DiagnosisOptions options_with(const std::stop_token& stop, int threads, bool as_written,
                                           const std::shared_ptr<py::function>& progress) {
  return {.threads = threads,
          .as_written = as_written,
          .progress =
              [stop, progress](const std::string& line) {
                if (stop.stop_requested()) throw Interrupted{};
                const py::gil_scoped_acquire lock;
                if (progress) (*progress)(line);
              },
          .known =
              [stop](const measurement::Diagnosis&) {
                if (stop.stop_requested()) throw Interrupted{};
              }};
}

std::shared_ptr<Diagnosed> diagnose(const std::string& dataset, const std::optional<std::string>& actuator,
                                    std::uint64_t seed, int threads, bool as_written,
                                    const actuator::EffectCatalogue& effects, const py::object& progress) {
  const auto told = progress.is_none() ? nullptr : held(progress.cast<py::function>());
  return interruptible([&](const std::stop_token& stop) {
    results::AskedDiagnosis asked = results::read_asked(dataset, actuator, seed, effects);
    measurement::Diagnosis diagnosis = results::diagnose(asked, options_with(stop, threads, as_written, told));
    results::DiagnosisAnswer answer = results::answer_of(diagnosis, asked);
    return std::make_shared<Diagnosed>(std::move(asked), std::move(diagnosis), std::move(answer));
  });
}

void require_no_slip(const std::string& dataset) {
  interruptible([&](const std::stop_token&) {
    results::require_no_slip(results::read_asked(dataset, std::nullopt, 1));
    return true;
  });
}

// An experiment, and what errors call it.
struct Planned {
  Experiment experiment;
  std::string origin;
};

Planned planned(const std::string& text, std::string origin, const std::vector<std::string>& noise) {
  Experiment experiment = formats::parse_experiment(text, origin);
  for (const std::string& each : noise) formats::set_noise(experiment.instruments, each);
  return {.experiment = std::move(experiment), .origin = std::move(origin)};
}

formats::DeclaredActuator rig_of(const Actuator& actuator, const std::vector<std::string>& calibrate,
                                 const measurement::replay::Tolerances& tolerances) {
  return formats::parse_declared_actuator(actuator.text, actuator.origin,
                                          {.names = calibrate, .file = "calibrate", .tolerances = tolerances});
}

// (the plan as JSON, the plan as text)
py::tuple plan(const Planned& planned, const Actuator& actuator, const std::vector<std::string>& calibrate, bool exact,
               std::uint64_t seed, int threads) {
  const formats::DeclaredActuator rig =
      rig_of(actuator, calibrate, exact ? measurement::replay::Tolerances::exact() : measurement::replay::Tolerances{});
  const auto found = interruptible([&](const std::stop_token&) {
    return measurement::planning::plan_experiment(planned.experiment, rig.model, {.threads = threads, .seed = seed});
  });
  const formats::PlanReport report{.plan = found, .experiment = planned.origin, .actuator = actuator.origin};
  return py::make_tuple(to_python(formats::to_json(report)), report::to_text(report));
}

// (dataset.json, the text of each file by its name)
py::tuple twin(const Actuator& actuator, const Planned& planned, const std::vector<std::string>& hidden,
               std::uint64_t seed, const actuator::EffectCatalogue& known) {
  const formats::DeclaredActuator rig = rig_of(actuator, {}, measurement::replay::Tolerances::exact());
  const std::vector<actuator::Effect> effects =
      formats::parse_hidden_effects(hidden, rig.model.build({}), actuator.origin, known);
  const auto runs = interruptible([&](const std::stop_token&) {
    return measurement::planning::simulate_experiment(planned.experiment, rig.model, effects, seed);
  });
  std::vector<formats::RunWithRole> in_roles;
  py::dict files;
  const auto add = [&](const std::string& name, const auto& write) {
    std::ostringstream out;
    write(out);
    files[py::str(name)] = out.str();
  };
  for (std::size_t i = 0; i < runs.size(); ++i) {
    in_roles.push_back({.run = runs[i], .validate = planned.experiment.runs[i].validate});
    add(runs[i].name, [&](std::ostream& out) { formats::write_run(out, runs[i]); });
    if (const auto input = formats::input_file_name(runs[i]))
      add(*input, [&](std::ostream& out) { formats::write_input(out, runs[i]); });
  }
  return py::make_tuple(to_python(formats::dataset_json(planned.experiment.name, "actuator.json", in_roles)), files);
}

void report(const std::string& folder, const std::string& path) {
  const py::gil_scoped_release others_run;
  text::OutputFile file(path);
  file.stream() << results::html_of(results::page_of_folder(folder));
  file.commit();
}

}  // namespace

void bind_diagnosis(py::module_& module) {
  py::class_<Diagnosed, std::shared_ptr<Diagnosed>>(module, "Diagnosed")
      .def_property_readonly("text", [](const Diagnosed& self) { return self.answer.summary; })
      .def_property_readonly("json", [](const Diagnosed& self) { return self.answer.json; })
      .def_property_readonly("actuator", [](const Diagnosed& self) { return self.answer.actuator; })
      .def_property_readonly("next_experiment", [](const Diagnosed& self) { return self.answer.next_experiment; })
      .def("residuals", &Diagnosed::residuals)
      .def("write", &Diagnosed::write, py::arg("folder"));
  py::class_<Planned>(module, "Planned").def(py::init(&planned), py::arg("text"), py::arg("origin"), py::arg("noise"));
  module.def("diagnose", &diagnose, py::arg("dataset"), py::arg("actuator"), py::arg("seed"), py::arg("threads"),
             py::arg("as_written"), py::arg("effects"), py::arg("progress"));
  module.def("require_no_slip", &require_no_slip, py::arg("dataset"));
  module.def("plan", &plan, py::arg("planned"), py::arg("actuator"), py::arg("calibrate"), py::arg("exact"),
             py::arg("seed"), py::arg("threads"));
  module.def("twin", &twin, py::arg("actuator"), py::arg("planned"), py::arg("hidden"), py::arg("seed"),
             py::arg("effects"));
  module.def("fault_of_file_names", [](const std::vector<std::string>& names) {
    const auto fault = text::fault_of_file_names(names);
    return fault ? std::optional(std::pair(fault->index, fault->rule)) : std::nullopt;
  });
  module.def("report", &report, py::arg("folder"), py::arg("file"));
}

}  // namespace coilwright::python
