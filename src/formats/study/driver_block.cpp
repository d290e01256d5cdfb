#include "formats/study/system_block.hpp"

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/systems/driver_quantities.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using systems::DriverTask;

void require_one_current(const actuator::Design& design) {
  if (!has_one_current(design))
    throw std::invalid_argument(
        "needs an actuator whose coils have one current: those with shares of it have drivers "
        "of their own");
}

}  // namespace

SystemBlock read_driver_block(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    const auto task = read_rows(in, driver_rows(), DriverTask{});
    std::vector<simulation::ResultQuantity> quantities =
        systems::driver_quantities(task_by("driver", driver_rows(), task));
    const simulation::QuantityTable table(quantities);
    return SystemBlock{.quantities = std::move(quantities),
                       .variables = variables_of("driver", driver_rows(), task),
                       .require_suitable = require_one_current,
                       .driver = sizing::StudyDriver{.duty = table.at("driver_duty"),
                                                     .ripple_heat = table.at("driver_ripple_heat_pct"),
                                                     .thermal_load = table.at("driver_thermal_load"),
                                                     .peak_over_limit = table.at("driver_peak_over_limit")}};
  });
}

}  // namespace coilwright::formats
