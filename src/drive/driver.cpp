#include "coilwright/drive/driver.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "drive/require.hpp"

namespace coilwright::drive {

Driver driver_of(const HBridge& bridge) {
  require_positive("supply_voltage", bridge.supply_voltage);
  require_not_negative("supply_resistance", bridge.supply_resistance);
  require_not_negative("high_resistance", bridge.high_resistance);
  require_not_negative("low_resistance", bridge.low_resistance);
  require_not_negative("diode_voltage", bridge.diode_voltage);
  require_not_negative("dead_time", bridge.dead_time);
  require_not_negative("ratings.lowest_voltage", bridge.ratings.lowest_voltage);
  require_positive("ratings.highest_voltage", bridge.ratings.highest_voltage);
  require_positive("ratings.peak_current", bridge.ratings.peak_current);
  if (bridge.ratings.lowest_voltage >= bridge.ratings.highest_voltage)
    throw std::invalid_argument(fmt::format("ratings.lowest_voltage must be below the highest, {} V; got {} V",
                                            bridge.ratings.highest_voltage, bridge.ratings.lowest_voltage));
  const Path shorted{.resistance = 2.0 * bridge.low_resistance};
  // With all switches off the current flows up through the diode of one low and one high switch.
  const Path returned{.source = -bridge.supply_voltage,
                      .diodes = 2.0 * bridge.diode_voltage,
                      .supply_resistance = bridge.supply_resistance,
                      .one_way = true};
  // Of a slow decay only one half switches: its diode and the other half's low switch carry the current meanwhile.
  const Path half{.diodes = bridge.diode_voltage, .resistance = bridge.low_resistance, .one_way = true};
  const bool slow = bridge.decay == Decay::slow;
  Driver driver{.on = {.source = bridge.supply_voltage,
                       .resistance = bridge.high_resistance + bridge.low_resistance,
                       .supply_resistance = bridge.supply_resistance},
                .dead = slow ? half : returned,
                .off = slow ? shorted : returned,
                .chop = shorted,
                .dead_time = bridge.dead_time};
  if (bridge.trip) {
    require_positive("trip", *bridge.trip);
    require_positive("limit_off_time", bridge.limit_off_time);
    require_not_negative("limit_blanking", bridge.limit_blanking);
    driver.limit = {.trip = *bridge.trip, .off_time = bridge.limit_off_time, .blanking = bridge.limit_blanking};
  }
  return driver;
}

Driver driver_of(const CellSwitch& cell) {
  require_positive("emf", cell.emf);
  require_not_negative("resistance", cell.resistance);
  require_not_negative("switch_resistance", cell.switch_resistance);
  require_not_negative("diode_voltage", cell.diode_voltage);
  const Path freewheeling{.diodes = cell.diode_voltage, .one_way = true};
  return {.on = {.source = cell.emf, .resistance = cell.switch_resistance, .supply_resistance = cell.resistance},
          .dead = freewheeling,
          .off = freewheeling,
          .chop = freewheeling};
}

double run_time(double capacity, double mean_current) {
  require_positive("capacity", capacity);
  require_not_negative("mean_current", mean_current);
  return mean_current == 0.0 ? std::numeric_limits<double>::infinity() : capacity / mean_current;
}

}  // namespace coilwright::drive
