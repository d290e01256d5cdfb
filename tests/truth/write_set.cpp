#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "truth/data_set.hpp"

namespace truth {
namespace {

using Json = nlohmann::ordered_json;

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

// The declared model: Table II of the paper.
Json declared_finger() {
  const Finger finger;
  const Pair pair;
  Json joint = {{"stiffness_Nm_rad", finger.stiffness}, {"damping_Nms_rad", finger.damping}};
  Json magnetics = {{"winding", "paper_shells"},
                    {"torque", "line_of_centres"},
                    {"coil_offset_mm", 6.3},
                    {"magnet_offset_mm", 3.6},
                    {"axis_offset_mm", 11.5},
                    {"coil",
                     {{"inner_radius_mm", 3},
                      {"outer_radius_mm", 9.5},
                      {"length_mm", 12},
                      {"turns_radial", pair.turns_radial},
                      {"turns_axial", pair.turns_axial}}},
                    {"magnet", {{"radius_mm", 10}, {"length_mm", 6}, {"remanence_T", pair.remanence}}}};
  const auto link = [&](double length, double com_along, double mass) {
    return Json{{"length_m", length},
                {"com_along_m", com_along},
                {"com_offset_m", finger.axis_offset},
                {"mass_kg", mass},
                {"inertia_kgm2", 0}};
  };
  return {{"format", "lumped-model/1"},
          {"name", "paper finger, Table II"},
          {"gravity_m_s2", finger.gravity},
          {"links",
           {link(0.0072, finger.half_pitch, finger.first_mass), link(0.0212, finger.second_com, finger.second_mass)}},
          {"joints", {joint, joint}},
          {"magnetics", {magnetics, magnetics}}};
}

std::string csv_of(const DataSetRequest& request, const RecordedRun& run) {
  std::string text = request.camera == Camera::joint_angles ? "time_s,current_A,theta1_deg,theta2_deg\n"
                                                            : "time_s,current_A,bending_angle_deg\n";
  for (std::size_t i = 0; i < run.angles_deg.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{:.3f},{:.6f}", run.experiment.times[i], run.experiment.currents[i]);
    for (const double angle : run.angles_deg[i]) fmt::format_to(std::back_inserter(text), ",{:.2f}", angle);
    text += '\n';
  }
  return text;
}

}  // namespace

void write_data_set(const DataSet& set, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  Json runs = Json::array();
  for (const RecordedRun& run : set.runs) {
    const std::string file = run.experiment.name + ".csv";
    runs.push_back({{"file", file},
                    {"kind", "transient"},
                    {"role", run.validate ? "validate" : "fit"},
                    {"drive", "current"},
                    {"start", "at_rest"}});
    write_text(folder / file, csv_of(set.request, run));
  }
  const Json index = {{"format", "measured-data/1"},
                      {"name", fmt::format("finger {}", set.request.seed)},
                      {"actuator", "finger.json"},
                      {"calibrate", {"joint_stiffness", "joint_damping"}},
                      {"runs", runs}};
  write_text(folder / "finger.json", declared_finger().dump(2) + "\n");
  write_text(folder / "dataset.json", index.dump(2) + "\n");
}

void write_answer(const Answer& answer, const std::filesystem::path& file) {
  Json hidden = Json::array();
  for (const HiddenEffect& effect : answer.hidden) {
    Json numbers = Json::object();
    for (const HiddenEffect::Number& number : effect.numbers) numbers[number.key] = number.value;
    hidden.push_back({{"id", effect.id},
                      {"in_catalogue", !effect.outsider},
                      {"parameters", numbers},
                      {"strength_asked", effect.asked},
                      {"strength", effect.strength},
                      {"strength_after_calibration", effect.strength_after_calibration},
                      {"visible", effect.visible},
                      {"rivals", effect.confounders}});
  }
  const Json all = {{"seed", answer.seed},
                    {"effects", hidden},
                    {"joint_stiffness_Nmm_rad", answer.joint_stiffness * 1e3},
                    {"joint_damping_Nmms_rad", answer.joint_damping * 1e3}};
  write_text(file, all.dump(2) + "\n");
}

}  // namespace truth
