#include "coilwright/formats/data/experiment_file.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "coilwright/units/unit.hpp"
#include "formats/data/experiment_parts.hpp"
#include "formats/data/run_words.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::Drive;
using measurement::data::RigChange;
using measurement::data::Run;
using measurement::data::RunKind;
using measurement::planning::Experiment;
using measurement::planning::PlannedRun;

void add_time_axis(Json& out, const PlannedRun& run) {
  out.set("duration_s", run.duration).set("sampling_rate_Hz", run.rate);
}

void add_measure(Json& out, const Run& plan) {
  out.set("measure", Json::list(plan.channels, &measurement::data::Channel::name));
}

void add_transient(Json& out, const PlannedRun& run) {
  const Run& plan = run.plan;
  add_time_axis(out, run);
  add_measure(out, plan);
  out.set("input", input_shape_json(run.input, plan.drive));
  if (plan.drive != Drive::current) out.set("drive", name_of(plan.drive));
  if (run.only) out.set(plan.drive == Drive::torque ? "joint" : "coil", *run.only + 1);
  if (plan.start != measurement::data::Start::at_rest) out.set("start", name_of(plan.start));
  if (!run.start_angles.empty()) out.set(Json::quantities("start_angles_deg", run.start_angles));
  if (plan.clock.exposure > 0.0) out.set("exposure_s", plan.clock.exposure);
  if (plan.clock.offset_sigma > 0.0) out.set("clock_offset_s", plan.clock.offset_sigma);
  if (plan.clock.rate_sigma > 0.0) out.set("clock_rate", plan.clock.rate_sigma);
  if (run.input_rate > 0.0) out.set("input_rate_Hz", run.input_rate);
  add_input_uncertainty(out, plan.input_uncertainty);
  if (plan.hold != measurement::data::InputHold::zero_order) out.set("input_hold", name_of(plan.hold));
  if (plan.rig != RigChange{}) out.set("rig", rig_json(plan.rig));
}

std::vector<double> first_inputs(const Run& plan) {
  std::vector<double> out;
  for (const std::vector<double>& row : plan.inputs) out.push_back(row.front());
  return out;
}

// Every angle under every current, as the reader lays them out.
void add_static_torque(Json& out, const Run& plan) {
  std::vector<double> currents = first_inputs(plan);
  currents.erase(std::unique(currents.begin(), currents.end()), currents.end());
  const std::size_t angles = currents.empty() ? 0 : plan.angles.size() / currents.size();
  const std::vector<double> once(plan.angles.begin(), plan.angles.begin() + static_cast<std::ptrdiff_t>(angles));
  for (std::size_t i = 0; i < plan.angles.size(); ++i)
    if (angles == 0 || i / angles >= currents.size() || plan.angles[i] != once[i % angles] ||
        plan.inputs[i].front() != currents[i / angles])
      throw std::invalid_argument(plan.name + ": must have every angle under every current");
  out.set(Json::quantities("angles_deg", once)).set("currents_A", Json::numbers(currents));
}

void add_bench(Json& out, const Run& plan) {
  if (plan.kind == RunKind::static_torque) return add_static_torque(out, plan);
  if (plan.kind == RunKind::joint_stiffness) {
    out.set(Json::quantities("angles_deg", plan.angles));
    return;
  }
  if (!plan.openings.empty() || !plan.heights.empty())
    throw std::invalid_argument(plan.name + ": must be a grasp that is closed and at the tip");
  out.set("currents_A", Json::numbers(first_inputs(plan)));
}

Drive drive_of(const Experiment& experiment) {
  for (const PlannedRun& run : experiment.runs)
    if (run.plan.kind == RunKind::transient) return run.plan.drive;
  return Drive::current;
}

}  // namespace

Json run_json(const PlannedRun& run) {
  const Run& plan = run.plan;
  Json out = Json::object({{"file", plan.name}, {"role", run.validate ? "validate" : "fit"}});
  if (plan.kind != RunKind::transient) out.set("kind", name_of(plan.kind));
  switch (plan.kind) {
    case RunKind::transient:
      add_transient(out, run);
      break;
    case RunKind::still:
      add_time_axis(out, run);
      add_measure(out, plan);
      break;
    case RunKind::temperature:
      add_time_axis(out, run);
      out.set("input", input_shape_json(run.input, plan.drive));
      break;
    case RunKind::static_torque:
    case RunKind::joint_stiffness:
    case RunKind::blocked_force:
      add_bench(out, plan);
      break;
  }
  return out;
}

Json experiment_json(const Experiment& experiment, const std::string& description) {
  Json out = Json::object({{"format", "experiment/1"}, {"name", experiment.name}});
  if (!description.empty()) out.set("description", description);
  add_instruments(out, experiment.instruments, drive_of(experiment));
  out.set("runs", Json::list(experiment.runs, run_json));
  return out;
}

}  // namespace coilwright::formats
