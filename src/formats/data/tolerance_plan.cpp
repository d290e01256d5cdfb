#include "formats/data/tolerance_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "coilwright/formats/data/diagnosis_formatting.hpp"
#include "coilwright/text/json/json_pointer.hpp"
#include "coilwright/units/angle.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/default_tolerances.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::AsBuilt;
using actuator::Hinge;
using actuator::TorqueCurveError;
using measurement::replay::AsBuiltNumber;
using measurement::replay::CalibrationParameter;
using measurement::replay::ForceCurveNumber;

// What a model can differ in.
struct Differing {
  std::vector<Hinge> hinges;
  bool coils{};
  AsBuilt declared{};
  TorqueCurveError force_curve{};
};

bool any_below_another(const std::vector<Hinge>& hinges, double Hinge::*member) {
  return hinges.size() > 1 && std::ranges::any_of(hinges, [&](const Hinge& hinge) { return hinge.*member > 0.0; });
}

bool has_faces(const std::vector<Hinge>& hinges) {
  return std::ranges::any_of(hinges, [](const Hinge& hinge) { return hinge.contact.stiffness > 0.0; });
}

// The mean angle at which faces touch, without what is added to all of them, rad.
double closing_angle(const std::vector<Hinge>& hinges) {
  double sum = 0.0;
  int faces = 0;
  for (const Hinge& hinge : hinges) {
    if (hinge.contact.stiffness <= 0.0) continue;
    sum += hinge.contact.closing_angle;
    ++faces;
  }
  return sum / faces;
}

PlannedNumber ratio(std::string name, double AsBuilt::*member, double deviation, const AsBuilt& declared) {
  PlannedNumber number{.name = std::move(name), .deviation = deviation, .declared = declared.*member};
  number.difference = AsBuiltNumber{.member = member};
  if (member == &AsBuilt::joint_stiffness_ratio) number.effect = "joint_asymmetry";
  return number;
}

PlannedNumber curve_number(std::size_t order, double deviation, const TorqueCurveError& curve) {
  PlannedNumber number{
      .name = fmt::format("force_curve_{}", order), .deviation = deviation, .declared = curve.coefficients[order]};
  number.difference = ForceCurveNumber{.order = order};
  if (order == 0) number.effect = "force_gain";
  return number;
}

// The numbers behind the name of a difference; none where the model cannot differ so. `deviation` in the name's unit.
std::vector<PlannedNumber> differences(std::string_view name, double deviation, const Differing& model) {
  std::vector<PlannedNumber> out;
  if (name == "force_curve" && model.coils)
    for (std::size_t order = 1; order < force_curve_shares.size(); ++order)
      out.push_back(curve_number(order, deviation * force_curve_shares[order], model.force_curve));
  if (name == force_gain_name && model.coils) out.push_back(curve_number(0, deviation, model.force_curve));
  if (name == "joint_stiffness_ratio" && any_below_another(model.hinges, &Hinge::stiffness))
    out.push_back(ratio("joint_stiffness_ratio", &AsBuilt::joint_stiffness_ratio, deviation, model.declared));
  if (name == "joint_damping_ratio" && any_below_another(model.hinges, &Hinge::damping))
    out.push_back(ratio("joint_damping_ratio", &AsBuilt::joint_damping_ratio, deviation, model.declared));
  if (name == "face_closing_deg" && has_faces(model.hinges)) {
    const double touch = closing_angle(model.hinges);
    PlannedNumber number{
        .name = "face_closing_deg", .deviation = deviation, .declared = touch + model.declared.face_closing_shift};
    number.difference = AsBuiltNumber{.member = &AsBuilt::face_closing_shift, .from = touch};
    out.push_back(std::move(number));
  }
  return out;
}

InputError cannot_differ(const Calibrate& said, const NamedTolerance& named) {
  const std::string rule = named.name == "force_curve"        ? "no coil beside a magnet"
                           : named.name == "face_closing_deg" ? "no faces that touch"
                                                              : "no two joints to differ in it";
  return InputError({.file = said.file,
                     .place = std::string(said.tolerances_pointer) + pointer_step(named.name),
                     .rule = "must not be there: the actuator has " + rule});
}

// Whether the name is of a number that stands in the file, or of all joints.
bool in_file(std::string_view name) {
  return name.starts_with('/') || name == "joint_stiffness" || name == "joint_damping";
}

class Planner {
 public:
  Planner(const Calibrate& said, Differing model) : said_(said), model_(std::move(model)) {
    plan_.file = said.file;
    for (std::size_t i = 0; i < said.names.size(); ++i)
      plan_.numbers.push_back(
          {.name = said.names[i], .by = MovedBy::calibrate, .place = fmt::format("{}/{}", said.pointer, i)});
  }

  TolerancePlan plan(const std::vector<DefaultTolerance>& defaults, const std::vector<std::string>& exact) && {
    std::vector<PlannedNumber> differ;
    for (const NamedTolerance& named : said_.tolerances.named) take(named, differ);
    if (said_.tolerances.others_exact) {
      plan_.held_exact.emplace_back("all declared numbers that are not calibrated");
    } else {
      for (const DefaultTolerance& each : defaults) take(each, differ);
      plan_.held_exact.insert(plan_.held_exact.end(), exact.begin(), exact.end());
    }
    std::ranges::move(differ, std::back_inserter(plan_.numbers));
    for (const PlannedNumber& number : plan_.numbers)
      if (number.difference && std::holds_alternative<ForceCurveNumber>(*number.difference))
        plan_.force_curve = model_.force_curve;
    return std::move(plan_);
  }

