#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/simulation/commanded_input_file.hpp"
#include "coilwright/formats/simulation/motion_table.hpp"
#include "coilwright/report/simulation/motion_remarks.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "coilwright/text/input_error.hpp"
#include "python/actuator.hpp"
#include "python/bindings.hpp"
#include "python/interruptible.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;
using simulation::CommandedInput;
using simulation::ModelInput;

struct Command {
  CommandedInput input;
  simulation::Start start{};
  std::optional<std::string> recorded_in{};  // what errors call it; nothing: it is taken as it is
  std::string table{};                       // at whose samples alone the motion is shown; empty: at others, too
};

struct Motion {
  std::vector<std::string> columns;
  py::array_t<double> rows;  // (samples, columns)
};

Command step(double current, double duration, double interval) {
  return {.input = simulation::step_command({.current = current, .duration = duration, .interval = interval}),
          .start = simulation::Start::no_current};
}

Command sine(const std::array<double, 3>& shape, double duration, double interval) {
  return {.input = simulation::sine_command({.amplitude = shape[0],
                                             .offset = shape[1],
                                             .frequency = shape[2],
                                             .duration = duration,
                                             .interval = interval})};
}

// Arrays come as the text of a table, so that one reader checks columns and units, wherever they are from.
Command table(const std::string& text, const std::string& origin, std::optional<double> interval, bool as_written) {
  CommandedInput input = formats::parse_commanded_input(text, origin);
  return {.input = interval ? simulation::sampled_at_least_every(input, *interval) : std::move(input),
          .recorded_in = as_written ? std::nullopt : std::optional(origin),
          .table = interval ? std::string() : origin};
}

struct Stopped {};

simulation::RecordedMotion record(const Actuator::Driven& driven, const Command& command, const ModelInput& input,
                                  const std::string& origin, const std::stop_token& stop) {
  const actuator::Model& model = driven.model;
  if (command.recorded_in) formats::require_bearable(command.input, input, driven.coil, *command.recorded_in);
  const auto heed_stop = [&](double) {
    if (stop.stop_requested()) throw Stopped{};
  };
  return simulation::record_motion(model, input, start_of(model, input, command.start, origin),
                                   {.progress = heed_stop});
}

py::array_t<double> rows_of(const Command& command, const simulation::RecordedMotion& motion, std::size_t columns) {
  py::array_t<double> out({motion.states.size(), columns});
  for (std::size_t i = 0; i < motion.states.size(); ++i) {
    const std::vector<double> row = formats::motion_row(command.input, motion, i);
    std::copy(row.begin(), row.end(), out.mutable_data(static_cast<py::ssize_t>(i), 0));
  }
  return out;
}

Motion simulate(const Actuator& actuator, const Command& command) {
  const Actuator::Driven driven = actuator.driven();
  try {
    const ModelInput input = simulation::model_input(driven.model, command.input);
    const simulation::RecordedMotion motion = interruptible(
        [&](const std::stop_token& stop) { return record(driven, command, input, actuator.origin, stop); });
    std::vector<std::string> columns = formats::columns_of_motion(command.input, driven.model.joints());
    py::array_t<double> rows = rows_of(command, motion, columns.size());
    for (const std::string& remark : report::motion_remarks({.model = driven.model,
                                     .input = input,
                                     .motion = motion,
                                     .table = command.table,
                                     .cure = "interval=0.002",
                                     .supply_drives = driven.supply_drives}))
      warn(remark);
    return {.columns = std::move(columns), .rows = std::move(rows)};
  } catch (const std::invalid_argument& misfit) {
    throw text::InputError({.file = actuator.origin, .rule = misfit.what()});
  }
}

}  // namespace

void bind_motion(py::module_& module) {
  py::class_<Command>(module, "Command")
      .def_static("step", &step, py::arg("current"), py::arg("duration"), py::arg("interval"))
      .def_static("sine", &sine, py::arg("shape"), py::arg("duration"), py::arg("interval"))
      .def_static("table", &table, py::arg("text"), py::arg("origin"), py::arg("interval"), py::arg("as_written"));
  module.def(
      "simulate",
      [](const Actuator& actuator, const Command& command) {
        Motion motion = simulate(actuator, command);
        return py::make_tuple(std::move(motion.columns), std::move(motion.rows));
      },
      py::arg("actuator"), py::arg("command"));
}

}  // namespace coilwright::python
