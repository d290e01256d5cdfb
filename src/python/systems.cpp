#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/current_limit.hpp"
#include "coilwright/control/reach.hpp"
#include "coilwright/formats/simulation/linear_model_json.hpp"
#include "coilwright/formats/simulation/reach_json.hpp"
#include "coilwright/formats/study/size_json.hpp"
#include "coilwright/formats/study/study_of_one.hpp"
#include "coilwright/formats/systems/crawl_json.hpp"
#include "coilwright/formats/systems/drive_json.hpp"
#include "coilwright/formats/systems/grip_json.hpp"
#include "coilwright/formats/systems/task_rows.hpp"
#include "coilwright/report/yield_text.hpp"
#include "coilwright/simulation/linear_model.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/yield.hpp"
#include "coilwright/systems/crawl.hpp"
#include "coilwright/systems/crawl_heat.hpp"
#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/gripper/grip_task.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/units/unit.hpp"
#include "python/actuator.hpp"
#include "python/bindings.hpp"
#include "python/interruptible.hpp"
#include "python/json_objects.hpp"
#include "python/study.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;

constexpr double degree = std::numbers::pi / 180.0;

// What a caller says by name, in the unit of the name; each is there.
class Words {
 public:
  explicit Words(const py::dict& said) : said_(said) {}
  [[nodiscard]] double number(const char* name) const { return said_[name].cast<double>(); }
  [[nodiscard]] int whole(const char* name) const { return said_[name].cast<int>(); }
  [[nodiscard]] std::optional<double> optional(const char* name) const {
    return said_[name].cast<std::optional<double>>();
  }

  // A task with those that are said; a name has no unit where that is a plain one of SI, "cell_voltage". A fault is
  // told as one of what the actuator should do.
  template <class Task>
  [[nodiscard]] Task task_of(const Actuator& actuator, std::span<const text::Row<Task>> rows, Task task = {}) const {
    for (const text::Row<Task>& row : rows) {
      const std::string name(said_.contains(std::string(row.key)) ? row.key : units::quantity_of(row.key));
      const py::object value = said_[name.c_str()];
      if (value.is_none()) continue;
      if (!row.words.empty()) {
        row.set(task, place_of(row.words, name, value.cast<std::string>()));
        continue;
      }
      const auto number = value.cast<double>();
      // As it is by itself where no file may say that: no height, no least current.
      if (row.get(task) == units::to_memory(number, row.key)) continue;
      if (!row.rule.allows(number) || (row.whole && number != std::floor(number)))
        throw text::InputError({.file = actuator.origin,
                                .place = name,
                                .rule = row.whole ? "must be a whole number, and " + row.rule.text() : row.rule.text(),
                                .value = fmt::format("{}", number)});
      row.set(task, units::to_memory(number, row.key));
    }
    return task;
  }

 private:
  static double place_of(std::span<const std::string_view> words, const std::string& name, const std::string& word) {
    const auto found = std::ranges::find(words, word);
    if (found == words.end())
      throw py::value_error(fmt::format("{}: must be '{}'; got '{}'", name, fmt::join(words, "' or '"), word));
    return static_cast<double>(found - words.begin());
  }

  const py::dict& said_;
};

struct Built {
  actuator::Design design;
  actuator::Assembly assembly;
};

Built built(const Actuator& actuator, const char* reason) {
  const auto* design = std::get_if<actuator::Design>(&actuator.content.content);
  if (design == nullptr)
    throw text::InputError({.file = actuator.origin, .rule = std::string("is a lumped model: ") + reason});
  try {
    return {.design = *design, .assembly = actuator::assemble_or_throw(*design)};
  } catch (const std::invalid_argument& fault) {
    throw text::InputError({.file = actuator.origin, .rule = fault.what()});
  }
}

// Done with the interpreter free; a rule that is broken is the actuator's.
template <class Work>
py::object answer(const Actuator& actuator, const Work& work) {
  try {
    const text::Json json = [&] {
      const py::gil_scoped_release others_run;
      return work();
    }();
    return to_python(json);
  } catch (const text::InputError&) {
    throw;
  } catch (const std::invalid_argument& rule) {
    throw text::InputError({.file = actuator.origin, .rule = rule.what()});
  } catch (const std::runtime_error& reason) {
    throw text::InputError({.file = actuator.origin, .rule = reason.what()});
  }
}

py::object linearise(const Actuator& actuator, const std::vector<double>& currents) {
  const actuator::Model model = actuator.driven().model;
  return answer(actuator, [&] {
    if (currents.size() == 1) return formats::to_json(simulation::linearise(model, currents.front()));
    const auto count = static_cast<Eigen::Index>(currents.size());
    return formats::to_json(simulation::linearise(
        model, actuator::CoilCurrents(Eigen::Map<const Eigen::VectorXd>(currents.data(), count))));
  });
}

py::object reach(const Actuator& actuator, const py::dict& said) {
  const Words words(said);
  const std::optional<double> highest = words.optional("highest_current");
  const auto* design = std::get_if<actuator::Design>(&actuator.content.content);
  if (!highest && design == nullptr)
    throw text::InputError(
        {.file = "highest_current", .rule = "is needed: a lumped model does not say what current its coils bear"});
  const control::ReachTask task{.angle = words.number("angle_deg") * degree,
                                .start_current = words.number("from_current"),
                                .lowest_current = words.number("lowest_current"),
                                .highest_current = highest ? *highest : actuator::operating_current_limit(*design),
                                .stiffness_error = words.number("stiffness_error_percent") / 100.0,
                                .damping_error = words.number("damping_error_percent") / 100.0,
                                .pieces = words.whole("pieces")};
  const actuator::Model model = actuator.driven().model;
  return answer(actuator, [&] { return formats::to_json(control::reach(model, task)); });
}

