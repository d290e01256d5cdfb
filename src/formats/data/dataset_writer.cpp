#include "coilwright/formats/data/dataset_writer.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/run_words.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement;

Json rig_change_json(const data::RigChange& rig) {
  Json out = Json::object();
  if (rig.base_turn != 0.0) out.set("base_turn_deg", units::from_memory(rig.base_turn, "base_turn_deg"));
  if (rig.tip_mass != 0.0) out.set("tip_mass_g", units::from_memory(rig.tip_mass, "tip_mass_g"));
  if (rig.coil != data::CoilWiring::driven) out.set("coil", name_of(rig.coil));
  return out;
}

// What differs from the defaults of the format.
void add_recording(Json& out, const data::Run& run) {
  if (const auto input = input_file_name(run)) out.set("input_file", *input);
  if (run.hold != data::InputHold::zero_order) out.set("input_hold", name_of(run.hold));
  if (run.clock.offset_sigma > 0.0 || run.has_input_clock()) out.set("clock_offset_s", run.clock.offset_sigma);
  if (run.clock.rate_sigma > 0.0) out.set("clock_rate", run.clock.rate_sigma);
  if (run.clock.exposure > 0.0) out.set("exposure_s", run.clock.exposure);
  add_input_uncertainty(out, run.input_uncertainty);
  if (run.rig != data::RigChange{}) out.set("rig", rig_change_json(run.rig));
}

Json dataset_run_json(const RunWithRole& each) {
  const data::Run& run = each.run;
  Json out =
      Json::object({{"file", run.name}, {"kind", name_of(run.kind)}, {"role", each.validate ? "validate" : "fit"}});
  if (run.kind == data::RunKind::transient) out.set("drive", name_of(run.drive)).set("start", name_of(run.start));
  if (run.kind == data::RunKind::transient) add_recording(out, run);
  if (run.window) out.set("window_s", *run.window);
  if (run.sigma) {
    const std::string& column = run.channels.front().name;
    out.set("sigma", units::from_memory(*run.sigma, column));
  }
  return out;
}

double twelve_digits(double value) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 11);
  double rounded{};
  std::from_chars(text.data(), written.ptr, rounded);
  return rounded == 0.0 ? 0.0 : rounded;  // no -0
}

// How the inputs of a run are called: one for all coils, or one a coil or joint.
std::vector<std::string> input_columns(const data::Run& run) {
  if (run.inputs.empty()) return {};
  const std::size_t width = run.inputs.front().size();
  if (run.drive == data::Drive::voltage) return {"voltage_V"};
  if (run.drive == data::Drive::current && width == 1) return {"current_A"};
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= width; ++i)
    names.push_back(run.drive == data::Drive::current ? fmt::format("current{}_A", i) : fmt::format("torque{}_Nm", i));
  return names;
}

}  // namespace

Json dataset_json(const std::string& name, const std::string& actuator, std::span<const RunWithRole> runs) {
  Json list = Json::array();
  for (const RunWithRole& each : runs) list.add(dataset_run_json(each));
  return Json::object(
      {{"format", "measured-data/1"}, {"name", name}, {"actuator", actuator}, {"runs", std::move(list)}});
}

void write_run(std::ostream& out, const data::Run& run) {
  std::vector<std::string> columns;
  if (!run.times.empty()) columns.emplace_back("time_s");
  if (!run.angles.empty()) columns.emplace_back("angle_deg");
  const bool inputs = !run.inputs.empty() && !run.has_input_clock();
  if (inputs)
    for (std::string& input : input_columns(run)) columns.push_back(std::move(input));
  if (!run.openings.empty()) columns.emplace_back("opening_deg");
  if (!run.heights.empty()) columns.emplace_back("height_mm");
  for (const data::Channel& channel : run.channels) columns.push_back(channel.name);
  CsvWriter csv(out, columns);
  std::vector<double> row;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    row.clear();
    if (!run.times.empty()) row.push_back(run.times[i]);
    if (!run.angles.empty()) row.push_back(units::from_memory(run.angles[i], "angle_deg"));
    if (inputs) row.insert(row.end(), run.inputs[i].begin(), run.inputs[i].end());
    if (!run.openings.empty()) row.push_back(units::from_memory(run.openings[i], "opening_deg"));
    if (!run.heights.empty()) row.push_back(units::from_memory(run.heights[i], "height_mm"));
    for (const data::Channel& channel : run.channels)
      row.push_back(units::from_memory(channel.values[i], channel.name));
    for (double& value : row) value = twelve_digits(value);
    csv.row(row);
  }
}

std::optional<std::string> input_file_name(const data::Run& run) {
  if (!run.has_input_clock()) return std::nullopt;
  return run.name.substr(0, run.name.rfind(".csv")) + "_input.csv";
}

void write_input(std::ostream& out, const data::Run& run) {
  std::vector<std::string> columns{"time_s"};
  for (std::string& input : input_columns(run)) columns.push_back(std::move(input));
  CsvWriter csv(out, columns);
  std::vector<double> row;
  for (std::size_t i = 0; i < run.inputs.size(); ++i) {
    row.assign(1, run.input_times[i]);
    row.insert(row.end(), run.inputs[i].begin(), run.inputs[i].end());
    for (double& value : row) value = twelve_digits(value);
    csv.row(row);
  }
}

}  // namespace coilwright::formats
