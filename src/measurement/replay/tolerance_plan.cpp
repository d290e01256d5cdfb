#include "coilwright/measurement/replay/tolerance_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "measurement/replay/declared_duplicates.hpp"
#include "measurement/replay/default_tolerances.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::AsBuilt;
using actuator::Hinge;
using actuator::TorqueCurveError;

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

std::vector<PlannedNumber> shape_of_curve(double deviation, const Differing& model) {
  std::vector<PlannedNumber> out;
  for (std::size_t order = 1; model.coils && order < force_curve_shares.size(); ++order)
    out.push_back(curve_number(order, deviation * force_curve_shares[order], model.force_curve));
  return out;
}

std::vector<PlannedNumber> gain_of_curve(double deviation, const Differing& model) {
  if (!model.coils) return {};
  return {curve_number(0, deviation, model.force_curve)};
}

std::vector<PlannedNumber> differing_stiffnesses(double deviation, const Differing& model) {
  if (!any_below_another(model.hinges, &Hinge::stiffness)) return {};
  return {ratio("joint_stiffness_ratio", &AsBuilt::joint_stiffness_ratio, deviation, model.declared)};
}

std::vector<PlannedNumber> differing_dampings(double deviation, const Differing& model) {
  if (!any_below_another(model.hinges, &Hinge::damping)) return {};
  return {ratio("joint_damping_ratio", &AsBuilt::joint_damping_ratio, deviation, model.declared)};
}

std::vector<PlannedNumber> closing_of_faces(double deviation, const Differing& model) {
  if (!has_faces(model.hinges)) return {};
  const double touch = closing_angle(model.hinges);
  PlannedNumber number{
      .name = "face_closing_deg", .deviation = deviation, .declared = touch + model.declared.face_closing_shift};
  number.difference = AsBuiltNumber{.member = &AsBuilt::face_closing_shift, .from = touch};
  return {std::move(number)};
}

// A difference from what the file says that has no number there.
struct NamedDifference {
  std::string_view name;
  // The numbers behind it, `deviation` in the unit of the name; none where the model cannot differ so, and then the
  // actuator has `lacking`.
  std::vector<PlannedNumber> (*numbers)(double deviation, const Differing& model);
  std::string_view lacking;
};

constexpr std::array differences = {
    NamedDifference{"force_curve", shape_of_curve, "no coil beside a magnet"},
    NamedDifference{force_gain_name, gain_of_curve, "no coil beside a magnet"},
    NamedDifference{"joint_stiffness_ratio", differing_stiffnesses, "no two joints to differ in it"},
    NamedDifference{"joint_damping_ratio", differing_dampings, "no two joints to differ in it"},
    NamedDifference{"face_closing_deg", closing_of_faces, "no faces that touch"}};

// Those of numbers that all joints share, which stand in the file.
constexpr std::array<std::string_view, 2> of_all_joints = {"joint_stiffness", "joint_damping"};

// Nothing where the name is of a number that stands in the file.
const NamedDifference* difference_called(std::string_view name) {
  const auto* const found = std::ranges::find(differences, name, &NamedDifference::name);
  return found == differences.end() ? nullptr : found;
}

class Planner {
 public:
  Planner(std::span<const std::string> calibrated, const Tolerances& said, Differing model)
      : said_(said), model_(std::move(model)) {
    for (const std::string& name : calibrated) add({.name = name, .by = MovedBy::calibrate});
  }

