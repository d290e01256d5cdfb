#include "coilwright/formats/data/dataset_writer.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement;

Json run_json(const RunWithRole& each) {
  const data::Run& run = each.run;
  Json out =
      Json::object({{"file", run.name}, {"kind", name_of(run.kind)}, {"role", each.validate ? "validate" : "fit"}});
  if (run.kind == data::RunKind::transient) out.set("drive", name_of(run.drive)).set("start", name_of(run.start));
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
  for (const RunWithRole& each : runs) list.add(run_json(each));
  return Json::object(
      {{"format", "measured-data/1"}, {"name", name}, {"actuator", actuator}, {"runs", std::move(list)}});
}

void write_run(std::ostream& out, const data::Run& run) {
  std::vector<std::string> columns;
  if (!run.times.empty()) columns.emplace_back("time_s");
  if (!run.angles.empty()) columns.emplace_back("angle_deg");
  for (std::string& input : input_columns(run)) columns.push_back(std::move(input));
  for (const data::Channel& channel : run.channels) columns.push_back(channel.name);
  CsvWriter csv(out, columns);
  std::vector<double> row;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    row.clear();
    if (!run.times.empty()) row.push_back(run.times[i]);
    if (!run.angles.empty()) row.push_back(units::from_memory(run.angles[i], "angle_deg"));
    if (!run.inputs.empty()) row.insert(row.end(), run.inputs[i].begin(), run.inputs[i].end());
    for (const data::Channel& channel : run.channels)
      row.push_back(units::from_memory(channel.values[i], channel.name));
    for (double& value : row) value = twelve_digits(value);
    csv.row(row);
  }
}

}  // namespace coilwright::formats
