#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <numbers>
#include <optional>
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
#include "coilwright/formats/systems/task_numbers.hpp"
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
  [[nodiscard]] std::string word(const char* name) const { return said_[name].cast<std::string>(); }

  // Those of a task. A name has the unit of its key where that is no SI unit.
  template <class Task>
  void set_numbers(const std::vector<formats::BlockNumber<Task>>& numbers, Task& task) const {
    for (const auto& [key, rule, get, set, kind] : numbers) {
      const std::string name(said_.contains(std::string(key)) ? key : units::quantity_of(key));
      set(task, number(name.c_str()) * units::to_memory(1.0, key));
    }
  }

 private:
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

drive::HBridge bridge_of(const Words& words) {
  drive::HBridge out{.supply_voltage = words.optional("supply_voltage").value_or(24.0),
                     .supply_resistance = words.number("supply_resistance"),
                     .high_resistance = words.number("high_resistance_mOhm") * 1e-3,
                     .low_resistance = words.number("low_resistance_mOhm") * 1e-3,
                     .dead_time = words.number("dead_time_us") * 1e-6,
                     .decay = words.word("decay") == "slow" ? drive::Decay::slow : drive::Decay::fast,
                     .trip = words.optional("current_limit"),
                     .limit_off_time = words.number("limit_off_time_us") * 1e-6,
                     .limit_blanking = words.number("limit_blanking_us") * 1e-6};
  out.diode_voltage = words.optional("diode_voltage").value_or(out.diode_voltage);
  return out;
}

systems::CellDrive cell_of(const Words& words) {
  systems::CellDrive out{.circuit = {.emf = *words.optional("cell_voltage"),
                                     .resistance = words.number("supply_resistance"),
                                     .switch_resistance = words.number("switch_resistance_mOhm") * 1e-3},
                         .most_current = words.optional("cell_limit")};
  if (const auto capacity = words.optional("cell_capacity_mAh")) out.capacity = *capacity * 3.6;
  out.circuit.diode_voltage = words.optional("diode_voltage").value_or(out.circuit.diode_voltage);
  return out;
}

py::object drive(const Actuator& actuator, const py::dict& said) {
  const Words words(said);
  systems::DriveQuestion question{
      .wiring = words.word("wiring") == "series" ? drive::BankWiring::series : drive::BankWiring::parallel,
      .actuators = words.whole("actuators"),
      .frequency = words.number("frequency"),
      .duty = words.optional("duty"),
      .mean = words.optional("mean_current"),
      .coil_temperature = words.optional("coil_temperature_degC")};
  if (words.optional("cell_voltage"))
    question.driver = cell_of(words);
  else
    question.driver = bridge_of(words);
  const Built it = built(actuator, "a drive needs a design (actuator/1)");
  return answer(actuator, [&] { return formats::to_json(systems::drive_actuator(it.design, it.assembly, question)); });
}

py::object grip(const Actuator& actuator, const py::dict& said) {
  const Words words(said);
  const Built it = built(actuator, "a gripper needs a design (actuator/1)");
  systems::gripper::GripperTask task;
  task.mounting.fingers = words.whole("fingers");
  if (words.word("polarity") == "opposite") task.mounting.polarity = systems::gripper::Polarity::opposite;
  task.object.shape = formats::shape_named(words.word("shape"));
  words.set_numbers(formats::grip_numbers(task), task);
  const std::optional<double> current = words.optional("current");
  const double most_friction = words.number("least_friction_up_to");
  return answer(actuator, [&] {
    return formats::to_json(
        systems::gripper::grip(it.design, task, current, actuator.content.operating_point, most_friction));
  });
}

py::object crawl(const Actuator& actuator, const py::dict& said) {
  systems::CrawlTask task;
  Words(said).set_numbers(formats::crawl_numbers(), task);
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
