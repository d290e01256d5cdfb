#include "formats/study/system_block.hpp"

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/systems/driver_quantities.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using systems::DriverTask;
using DriverNumber = BlockNumber<DriverTask>;

constexpr double usual_cell_switch = 0.05;  // ohm, as `drive` takes it

std::vector<DriverNumber> driver_numbers() {
  using enum DriverNumber::Kind;
  return {
      block_number<DriverTask>(
          "voltage_V", up_to(1e3), [](auto& task) -> auto& { return task.voltage; }, required),
      block_number<DriverTask>(
          "resistance_Ohm", Rule::between(0.0, 1e3), [](auto& task) -> auto& { return task.resistance; }),
      block_number<DriverTask>(
          "switch_resistance_Ohm", Rule::between(0.0, 1e3), [](auto& task) -> auto& { return task.switch_resistance; }),
      block_number<DriverTask>(
          "frequency_Hz", Rule::between(0.1, 1e6), [](auto& task) -> auto& { return task.frequency; }),
      block_number<DriverTask>(
          "most_current_A", up_to(1e3), [](auto& task) -> auto& { return task.most_current; })};
}

void require_one_current(const actuator::Design& design) {
  if (!has_one_current(design))
    throw std::invalid_argument(
        "needs an actuator whose coils have one current: those with shares of it have drivers "
        "of their own");
}

}  // namespace

SystemBlock read_driver_block(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    const auto kind = in.choice<DriverTask::Kind>(
        "kind", {{"h_bridge", DriverTask::Kind::h_bridge}, {"cell", DriverTask::Kind::cell}});
    DriverTask task{.kind = kind};
    if (kind == DriverTask::Kind::cell) task.switch_resistance = usual_cell_switch;
    const std::vector<DriverNumber> all = driver_numbers();
    read_numbers<DriverTask>(in, all, task);
    std::vector<simulation::ResultQuantity> quantities = systems::driver_quantities(task_by("driver", all, task));
    const simulation::QuantityTable table(quantities);
    return SystemBlock{.quantities = std::move(quantities),
                       .variables = variables_of<DriverTask>("driver", all, task),
                       .require_suitable = require_one_current,
                       .driver = sizing::StudyDriver{.duty = table.at("driver_duty"),
                                                     .ripple_heat = table.at("driver_ripple_heat_pct"),
                                                     .thermal_load = table.at("driver_thermal_load"),
                                                     .peak_over_limit = table.at("driver_peak_over_limit")}};
  });
}

}  // namespace coilwright::formats
