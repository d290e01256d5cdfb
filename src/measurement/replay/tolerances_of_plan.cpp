#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "coilwright/measurement/replay/tolerance_plan.hpp"
#include "coilwright/units/angle.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::measurement::replay {
namespace {

// One standard deviation of a number that cannot be negative: with more than the number itself nothing is declared, and
// a fit takes the number wherever it helps.
void require_plausible(const CalibrationParameter& parameter, const PlannedNumber& number) {
  if (!number.deviation || parameter.declared <= 0.0 || parameter.lower < 0.0) return;
  const double declared = units::from_memory(parameter.declared, units::key_with_unit(parameter.key));
  if (*number.deviation <= declared) return;
  throw ToleranceFault(number.name,
                       fmt::format("must be at most the declared number, {:.6g}; for a number of which nothing is "
                                   "known, \"calibrate\" it",
                                   declared),
                       fmt::format("{:.6g}", *number.deviation));
}

// The parameter of a difference, without its tolerance.
CalibrationParameter difference_parameter(const PlannedNumber& number) {
  CalibrationParameter out{.key = number.name, .declared = number.declared};
  if (const auto* curve = std::get_if<ForceCurveNumber>(&*number.difference)) {
    // The force of a coil keeps its sense.
    out.lower = curve->order == 0 ? -0.9 : -0.3;
    out.upper = curve->order == 0 ? 9.0 : 0.3;
  } else if (number.name == "face_closing_deg") {
    out.lower = number.declared - 45.0 * units::degree;
    out.upper = number.declared + 45.0 * units::degree;
  } else {
    out.lower = -1.9;  // beyond 2, a joint has less than nothing
    out.upper = 1.9;
  }
  return out;
}

// Gives `parameter`, found for `number`, its tolerance.
void set_tolerance(CalibrationParameter& parameter, const PlannedNumber& number) {
  require_plausible(parameter, number);
  parameter.calibrated = number.by == MovedBy::calibrate;
  parameter.effect = number.effect;
  const double deviation = number.deviation ? units::to_memory(*number.deviation, units::key_with_unit(parameter.key))
                                            : number.share * std::abs(parameter.declared);
  if (deviation <= 0.0) return;
  parameter.tolerance = {.deviation = deviation, .named = number.by != MovedBy::defaults};
  parameter.scale = deviation;
  const auto* curve = number.difference ? std::get_if<ForceCurveNumber>(&*number.difference) : nullptr;
  if (curve != nullptr && curve->order > 0) parameter.function = "force_curve";
  // Faces that the actuator does not have: they touch nowhere in its motion.
  if (number.name == "face_closing_deg") parameter.other_start = parameter.lower;
}

// Both kinds of declared models have their numbers from here.
template <class Target>
std::vector<CalibratableNumber<Target>> numbers_of_plan(std::vector<CalibratableNumber<Target>> in_file,
                                                        const TolerancePlan& plan) {
  std::vector<CalibratableNumber<Target>> out;
  for (std::size_t i = 0; i < plan.numbers.size(); ++i) {
    const PlannedNumber& number = plan.numbers[i];
    CalibratableNumber<Target> each =
        number.difference
            ? CalibratableNumber<Target>{.parameter = difference_parameter(number),
                                         .target = std::visit([](const auto& target) { return Target(target); },
                                                              *number.difference)}
            : std::move(in_file[i]);
    set_tolerance(each.parameter, number);
    if (each.parameter.calibrated || each.parameter.tolerance) out.push_back(std::move(each));
  }
  return out;
}

}  // namespace

std::vector<CalibratableNumber<DesignTarget>> with_tolerances(std::vector<CalibratableNumber<DesignTarget>> in_file,
                                                              const TolerancePlan& plan) {
  return numbers_of_plan(std::move(in_file), plan);
}

std::vector<CalibratableNumber<LumpedTarget>> with_tolerances(std::vector<CalibratableNumber<LumpedTarget>> in_file,
                                                              const TolerancePlan& plan) {
  return numbers_of_plan(std::move(in_file), plan);
}

}  // namespace coilwright::measurement::replay
