#include "coilwright/formats/systems/drive_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using text::Json;
using text::number_or_null;

Json to_json(const drive::SteadyCurrent& current) {
  return Json::object({Json::quantity("mean_A", current.mean), Json::quantity("rms_A", current.rms),
                       Json::quantity("peak_A", current.peak), Json::quantity("valley_A", current.valley),
                       Json::quantity("ripple_A", current.ripple())});
}

Json to_json(const drive::DrivePowers& powers, double heat_by_mean) {
  return Json::object({Json::quantity("supply_W", powers.source), Json::quantity("coils_W", powers.coils),
                       Json::quantity("coils_by_mean_current_W", heat_by_mean),
                       Json::quantity("switches_W", powers.switches), Json::quantity("diodes_W", powers.diodes),
                       Json::quantity("inside_supply_W", powers.supply)});
}

Json to_json(const systems::WarmUpSample& sample) {
  return Json::object({Json::quantity("time_s", sample.time),
                       {"coil_temperature_degC", sample.coil_temperatures.maxCoeff()},
                       {"coil_hot_spot_degC", sample.coil_hot_spot},
                       {"magnet_temperature_degC", sample.magnet_temperature},
                       Json::quantity("circuit_resistance_Ohm", sample.resistance),
                       Json::quantity("mean_current_A", sample.mean),
                       Json::quantity("rms_current_A", sample.rms),
                       Json::quantity("supply_mean_A", sample.supply_mean),
                       Json::quantity("heat_W", sample.heat)});
}

Json to_json(const systems::PassedLimit& limit) {
  return Json::object({Json::quantity("time_s", limit.time),
                       {"part", limit.kind == thermal::NodeKind::coil ? "coil" : "magnet"},
                       {"number", limit.number},
                       {"limit_degC", limit.limit}});
}

}  // namespace

Json to_json(const systems::DrivenActuator& driven) {
  const drive::Circuit& circuit = driven.bank.circuit;
  Json out = Json::object({{"duty", driven.duty},
                           Json::quantity("supply_voltage_V", driven.supply_voltage),
                           Json::quantity("coil_temperature_degC", driven.coil_temperatures.maxCoeff()),
                           {"coil", to_json(driven.coil)},
                           {"driver", to_json(driven.driver)},
                           Json::quantity("supply_mean_A", driven.driver.supply_mean),
                           {"conduction", driven.driver.conduction},
                           {"discontinuous", driven.driver.is_discontinuous()},
                           {"limited", driven.driver.is_limited},
                           {"power", to_json(driven.driver.powers, driven.heat_by_mean)},
                           Json::quantity("circuit_resistance_Ohm", circuit.resistance),
                           Json::quantity("circuit_inductance_mH", circuit.inductance),
                           {"inductance_spread", driven.bank.inductance_spread},
                           Json::quantity("driver_resistance_Ohm", driven.driver_resistance),
                           Json::quantity("continuous_current_A", driven.continuous_current),
                           Json::quantity("straight_continuous_current_A", driven.straight_continuous_current),
                           Json::quantity("ampacity_A", driven.ampacity),
                           {"steady_hot_spot_degC", number_or_null(driven.steady_hot_spot)},
                           {"emf_per_rate_mVs_rad", driven.motion.emf_per_rate * 1e3},
                           Json::quantity("motional_damping_Nmms_rad", driven.motion.damping),
                           Json::quantity("all_joints_damping_Nmms_rad", driven.motion.joint_damping)});
  if (driven.run_time) out.set("run_time_s", number_or_null(driven.run_time));
  out.set("warnings", Json::list(driven.warnings, [](systems::DriveWarning each) { return name_of(each); }));
  return out;
}

Json to_json(const systems::MotionSummary& motion) {
  const systems::MotionEnergies& energies = motion.energies;
  return Json::object(
      {Json::quantity("duration_s", motion.duration), Json::quantity("start_bending_deg", motion.start_bending),
       Json::quantity("end_bending_deg", motion.end_bending), Json::quantity("most_bending_deg", motion.most_bending),
       Json::quantity("most_bending_time_s", motion.most_bending_time),
       Json::quantity("most_speed_deg_s", motion.most_speed),
       Json::quantity("most_speed_time_s", motion.most_speed_time), Json::quantity("supply_J", energies.source),
       Json::quantity("coils_J", energies.coils), Json::quantity("switches_J", energies.switches),
       Json::quantity("diodes_J", energies.diodes), Json::quantity("inside_supply_J", energies.supply),
       Json::quantity("work_J", energies.work), Json::quantity("field_J", energies.field)});
}

void write_motion(std::ostream& out, const std::vector<systems::MotionSample>& motion) {
  std::vector<std::string> columns{"time_s"};
  for (Eigen::Index j = 1; j <= motion.front().state.angles.size(); ++j)
    columns.push_back(fmt::format("theta{}_deg", j));
  columns.insert(columns.end(), {"bending_angle_deg", "bending_speed_deg_s"});
  for (Eigen::Index c = 1; c <= motion.front().currents.size(); ++c) columns.push_back(fmt::format("current{}_A", c));
  columns.insert(columns.end(), {"driver_current_A", "driver_mean_A", "supply_J", "coils_J", "work_J", "field_J"});
  text::CsvWriter csv(out, columns);
  const auto angle = [](double value) { return units::from_memory(value, "angle_deg"); };
  const systems::MotionSample* before = nullptr;
  for (const systems::MotionSample& sample : motion) {
    std::vector<text::CsvCell> row{sample.time};
    for (const double each : sample.state.angles) row.emplace_back(angle(each));
    row.emplace_back(angle(sample.state.angles.sum()));
    row.emplace_back(angle(sample.state.rates.sum()));
    for (const double each : sample.currents) row.emplace_back(each);
    row.emplace_back(sample.driver_current);
    row.push_back(before == nullptr ? text::CsvCell()
                                    : text::CsvCell((sample.charge - before->charge) / (sample.time - before->time)));
    for (const double each :
         {sample.energies.source, sample.energies.coils, sample.energies.work, sample.energies.field})
      row.emplace_back(each);
    csv.row(row);
    before = &sample;
  }
}

Json to_json(const systems::WarmUp& warm_up) {
  return Json::object({{"start", to_json(warm_up.samples.front())},
                       {"end", to_json(warm_up.samples.back())},
                       {"first_limit", warm_up.limit ? to_json(*warm_up.limit) : Json()},
                       {"melting_time_s", number_or_null(warm_up.melting_time)}});
}

void write_warm_up(std::ostream& out, const systems::WarmUp& warm_up) {
  std::vector<std::string> columns{"time_s"};
  for (Eigen::Index c = 1; c <= warm_up.samples.front().coil_temperatures.size(); ++c)
    columns.push_back(fmt::format("coil{}_degC", c));
  columns.insert(columns.end(), {"coil_hot_spot_degC", "magnet_temperature_degC", "circuit_resistance_Ohm",
                                 "mean_current_A", "rms_current_A", "supply_mean_A", "heat_W"});
  text::CsvWriter csv(out, columns);
  for (const systems::WarmUpSample& sample : warm_up.samples) {
    std::vector<text::CsvCell> row{sample.time};
    for (const double each : sample.coil_temperatures) row.emplace_back(each);
    for (const double each : {sample.coil_hot_spot, sample.magnet_temperature, sample.resistance, sample.mean,
                              sample.rms, sample.supply_mean, sample.heat})
      row.emplace_back(each);
    csv.row(row);
  }
}

}  // namespace coilwright::formats
