#include "formats/data/run_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "coilwright/text/one_line.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/layout_format.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::ChannelKind;
using measurement::data::Drive;
using measurement::data::RunKind;

constexpr std::string_view advice =
    R"(; what is to be left alone is named in "ignore" in dataset.json, by name or position ("#1"))";

void ask_numbered(CsvHeader& header, RunColumns& columns, const std::string& quantity, const std::string& unit,
                  ChannelKind kind) {
  const std::size_t count = header.numbered(quantity + "#" + unit);
  for (std::size_t number = 1; number <= count; ++number)
    columns.measured.push_back(
        {.quantity = quantity + std::to_string(number), .kind = kind, .joint = static_cast<int>(number) - 1});
}

void ask_motion(CsvHeader& header, RunColumns& columns) {
  columns.times = true;
  header.allow_gaps();
  header.require("time_s");
  if (header.find("bending_angle_deg"))
    columns.measured.push_back({.quantity = "bending_angle", .kind = ChannelKind::bending_angle});
  ask_numbered(header, columns, "theta", "_deg", ChannelKind::joint_angle);
  ask_numbered(header, columns, "omega", "_rad_s", ChannelKind::joint_rate);
}

void require_measured(const CsvHeader& header, const RunColumns& columns) {
  if (columns.measured.empty())
    throw header.error("must have a measured column: bending_angle_deg, theta1_deg.. or omega1_rad_s..");
}

RunColumns ask_transient(CsvHeader& header, const RunEntry& entry) {
  RunColumns columns;
  ask_motion(header, columns);
  if (entry.input_file) {
    header.finish(advice);
  } else if (entry.rig.coil == measurement::data::CoilWiring::driven) {
    columns.input = ask_for_input(header, advice);
  } else {
    columns.input = find_input(header);
    header.finish(advice);
  }
  require_measured(header, columns);
  return columns;
}

RunColumns ask_still(CsvHeader& header) {
  RunColumns columns;
  ask_motion(header, columns);
  for (const char* name : {"current_A", "current#_A", "voltage_V", "torque#_Nm"}) header.ignore(name);
  header.finish(advice);
  require_measured(header, columns);
  return columns;
}

RunColumns ask_bench(CsvHeader& header, RunKind kind) {
  RunColumns columns;
  columns.times = kind == RunKind::temperature;
  columns.angles = kind == RunKind::static_torque || kind == RunKind::joint_stiffness;
  if (columns.times) header.require("time_s");
  if (columns.angles) header.require("angle_deg");
  if (kind != RunKind::joint_stiffness) {
    header.require("current_A");
    columns.input =
        InputColumns{.drive = Drive::current, .addressing = simulation::Addressing::common, .quantities = {"current"}};
  }
  if (columns.angles) {
    header.require("torque_Nmm");
    columns.measured.push_back({.quantity = "torque", .kind = ChannelKind::torque});
  } else if (columns.times) {
    header.require("temperature_degC");
    columns.measured.push_back({.quantity = "temperature", .kind = ChannelKind::temperature});
  } else {
    header.require("force_N");
    columns.measured.push_back({.quantity = "force", .kind = ChannelKind::force});
    columns.openings = header.find("opening_deg");
    columns.heights = header.find("height_mm");
  }
  header.finish(advice);
  return columns;
}

RunColumns ask(CsvHeader& header, const RunEntry& entry) {
  RunColumns columns = entry.kind == RunKind::transient ? ask_transient(header, entry)
                       : entry.kind == RunKind::still   ? ask_still(header)
                                                        : ask_bench(header, entry.kind);
  columns.names = header.names();
  return columns;
}

void require_fit(const CsvHeader& header, const FileLayout& layout, const std::set<std::string>& used) {
  for (const std::string& source : header.absent()) {
    const auto key = layout.must_fit.find(source);
    if (key == layout.must_fit.end() || used.contains(source)) continue;
    if (source == key->second)
      throw header.error(
          "has a column of time, and the run a \"sampling_rate_Hz\": one of the two must go (\"ignore\" "
          "leaves a column alone)");
    std::vector<std::string> there;
    for (const std::string& name : header.form().names) there.push_back(name.empty() ? "(none)" : in_quotes(name));
    throw header.error(source, fmt::format("is not there, and the run's \"{}\" names it; the columns are {}",
                                           key->second, fmt::join(there, ", ")));
  }
}

}  // namespace

std::set<std::string> used_of(const CsvLayout& layout, const CsvHeader& header) {
  std::set<std::string> used(layout.ignore.begin(), layout.ignore.end());
  for (const CsvColumn& each : layout.columns) used.insert(each.source);
  for (const CsvMarkers& each : layout.markers) {
    std::vector<CsvPoint> points(each.line.begin(), each.line.end());
    if (each.against) points.insert(points.end(), each.against->begin(), each.against->end());
    for (const CsvPoint& point : points)
      if (const auto* sources = std::get_if<std::array<std::string, 2>>(&point))
        used.insert(sources->begin(), sources->end());
  }
  if (layout.sampling_rate) used.insert("sampling_rate_Hz");
  for (const std::string& absent : header.absent()) used.erase(absent);
  return used;
}

RunColumns ask_for_run(CsvHeader& header, const RunEntry& entry) {
  if (entry.input_file) {
    // A column that is an input by its name is told what it is, before it counts as unknown.
    CsvHeader inputs = header;
    if (find_input(inputs))
      throw header.error("must have no input column, because the run's \"input_file\" has the input");
  }
  // With a second file under the same layout, that one decides what fits neither.
  if (!entry.input_file || entry.input_layout) require_fit(header, entry.layout, {});
  return with_layout_advice(header, entry, entry.layout, [&](CsvHeader& each) { return ask(each, entry); });
}

InputColumns ask_for_run_input(CsvHeader& header, const RunEntry& entry, const RunColumns& measured,
                               const std::set<std::string>& used) {
  // A copy where it is the run's: advice is about the input file's own.
  const FileLayout layout = entry.input_layout ? *entry.input_layout : entry.layout;
  require_fit(header, layout, entry.input_layout ? std::set<std::string>{} : used);
  for (const std::string& name : header.names()) {
    if (units::quantity_of(name) == "time") continue;
    for (const std::string& other : measured.names)
      if (units::quantity_of(other) == units::quantity_of(name))
        throw header.error(name, "is in " + one_line(entry.name) + " too; a column may be in one of the two only");
  }
  return with_layout_advice(header, entry, layout, [&](CsvHeader& each) {
    each.require("time_s");
    return ask_for_input(each, advice);
  });
}

}  // namespace coilwright::formats
