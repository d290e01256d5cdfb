#include "sizing/study/early_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/current_limit.hpp"
#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/actuator/design/dimensions.hpp"
#include "coilwright/actuator/design/segments.hpp"
#include "coilwright/winding/copper.hpp"

namespace coilwright::sizing {
namespace {

// A limit is broken early by more than what two ways to compute the same number may differ by.
constexpr double rounding = 1e-9;

// What is known of a design before it is simulated.
struct EarlyDesign {
  const actuator::Design& design;
  const actuator::Supply& supply;
  double current;  // of the operating point, without sign; A
  actuator::Dimensions size;
  double resistance;          // of one coil at 20 degC; ohm
  double most, sum, squares;  // of the magnitudes of the coils' shares of that current

  // Of all coils with their supply, per current of the operating point, at a resistance; ohm
  [[nodiscard]] double circuit(double ohm) const {
    const bool series = supply.wiring == actuator::Wiring::series;
    return series ? squares * ohm + supply.resistance : most * ohm + sum * supply.resistance;
  }
};

// A quantity that follows from these and the resistance of a coil, at 20 degC or hot.
struct EarlyQuantity {
  std::string_view name;
  double (*value)(const EarlyDesign& at, double ohm);
  bool hot = false;
};

constexpr EarlyQuantity early_quantities[] = {
    {"mass_g",
     [](const EarlyDesign& at, double) {
       double sum = 0.0;
       for (const actuator::Segment& segment : actuator::segments(at.design, at.size)) sum += segment.mass;
       return sum * 1e3;
     }},
    {"width_mm", [](const EarlyDesign& at, double) { return at.size.width * 1e3; }},
    {"height_mm", [](const EarlyDesign& at, double) { return at.size.height * 1e3; }},
    {"effective_length_mm", [](const EarlyDesign& at, double) { return at.size.effective_length * 1e3; }},
    {"coil_outer_radius_mm", [](const EarlyDesign& at, double) { return at.size.coil_outer_radius * 1e3; }},
    {"coil_length_mm", [](const EarlyDesign& at, double) { return at.size.coil_length * 1e3; }},
    {"current_over_limit",
     [](const EarlyDesign& at, double) { return at.current * at.most / actuator::current_limit(at.design); }},
    {"coil_resistance_Ohm", [](const EarlyDesign&, double ohm) { return ohm; }},
    {"voltage_cold_V", [](const EarlyDesign& at, double ohm) { return at.current * at.most * ohm; }},
    {"power_cold_W", [](const EarlyDesign& at, double ohm) { return at.current * at.current * at.squares * ohm; }},
    {"supply_voltage_cold_V", [](const EarlyDesign& at, double ohm) { return at.current * at.circuit(ohm); }},
    {"coil_resistance_hot_Ohm", [](const EarlyDesign&, double ohm) { return ohm; }, true},
    {"voltage_V", [](const EarlyDesign& at, double ohm) { return at.current * at.most * ohm; }, true},
    {"power_W", [](const EarlyDesign& at, double ohm) { return at.current * at.current * at.squares * ohm; }, true},
    {"supply_voltage_V", [](const EarlyDesign& at, double ohm) { return at.current * at.circuit(ohm); }, true},
};

struct EarlyLimit {
  EarlyQuantity quantity;
  Limit limit;
};

// The largest temperature of a coil's mean that a limit of the study allows; degC, infinite without one.
double hottest_allowed(const Study& study, const actuator::Design& design) {
  double hottest = std::numeric_limits<double>::infinity();
  for (const Limit& limit : study.limits) {
    if (limit.side != Limit::Side::at_most) continue;
    const std::string_view name = limit.quantity.name;
    if (name == "thermal_load" && limit.value <= 1.0) hottest = std::min(hottest, design.surroundings.coil_limit);
    if (name == "coil_temperature_degC" || name == "coil_hot_spot_degC") hottest = std::min(hottest, limit.value);
  }
  return hottest;
}

double at_temperature(double resistance, double temperature) {
  return resistance * (1.0 + winding::copper_temperature_coefficient * (temperature - 20.0));
}

EarlyDesign known_of(const actuator::Design& design, const actuator::Supply& supply, double current) {
  EarlyDesign out{.design = design,
                  .supply = supply,
                  .current = std::abs(current),
                  .size = actuator::dimensions(design),
                  .resistance = design.calibration.coil_resistance * actuator::winding_of(design).resistance(20.0),
                  .most = 0.0,
                  .sum = 0.0,
                  .squares = 0.0};
  for (const double share : actuator::current_shares(design)) {
    out.most = std::max(out.most, std::abs(share));
    out.sum += std::abs(share);
    out.squares += share * share;
  }
  return out;
}

bool breaks(const EarlyLimit& early, const EarlyDesign& at, double hottest) {
  const auto [quantity, limit] = early;
  const bool at_most = limit.side == Limit::Side::at_most;
  double ohm = at.resistance;
  if (quantity.hot) ohm = at_temperature(ohm, at_most ? at.design.surroundings.ambient : hottest);
  return margin(limit, quantity.value(at, ohm)) < -rounding * scale_of(limit);
}

}  // namespace

BreaksEarlyLimit early_limits(const Study& study) {
  std::vector<EarlyLimit> early;
  for (const Limit& limit : study.limits) {
    const simulation::ResultQuantity* standard = simulation::standard_quantities().find(limit.quantity.name);
    if (standard == nullptr || standard->meaning != limit.quantity.meaning) continue;  // another, of the same name
    const auto* row = std::ranges::find(early_quantities, limit.quantity.name, &EarlyQuantity::name);
    if (row != std::end(early_quantities)) early.push_back({.quantity = *row, .limit = limit});
  }
  if (early.empty()) return {};
  return [early = std::move(early), study](const actuator::Design& design, double current) {
    if (!actuator::construction_faults(design).empty()) return false;
    const EarlyDesign at = known_of(design, study.operating.supply, current);
    const double hottest = hottest_allowed(study, design);
    return std::ranges::any_of(early, [&](const EarlyLimit& each) { return breaks(each, at, hottest); });
  };
}

}  // namespace coilwright::sizing
