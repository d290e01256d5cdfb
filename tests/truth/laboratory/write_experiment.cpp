#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "degree.hpp"
#include "truth/declared_finger.hpp"
#include "truth/laboratory/laboratory_set.hpp"
#include "truth/laboratory/recorder.hpp"
#include "truth/laboratory/run_keys.hpp"
#include "truth/text_file.hpp"

namespace truth::laboratory {
namespace {

using Json = nlohmann::ordered_json;

constexpr double driver_rate = 500.0;  // changes of a smooth input per second

void add_noise(const NoiseFaults& noise, Json& experiment) {
  double level = noise.level * radian_in_degrees;
  if (noise.colour == Colour::hum) {  // half of the variance: a sine with the amplitude of the whole
    experiment["hum"] = {{"frequency_Hz", 50}, {"angle_deg", level}};
    level *= std::sqrt(0.5);
  }
  experiment["noise"] = {{"angle_deg", level}};
  if (noise.colour == Colour::low_passed)
    experiment["noise_colour"] = {{"angle_deg", {{"kind", "low_pass"}, {"frequency_Hz", 10}}}};
  if (noise.colour == Colour::pink) experiment["noise_colour"] = {{"angle_deg", {{"kind", "one_over_f"}}}};
  if (noise.outliers > 0.0) experiment["outliers"] = {{"share", noise.outliers}, {"angle_deg", {3, 10}}};
  if (noise.input_noise > 0.0) experiment["input_noise"] = {{"current_A", noise.input_noise}};
  experiment["resolution"] = {{"angle_deg", resolution_deg}};
}

bool has_two_clocks(const ClockFaults& clocks) {
  return clocks.log != InputLog::beside_pictures || stated_offset(clocks) > 0.0;
}

std::string input_of(const PlannedRun& run) {
  std::string text = "time_s,current_A\n";
  for (const double time : input_changes(run))
    fmt::format_to(std::back_inserter(text), "{:.6f},{:.6f}\n", time, current_at(run.experiment, run.begins + time));
  return text;
}

}  // namespace

void write_experiment(const LaboratorySet& set, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const Request& request = set.request;
  const bool one_clock = !has_two_clocks(request.clocks) && request.camera.exposure_share == 0.0;
  Json experiment = {{"format", "experiment/1"},
                     {"name", fmt::format("laboratory_{}", request.seed)},
                     {"sampling_rate_Hz", request.camera.frame_rate}};
  experiment["measure"] =
      request.channels == Camera::joint_angles ? Json{"theta1_deg", "theta2_deg"} : Json::array({"bending_angle_deg"});
  if (request.camera.exposure_share > 0.0)
    experiment["exposure_s"] = request.camera.exposure_share / request.camera.frame_rate;
  if (const double offset = stated_offset(request.clocks); offset > 0.0) experiment["clock_offset_s"] = offset;
  if (request.clocks.rate > 0.0) experiment["clock_rate"] = request.clocks.rate;
  if (request.clocks.log == InputLog::own_samples) experiment["input_rate_Hz"] = request.clocks.own_rate;
  if (request.clocks.log == InputLog::every_change) experiment["input_rate_Hz"] = driver_rate;
  add_noise(request.noise, experiment);

  Json runs = Json::array();
  if (set.still)
    runs.push_back({{"file", "still.csv"}, {"kind", "still"}, {"duration_s", set.still->planned.duration}});
  for (const RecordedRun& run : set.runs) {
    const PlannedRun& planned = run.planned;
    const std::string& name = planned.experiment.name;
    const bool let_go = planned.begins > 0.0;
    if (let_go && !one_clock) continue;
    Json entry = {{"file", name + ".csv"},
                  {"role", planned.validate ? "validate" : "fit"},
                  {"duration_s", planned.duration},
                  {"input", {{"file", name + "_driven.csv"}}}};
    if (const std::string_view hold = hold_of(request, planned); hold != "zero_order") entry["input_hold"] = hold;
    if (let_go) {  // held where it is while a current runs
      entry["start"] = "free";
      entry["start_angles_deg"] = Json::array();
      for (const double angle : equilibrium({}, {}, planned.experiment.currents.front()))
        entry["start_angles_deg"].push_back(angle * radian_in_degrees);
    }
    if (const Json rig = rig_of(planned.experiment.rig); !rig.empty()) entry["rig"] = rig;
    runs.push_back(entry);
    write_text(folder / (name + "_driven.csv"), input_of(planned));
  }
  experiment["runs"] = runs;
  write_text(folder / "finger.json", declared_finger(set.answer.declared_faces));
  write_text(folder / "experiment.json", experiment.dump(2) + "\n");
}

}  // namespace truth::laboratory