 private:
  void take(const NamedTolerance& named, std::vector<PlannedNumber>& differ) {
    const std::string place = std::string(said_.tolerances_pointer) + pointer_step(named.name);
    const auto same = std::ranges::find(plan_.numbers, named.name, &PlannedNumber::name);
    if (same != plan_.numbers.end()) {
      if (named.deviation == 0.0)
        throw InputError({.file = said_.file,
                          .place = place,
                          .rule = "must be > 0, because the number is calibrated",
                          .value = "0"});
      same->deviation = named.deviation;
      same->tolerance_place = place;
      return;
    }
    if (in_file(named.name)) {
      // One that is exact is looked up all the same, and then left alone.
      plan_.numbers.push_back({.name = named.name,
                               .by = MovedBy::tolerances,
                               .place = place,
                               .tolerance_place = place,
                               .deviation = named.deviation,
                               .effect = effect_of(named.name)});
    } else {
      std::vector<PlannedNumber> numbers = differences(named.name, named.deviation, model_);
      if (numbers.empty()) throw cannot_differ(said_, named);
      for (PlannedNumber& number : numbers) {
        number.by = MovedBy::tolerances;
        number.place = place;
        if (named.deviation > 0.0) differ.push_back(std::move(number));
      }
    }
    if (named.deviation == 0.0) plan_.held_exact.push_back(named.name);
  }

  void take(const DefaultTolerance& each, std::vector<PlannedNumber>& differ) {
    const auto names_it = [&](const std::string& name) {
      return std::ranges::count(plan_.numbers, name, &PlannedNumber::name) > 0 ||
             std::ranges::count(said_.tolerances.named, name, &NamedTolerance::name) > 0;
    };
    if (names_it(each.name) || std::ranges::any_of(each.instead_of, names_it)) return;
    if (in_file(each.name)) {
      plan_.numbers.push_back(
          {.name = each.name, .by = MovedBy::defaults, .share = each.deviation, .effect = effect_of(each.name)});
      return;
    }
    for (PlannedNumber& number : differences(each.name, each.deviation, model_)) {
      number.by = MovedBy::defaults;
      differ.push_back(std::move(number));
    }
  }

  // The last link of a lumped model has the payload.
  [[nodiscard]] std::string_view effect_of(std::string_view name) const {
    if (name == fmt::format("/links/{}/mass_kg", model_.hinges.size() - 1)) return "added_mass";
    if (name.ends_with("/magnet/remanence_T")) return "force_gain";
    for (const auto& [number, effect] : effects_of_numbers)
      if (number == name) return effect;
    return "";
  }

  const Calibrate& said_;
  Differing model_;
  TolerancePlan plan_;
};

// Where the shape of a curve is told: of a table where it was measured, otherwise where a finger works.
TorqueCurveError range_of(const std::optional<TorqueCurveError>& declared,
                          const std::vector<actuator::LumpedPair>& pairs) {
  if (declared) return *declared;
  TorqueCurveError out{.lower = 0.0, .upper = widest_working_angle};
  for (const actuator::LumpedPair& pair : pairs)
    if (const auto* table = std::get_if<actuator::TorqueTable>(&pair.source))
      return {.lower = table->angles.front(), .upper = table->angles.back()};
  return out;
}

// One standard deviation of a number that cannot be negative: with more than the number itself nothing is declared, and
// a fit takes the number wherever it helps.
void require_plausible(const CalibrationParameter& parameter, const PlannedNumber& number, std::string_view file) {
  if (!number.deviation || parameter.declared <= 0.0 || parameter.lower < 0.0) return;
  const double declared = units::from_memory(parameter.declared, key_with_unit(parameter.key));
  if (*number.deviation <= declared) return;
  throw InputError({.file = std::string(file),
                    .place = number.tolerance_place,
                    .rule = fmt::format("must be at most the declared number, {:.6g}; for a number of which nothing is "
                                        "known, \"calibrate\" it",
                                        declared),
                    .value = fmt::format("{:.6g}", *number.deviation)});
}

}  // namespace

TolerancePlan tolerance_plan(const Calibrate& said, const DesignContent& content, const actuator::ModelSpec& drawn) {
  const AsBuilt& declared = content.design.as_built;
  return Planner(said, {.hinges = drawn.hinges,
                        .coils = true,
                        .declared = declared,
                        .force_curve = range_of(declared.force_curve, {})})
      .plan(default_tolerances(content), exact_by_default_of_design());
}

TolerancePlan tolerance_plan(const Calibrate& said, const actuator::LumpedModel& model) {
  return Planner(said, {.hinges = model.hinges,
                        .coils = !model.pairs.empty(),
                        .declared = model.as_built,
                        .force_curve = range_of(model.as_built.force_curve, model.pairs)})
      .plan(default_tolerances(model), exact_by_default_of_lumped_model());
}

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

void set_tolerance(CalibrationParameter& parameter, const PlannedNumber& number, std::string_view file) {
  require_plausible(parameter, number, file);
  parameter.calibrated = number.by == MovedBy::calibrate;
  parameter.effect = number.effect;
  const double deviation = number.deviation ? units::to_memory(*number.deviation, key_with_unit(parameter.key))
                                            : number.share * std::abs(parameter.declared);
  if (deviation <= 0.0) return;
  parameter.tolerance = {.deviation = deviation, .named = number.by != MovedBy::defaults};
  parameter.scale = deviation;
  const auto* curve = number.difference ? std::get_if<ForceCurveNumber>(&*number.difference) : nullptr;
  if (curve != nullptr && curve->order > 0) parameter.function = "force_curve";
  // Faces that the actuator does not have: they touch nowhere in its motion.
  if (number.name == "face_closing_deg") parameter.other_start = parameter.lower;
}

}  // namespace coilwright::formats