py::object drive(const Actuator& actuator, const py::dict& said) {
  const Words words(said);
  const formats::DriveTask usual;
  const auto task = words.task_of(actuator, formats::drive_rows());
  systems::DriveQuestion question = task.asked();
  if (said["coil_temperature_degC"].is_none()) question.coil_temperature.reset();
  const bool has_cell = task.cell.circuit.emf > 0.0;
  if (!question.duty && !question.mean) throw py::value_error("give duty, mean_current or both");
  if (!has_cell && task.cell.capacity) throw py::value_error("cell_capacity_mAh is of a cell: give cell_voltage, too");
  if (question.duty && question.mean && (has_cell || task.bridge.supply_voltage != usual.bridge.supply_voltage))
    throw py::value_error(
        "with duty and mean_current the voltage is what is looked for: give no supply_voltage and no cell_voltage");
  const Built it = built(actuator, "a drive needs a design (actuator/1)");
  return answer(actuator, [&] { return formats::to_json(systems::drive_actuator(it.design, it.assembly, question)); });
}

py::object grip(const Actuator& actuator, const py::dict& said) {
  const Words words(said);
  const Built it = built(actuator, "a gripper needs a design (actuator/1)");
  // Of a shape with a height, of which none may be said.
  const auto task = words.task_of<systems::gripper::GripperTask>(
      actuator, formats::grip_rows({.object = {.shape = systems::gripper::ObjectShape::box}}));
  if (task.object.has_flat_sides() != (task.object.height > 0.0))
    throw py::value_error("height_mm: is needed for a box and an upright cylinder, and for nothing else");
  const std::optional<double> current = words.optional("current");
  const double most_friction = words.number("least_friction_up_to");
  return answer(actuator, [&] {
    return formats::to_json(
        systems::gripper::grip(it.design, task, current, actuator.content.operating_point, most_friction));
  });
}

py::object crawl(const Actuator& actuator, const py::dict& said) {
  const auto task = Words(said).task_of(actuator, formats::crawl_rows());
  const Built it = built(actuator, "a crawler needs a design (actuator/1)");
  return answer(actuator, [&] {
    const systems::Crawler crawler(it.design, it.assembly, task.parts);
    const systems::Crawl found = systems::crawl(crawler, task.timing);
    return formats::to_json(
        formats::rows_of(crawler, found, systems::heat_of_crawl(it.design, it.assembly, crawler, found)));
  });
}

// The study with the design in the place of its own, at the current that it is built for.
sizing::Study study_of_one(const Study& study, const Actuator& actuator, const std::optional<double>& current) {
  sizing::Study out = study.content;
  for (const sizing::StudyVariable& each : out.variables)
    if (std::holds_alternative<sizing::SettingVariable>(each))
      throw text::InputError({.file = study.origin,
                              .place = "/variables/" + sizing::name_of(each),
                              .rule =
                                  "must not vary: no actuator says what it is; Study.load(.., set=..) of a study in "
                                  "which it is a number of its block"});
  return formats::study_of_one(std::move(out), study.origin,
                               {.option = "current",
                                .set = "Study.load(.., set=..) with ",
                                .given = current,
                                .actuator = actuator.origin,
                                .of_file = actuator.content.operating_point});
}

py::tuple yield_of(const Study& study, const Actuator& actuator, const std::optional<double>& current,
                   std::size_t builds, std::size_t worth_builds, std::uint64_t seed, unsigned threads) {
  const sizing::Study one = study_of_one(study, actuator, current);
  const sizing::Yield found = interruptible([&](const std::stop_token& stop) {
    const sizing::DesignResult design = sizing::DesignProblem(one).evaluate_base();
    if (const auto* none = std::get_if<sizing::NotEvaluated>(&design))
      throw text::InputError({.file = actuator.origin, .rule = none->reason});
    return sizing::yield_of(
               one, std::get<sizing::EvaluatedDesign>(design),
               {.builds = builds, .worth_builds = worth_builds, .seed = seed, .threads = threads, .stop = stop})
        .value_or(sizing::Yield{});
  });
  return py::make_tuple(to_python(formats::to_json(found)), report::to_text(report::document_of(found)));
}

}  // namespace

void bind_systems(py::module_& module) {
  module.def("linearise", &linearise, py::arg("actuator"), py::arg("currents"));
  module.def("reach", &reach, py::arg("actuator"), py::arg("said"));
  module.def("drive", &drive, py::arg("actuator"), py::arg("said"));
  module.def("grip", &grip, py::arg("actuator"), py::arg("said"));
  module.def("crawl", &crawl, py::arg("actuator"), py::arg("said"));
  module.def("yield_of", &yield_of, py::arg("study"), py::arg("actuator"), py::arg("current"), py::arg("builds"),
             py::arg("worth"), py::arg("seed"), py::arg("threads"));
}

}  // namespace coilwright::python
