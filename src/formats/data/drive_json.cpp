#include "coilwright/formats/data/drive_json.hpp"

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

// An SI value under a key that ends in its unit.
Json::Member in_unit(const char* key, double value) {
  return {key, units::from_memory(value, key)};
}

Json to_json(const drive::SteadyCurrent& current) {
  return Json::object({in_unit("mean_A", current.mean), in_unit("rms_A", current.rms), in_unit("peak_A", current.peak),
                       in_unit("valley_A", current.valley), in_unit("ripple_A", current.ripple())});
}

Json to_json(const drive::DrivePowers& powers, double heat_by_mean) {
  return Json::object({in_unit("supply_W", powers.source), in_unit("coils_W", powers.coils),
                       in_unit("coils_by_mean_current_W", heat_by_mean), in_unit("switches_W", powers.switches),
                       in_unit("diodes_W", powers.diodes), in_unit("inside_supply_W", powers.supply)});
}

Json number_or_null(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json to_json(const systems::WarmUpSample& sample) {
  return Json::object({in_unit("time_s", sample.time),
                       {"coil_temperature_degC", sample.coil_temperatures.maxCoeff()},
                       {"coil_hot_spot_degC", sample.coil_hot_spot},
                       {"magnet_temperature_degC", sample.magnet_temperature},
                       in_unit("circuit_resistance_Ohm", sample.resistance),
                       in_unit("mean_current_A", sample.mean),
                       in_unit("rms_current_A", sample.rms),
                       in_unit("supply_mean_A", sample.supply_mean),
                       in_unit("heat_W", sample.heat)});
}

Json to_json(const systems::PassedLimit& limit) {
  return Json::object({in_unit("time_s", limit.time),
                       {"part", limit.kind == thermal::NodeKind::coil ? "coil" : "magnet"},
                       {"number", limit.number},
                       {"limit_degC", limit.limit}});
}

}  // namespace

Json to_json(const systems::DrivenActuator& driven) {
  Json warnings = Json::array();
  for (const systems::DriveWarning warning : driven.warnings) warnings.add(std::string(name_of(warning)));
  const drive::Circuit& circuit = driven.bank.circuit;
  Json out = Json::object({{"duty", driven.duty},
                           in_unit("supply_voltage_V", driven.supply_voltage),
                           in_unit("coil_temperature_degC", driven.coil_temperatures.maxCoeff()),
                           {"coil", to_json(driven.coil)},
                           {"driver", to_json(driven.driver)},
                           in_unit("supply_mean_A", driven.driver.supply_mean),
                           {"conduction", driven.driver.conduction},
                           {"discontinuous", driven.driver.is_discontinuous()},
                           {"limited", driven.driver.is_limited},
                           {"power", to_json(driven.driver.powers, driven.heat_by_mean)},
                           in_unit("circuit_resistance_Ohm", circuit.resistance),
                           in_unit("circuit_inductance_mH", circuit.inductance),
                           {"inductance_spread", driven.bank.inductance_spread},
                           in_unit("driver_resistance_Ohm", driven.driver_resistance),
                           in_unit("continuous_current_A", driven.continuous_current),
                           in_unit("straight_continuous_current_A", driven.straight_continuous_current),
                           in_unit("ampacity_A", driven.ampacity),
                           {"steady_hot_spot_degC", number_or_null(driven.steady_hot_spot)},
                           {"emf_per_rate_mVs_rad", driven.motion.emf_per_rate * 1e3},
                           in_unit("motional_damping_Nmms_rad", driven.motion.damping),
                           in_unit("joint_damping_Nmms_rad", driven.motion.joint_damping)});
  if (driven.run_time) out.set("run_time_s", number_or_null(driven.run_time));
  out.set("warnings", std::move(warnings));
  return out;
}

Json to_json(const systems::MotionSummary& motion) {
  const systems::MotionEnergies& energies = motion.energies;
  return Json::object({in_unit("duration_s", motion.duration), in_unit("start_bending_deg", motion.start_bending),
                       in_unit("end_bending_deg", motion.end_bending), in_unit("most_bending_deg", motion.most_bending),
                       in_unit("most_bending_time_s", motion.most_bending_time),
                       in_unit("most_speed_deg_s", motion.most_speed),
                       in_unit("most_speed_time_s", motion.most_speed_time), in_unit("supply_J", energies.source),
                       in_unit("coils_J", energies.coils), in_unit("switches_J", energies.switches),
                       in_unit("diodes_J", energies.diodes), in_unit("inside_supply_J", energies.supply),
                       in_unit("work_J", energies.work), in_unit("field_J", energies.field)});
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
                       {"first_limit", warm_up.limit ? to_json(*warm_up.limit) : Json(nullptr)},
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