  TolerancePlan plan(const std::vector<DefaultTolerance>& defaults, const std::vector<std::string>& exact) && {
    std::vector<PlannedNumber> differ;
    for (const NamedTolerance& named : said_.named) take(named, differ);
    if (said_.others_exact) {
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
  void add(PlannedNumber number) {
    places_.emplace(number.name, plan_.numbers.size());
    plan_.numbers.push_back(std::move(number));
  }

  void take(const NamedTolerance& named, std::vector<PlannedNumber>& differ) {
    if (const auto same = places_.find(named.name); same != places_.end()) {
      if (named.deviation == 0.0)
        throw ToleranceFault(named.name, "must be > 0, because the number is calibrated", "0");
      plan_.numbers[same->second].deviation = named.deviation;
      return;
    }
    const NamedDifference* difference = difference_called(named.name);
    if (difference == nullptr) {
      // One that is exact is looked up all the same, and then left alone.
      add({.name = named.name,
           .by = MovedBy::tolerances,
           .deviation = named.deviation,
           .effect = effect_of(named.name)});
    } else {
      std::vector<PlannedNumber> numbers = difference->numbers(named.deviation, model_);
      if (numbers.empty())
        throw ToleranceFault(named.name, fmt::format("must not be there: the actuator has {}", difference->lacking));
      for (PlannedNumber& number : numbers) {
        number.by = MovedBy::tolerances;
        if (named.deviation > 0.0) differ.push_back(std::move(number));
      }
    }
    if (named.deviation == 0.0) plan_.held_exact.push_back(named.name);
  }

  void take(const DefaultTolerance& each, std::vector<PlannedNumber>& differ) {
    const auto names_it = [&](const std::string& name) {
      return places_.contains(name) || std::ranges::count(said_.named, name, &NamedTolerance::name) > 0;
    };
    if (names_it(each.name) || std::ranges::any_of(each.instead_of, names_it)) return;
    const NamedDifference* difference = difference_called(each.name);
    if (difference == nullptr) {
      add({.name = each.name, .by = MovedBy::defaults, .share = each.deviation, .effect = effect_of(each.name)});
      return;
    }
    for (PlannedNumber& number : difference->numbers(each.deviation, model_)) {
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

  const Tolerances& said_;
  Differing model_;
  TolerancePlan plan_;
  std::map<std::string, std::size_t> places_;  // of names in the plan's numbers
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

}  // namespace

std::vector<std::string_view> tolerance_names() {
  std::vector<std::string_view> out;
  for (const NamedDifference& each : differences) out.push_back(each.name);
  out.insert(out.end(), of_all_joints.begin(), of_all_joints.end());
  return out;
}

TolerancePlan tolerance_plan(std::span<const std::string> calibrated, const Tolerances& said,
                             const actuator::Design& design, const actuator::Measured& measured,
                             const actuator::ModelSpec& drawn) {
  const AsBuilt& declared = design.as_built;
  return Planner(calibrated, said,
                 {.hinges = drawn.hinges,
                  .coils = true,
                  .declared = declared,
                  .force_curve = range_of(declared.force_curve, {})})
      .plan(default_tolerances(measured), exact_by_default_of_design());
}

TolerancePlan tolerance_plan(std::span<const std::string> calibrated, const Tolerances& said,
                             const actuator::LumpedModel& model) {
  return Planner(calibrated, said,
                 {.hinges = model.hinges,
                  .coils = !model.pairs.empty(),
                  .declared = model.as_built,
                  .force_curve = range_of(model.as_built.force_curve, model.pairs)})
      .plan(default_tolerances(model), exact_by_default_of_lumped_model());
}

TolerancePlan without_duplicates(TolerancePlan plan, const DeclaredModel& model) {
  const auto first = std::ranges::find(model.calibration, false, &CalibrationParameter::calibrated);
  std::set<std::string> left_out;
  for (const auto& [number, alike] :
       duplicate_numbers(model, static_cast<std::size_t>(first - model.calibration.begin()))) {
    const CalibrationParameter& parameter = model.calibration[number];
    if (parameter.tolerance->named) continue;
    left_out.insert(parameter.key);
    plan.held_exact.push_back(
        alike ? fmt::format("{}, which acts as {} does", parameter.key, model.calibration[*alike].key)
              : fmt::format("{}, which moves nothing", parameter.key));
  }
  std::erase_if(plan.numbers, [&](const PlannedNumber& number) {
    return number.by == MovedBy::defaults && left_out.contains(number.name);
  });
  return plan;
}

}  // namespace coilwright::measurement::replay
