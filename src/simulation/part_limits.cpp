#include "coilwright/simulation/part_limits.hpp"

#include <cmath>

namespace coilwright::simulation {

double PartLimit::margin() const noexcept {
  if (!value) return -1.0;
  const double distance = at_most ? limit - *value : *value - limit;
  return distance / (limit == 0.0 ? 1.0 : std::abs(limit));
}

std::vector<PartLimit> part_limits(const DesignView& design) {
  const auto value = [&](std::string_view name) { return standard_quantities().at(name).value(design); };
  std::vector<PartLimit> limits{
      {.quantity = "coil_hot_spot_degC",
       .value = value("coil_hot_spot_degC"),
       .limit = design.design.surroundings.coil_limit,
       .consequence = "the enamel of the wire fails"},
      {.quantity = "magnet_temperature_degC",
       .value = value("magnet_temperature_degC"),
       .limit = design.design.magnet.temperature_limit,
       .consequence = "the magnets lose magnetisation for good"},
      {.quantity = "current_over_limit",
       .value = value("current_over_limit"),
       .limit = 1.0,
       .consequence = "the wire carries more than its chassis-wiring ampacity; heat decides whether it may"},
  };
  if (design.design.magnet.grade != nullptr)
    limits.push_back({.quantity = "demagnetisation_margin",
                      .value = value("demagnetisation_margin"),
                      .limit = 0.0,
                      .at_most = false,
                      .consequence = "the magnets lose most of their magnetisation for good"});
  return limits;
}

std::vector<PartLimit> broken_part_limits(const DesignView& design) {
  std::vector<PartLimit> out = part_limits(design);
  std::erase_if(out, [](const PartLimit& limit) { return !limit.is_broken(); });
  return out;
}

}  // namespace coilwright::simulation
