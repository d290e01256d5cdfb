#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "degree.hpp"
#include "truth/declared_finger.hpp"
#include "truth/laboratory/laboratory_set.hpp"
#include "truth/laboratory/names.hpp"
#include "truth/laboratory/run_keys.hpp"
#include "truth/text_file.hpp"

namespace truth::laboratory {
namespace {

using Json = nlohmann::ordered_json;

bool has_input_file(const Request& request) {
  return request.clocks.log != InputLog::beside_pictures;
}

// In a file of clocks that agree, a standard deviation of zero is the default; with a file of the input one sample is.
void add_clock(const Request& request, Json& run) {
  const ClockFaults& clocks = request.clocks;
  const double offset = stated_offset(clocks);
  if (offset > 0.0 || has_input_file(request)) run["clock_offset_s"] = offset;
  if (clocks.rate > 0.0) run["clock_rate"] = clocks.rate;
}

Json run_entry(const LaboratorySet& set, const RecordedRun& run) {
  const Request& request = set.request;
  const std::string& name = run.planned.experiment.name;
  Json out = {{"file", name + ".csv"}};
  if (has_input_file(request)) out["input_file"] = name + "_input.csv";
  out["kind"] = "transient";
  out["role"] = run.planned.validate ? "validate" : "fit";
  out["drive"] = "current";
  out["start"] = run.planned.begins > 0.0 ? "free" : "at_rest";
  if (const std::string_view hold = hold_of(request, run.planned); hold != "zero_order") out["input_hold"] = hold;
  add_clock(request, out);
  if (request.camera.exposure_share > 0.0)
    out["exposure_s"] = request.camera.exposure_share / request.camera.frame_rate;
  if (request.noise.sigma_given)
    out["sigma"] = std::hypot(request.noise.level * radian_in_degrees, resolution_deg / std::sqrt(12.0));
  if (const Json rig = rig_of(run.planned.experiment.rig); !rig.empty()) out["rig"] = rig;
  return out;
}

std::string_view channels_of(const Request& request) {
  return request.channels == Camera::joint_angles ? "theta1_deg,theta2_deg" : "bending_angle_deg";
}

std::string measurement_csv(const Request& request, const RecordedRun& run, bool with_input) {
  std::string text = fmt::format("time_s,{}{}\n", with_input ? "current_A," : "", channels_of(request));
  for (std::size_t i = 0; i < run.stamps.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{:.6f}", run.stamps[i]);
    if (with_input) fmt::format_to(std::back_inserter(text), ",{:.6f}", run.currents[i]);
    for (const double angle : run.angles_deg[i]) fmt::format_to(std::back_inserter(text), ",{:.2f}", angle);
    text += '\n';
  }
  return text;
}

std::string input_csv(const RecordedRun& run) {
  std::string text = "time_s,current_A\n";
  for (std::size_t i = 0; i < run.input_times.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{:.6f},{:.6f}\n", run.input_times[i], run.currents[i]);
  return text;
}

Json tolerances_of(const BuiltFinger& built) {
  Json out = Json::object();
  for (const Number& number : built.numbers) out[number.name] = number.tolerance;
  return out;
}

Json effects_of(const Answer& answer) {
  Json out = Json::array();
  for (const HiddenEffect& effect : answer.hidden) {
    Json numbers = Json::object();
    for (const HiddenEffect::Number& number : effect.numbers) numbers[number.key] = number.value;
    out.push_back({{"id", effect.id},
                   {"in_catalogue", !effect.outsider},
                   {"parameters", numbers},
                   {"strength_asked", effect.asked},
                   {"share_of_bound", effect.share_of_bound},
                   {"strength", effect.strength},
                   {"strength_after_calibration", effect.strength_after_calibration},
                   {"visible", effect.visible},
                   {"evidence", effect.evidence},
                   {"rivals", effect.confounders}});
  }
  return out;
}

Json faces_of(const Faces& faces) {
  if (faces.stiffness <= 0.0) return nullptr;
  return {{"closing_angle_deg", faces.angle * radian_in_degrees},
          {"stiffness_Nm_rad", faces.stiffness},
          {"damping_Nms_rad", faces.damping}};
}

Json numbers_of(const BuiltFinger& built) {
  Json out = Json::object();
  for (const Number& number : built.numbers)
    out[number.name] = {
        {"declared", number.declared}, {"is", number.is}, {"tolerance", number.tolerance}, {"moved_far", number.far}};
  return out;
}

Json runs_of(const LaboratorySet& set) {
  Json out = Json::array();
  for (const RecordedRun& run : set.runs) {
    Json outliers = Json::array();
    for (const Outlier& one : run.outliers)
      outliers.push_back({{"time_s", one.time}, {"by_deg", one.by * radian_in_degrees}});
    out.push_back({{"file", run.planned.experiment.name + ".csv"},
                   {"clock_offset_s", run.clock.offset},
                   {"clock_rate", run.clock.rate},
                   {"outliers", outliers}});
  }
  return out;
}

}  // namespace

void write_laboratory_set(const LaboratorySet& set, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const Request& request = set.request;
  Json runs = Json::array();
  if (set.still) {
    runs.push_back({{"file", "still.csv"}, {"kind", "still"}, {"role", "fit"}});
    write_text(folder / "still.csv", measurement_csv(request, *set.still, false));
  }
  for (const RecordedRun& run : set.runs) {
    const std::string& name = run.planned.experiment.name;
    runs.push_back(run_entry(set, run));
    write_text(folder / (name + ".csv"), measurement_csv(request, run, !has_input_file(request)));
    if (has_input_file(request)) write_text(folder / (name + "_input.csv"), input_csv(run));
  }
  Json index = {{"format", "measured-data/1"},
                {"name", fmt::format("laboratory {}", request.seed)},
                {"actuator", "finger.json"},
                {"calibrate", {"joint_stiffness", "joint_damping"}}};
  if (request.tolerances == Tolerances::exact) index["tolerances"] = "exact";
  if (request.tolerances == Tolerances::listed) index["tolerances"] = tolerances_of(set.answer.built);
  index["runs"] = runs;
  write_text(folder / "finger.json", declared_finger(set.answer.declared_faces));
  write_text(folder / "dataset.json", index.dump(2) + "\n");
}

void write_answer(const LaboratorySet& set, const std::filesystem::path& file) {
  const Request& request = set.request;
  const Answer& common = set.answer.common;
  const Json all = {
      {"seed", request.seed},
      {"programme", name_of(request.programme)},
      {"effects", effects_of(common)},
      {"joint_stiffness_Nmm_rad", common.joint_stiffness * 1e3},
      {"joint_damping_Nmms_rad", common.joint_damping * 1e3},
      {"deviation", name_of(request.deviation)},
      {"tolerances", name_of(request.tolerances)},
      {"numbers", numbers_of(set.answer.built)},
      {"force_curve_coefficients", set.answer.built.finger.curve_error},
      {"angle_scale", set.answer.built.angle_scale},
      {"faces", {{"declared", faces_of(set.answer.declared_faces)}, {"are", faces_of(set.answer.built.finger.faces)}}},
      {"noise",
       {{"colour", name_of(request.noise.colour)},
        {"sigma_deg", request.noise.level * radian_in_degrees},
        {"resolution_deg", resolution_deg},
        {"outlier_share", request.noise.outliers},
        {"input_noise_A", request.noise.input_noise}}},
      {"camera",
       {{"frame_rate_Hz", request.camera.frame_rate},
        {"exposure_s", request.camera.exposure_share / request.camera.frame_rate},
        {"jitter_s", request.camera.jitter}}},
      {"runs", runs_of(set)}};
  write_text(file, all.dump(2) + "\n");
}

}  // namespace truth::laboratory
