#include "coilwright/formats/data/dataset_file.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <functional>
#include <utility>
#include <vector>

#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/run_words.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace measurement;

// What differs from the defaults of the format.
void add_recording(Json& out, const data::Run& run) {
  if (const auto input = input_file_name(run)) out.set("input_file", *input);
  if (run.hold != data::InputHold::zero_order) out.set("input_hold", name_of(run.hold));
  if (run.clock.offset_sigma > 0.0 || run.has_input_clock()) out.set("clock_offset_s", run.clock.offset_sigma);
  if (run.clock.rate_sigma > 0.0) out.set("clock_rate", run.clock.rate_sigma);
  if (run.clock.exposure > 0.0) out.set("exposure_s", run.clock.exposure);
  add_input_uncertainty(out, run.input_uncertainty);
  if (run.rig != data::RigChange{}) out.set("rig", rig_json(run.rig));
}

Json dataset_run_json(const RunWithRole& each) {
  const data::Run& run = each.run;
  Json out =
      Json::object({{"file", run.name}, {"kind", name_of(run.kind)}, {"role", each.validate ? "validate" : "fit"}});
  if (run.kind == data::RunKind::transient) out.set("drive", name_of(run.drive)).set("start", name_of(run.start));
  if (run.kind == data::RunKind::transient) add_recording(out, run);
  if (run.window) out.set("window_s", *run.window);
  if (run.sigma) out.set("sigma", units::from_memory(*run.sigma, run.channels.front().name));
  return out;
}

double twelve_digits(double value) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, 11);
  double rounded{};
  std::from_chars(text.data(), written.ptr, rounded);
  return rounded == 0.0 ? 0.0 : rounded;  // no -0
}

// The columns of a CSV file, each with what it has in a row, in its unit.
class Columns {
 public:
  void add(const std::string& name, const std::vector<double>& values) {
    names_.push_back(name);
    cells_.emplace_back([&values, name](std::size_t i) { return units::from_memory(values[i], name); });
  }
  void add_if_any(const std::string& name, const std::vector<double>& values) {
    if (!values.empty()) add(name, values);
  }
  // One for all coils, or one a coil or joint.
  void add_inputs(const data::Run& run) {
    const std::size_t width = run.inputs.empty() ? 0 : run.inputs.front().size();
    for (std::size_t k = 0; k < width; ++k) {
      names_.push_back(run.drive == data::Drive::voltage                 ? "voltage_V"
                       : run.drive == data::Drive::torque                ? fmt::format("torque{}_Nm", k + 1)
                       : run.drive == data::Drive::current && width == 1 ? "current_A"
                                                                         : fmt::format("current{}_A", k + 1));
      cells_.emplace_back([&run, k](std::size_t i) { return run.inputs[i][k]; });
    }
  }
  void write(std::ostream& out, std::size_t rows) const {
    CsvWriter csv(out, names_);
    std::vector<double> row(cells_.size());
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t k = 0; k < row.size(); ++k) row[k] = twelve_digits(cells_[k](i));
      csv.row(row);
    }
  }

 private:
  std::vector<std::string> names_;
  std::vector<std::function<double(std::size_t)>> cells_;
};

}  // namespace

Json dataset_json(const std::string& name, const std::string& actuator, std::span<const RunWithRole> runs) {
  return Json::object({{"format", "measured-data/1"},
                       {"name", name},
                       {"actuator", actuator},
                       {"runs", Json::list(runs, dataset_run_json)}});
}

void write_run(std::ostream& out, const data::Run& run) {
  Columns columns;
  columns.add_if_any("time_s", run.times);
  columns.add_if_any("angle_deg", run.angles);
  if (!run.has_input_clock()) columns.add_inputs(run);
  columns.add_if_any("opening_deg", run.openings);
  columns.add_if_any("height_mm", run.heights);
  for (const data::Channel& channel : run.channels) columns.add(channel.name, channel.values);
  columns.write(out, run.samples());
}

std::optional<std::string> input_file_name(const data::Run& run) {
  if (!run.has_input_clock()) return std::nullopt;
  return input_file_name(run.name);
}

std::string input_file_name(const std::string& run) {
  return run.substr(0, run.rfind(".csv")) + "_input.csv";
}

void write_input(std::ostream& out, const data::Run& run) {
  Columns columns;
  columns.add("time_s", run.input_times);
  columns.add_inputs(run);
  columns.write(out, run.inputs.size());
}

}  // namespace coilwright::formats
