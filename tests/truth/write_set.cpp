#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "truth/data_set.hpp"
#include "truth/declared_finger.hpp"
#include "truth/text_file.hpp"

namespace truth {
namespace {

using Json = nlohmann::ordered_json;

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
  Json index = {{"format", "measured-data/1"},
                {"name", fmt::format("finger {}", set.request.seed)},
                {"actuator", "finger.json"},
                {"calibrate", {"joint_stiffness", "joint_damping"}},
                {"runs", runs}};
  if (set.request.states_exact_numbers) index["tolerances"] = "exact";
  write_text(folder / "finger.json", declared_finger());
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
                      {"share_of_bound", effect.share_of_bound},
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
