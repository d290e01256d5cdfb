#include "coilwright/winding/copper.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace coilwright::winding {

double copper_resistance_ratio(double temperature) {
  const double ratio = 1.0 + copper_temperature_coefficient * (temperature - 20.0);
  if (!(std::isfinite(temperature) && ratio > 0.0)) {
    throw std::invalid_argument(
        fmt::format("temperature: must be finite and above {:.1f} degC, where the linear law ends; got {}",
                    20.0 - 1.0 / copper_temperature_coefficient, temperature));
  }
  return ratio;
}

}  // namespace coilwright::winding
