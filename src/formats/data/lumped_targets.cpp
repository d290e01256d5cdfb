#include "formats/data/calibrate_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include "coilwright/measurement/replay/mean_of_joints.hpp"
#include "coilwright/text/json/json_pointer.hpp"
#include "formats/actuator/actuator_reader.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Hinge;
using actuator::LumpedModel;
using measurement::replay::CalibrationParameter;
using measurement::replay::GravityNumber;
using measurement::replay::LumpedNumber;
using measurement::replay::LumpedShare;
using measurement::replay::LumpedShares;
using measurement::replay::mean_of_joints;
using measurement::replay::MeanOfJoints;
using measurement::replay::PartNumber;
using measurement::replay::TableNumber;

// How large things are on the rig, for what is 0 in the file.
struct Sizes {
  double length{};     // m
  double inertia{};    // about the first joint when straight, kg m^2
  double stiffness{};  // of gravity, or of a swing of one second, N m/rad
  double damping{};    // a tenth of critical, N m s/rad
};

Sizes sizes_of(const LumpedModel& model) {
  Sizes sizes;
  double before = 0.0, gravity = 0.0;
  for (const mechanics::Link& link : model.links) {
    const double reach = before + std::abs(link.com_along);
    sizes.inertia += link.inertia + link.mass * (reach * reach + link.com_offset * link.com_offset);
    gravity += link.mass * model.gravity * reach;
    before += link.length;
  }
  constexpr double once_a_second = 2.0 * std::numbers::pi;
  if (sizes.inertia == 0.0) sizes.inertia = 1.0;
  sizes.length = before > 0.0 ? before : 0.1;
  sizes.stiffness = std::max(gravity, sizes.inertia * once_a_second * once_a_second);
  sizes.damping = 0.2 * std::sqrt(sizes.stiffness * sizes.inertia);
  return sizes;
}

// A change that is usual for a number that the file has as 0, SI.
double usual_change(std::string_view dimension, const Sizes& sizes) {
  if (dimension == "length") return 0.1 * sizes.length;
  if (dimension == "moment of inertia") return 0.1 * sizes.inertia;
  if (dimension == "angular stiffness") return sizes.stiffness;
  if (dimension == "angular damping") return sizes.damping;
  if (dimension == "torque") return 0.1 * sizes.stiffness;
  if (dimension == "acceleration") return usual_gravity;
  if (dimension == "torque per current") return 1e-3;
  return 0.1;  // rad, T
}

// A number of the model, with the key and the rule that its file has for it.
struct KnownNumber {
  LumpedNumber number;
  std::string key;
  Rule rule;
};

// The number of part `index` whose key that is.
template <class Part, std::size_t Count>
std::optional<KnownNumber> number_of(const std::array<text::Row<Part>, Count>& rows, std::size_t index,
                                     const std::string& key) {
  const auto known = std::ranges::find(rows, key, &text::RowFacts::key);
  if (known == rows.end() || known->member == nullptr) return std::nullopt;
  return KnownNumber{.number = PartNumber<Part>{index, known->member}, .key = key, .rule = known->rule};
}

// All that a name may mean, one kind after the other.
class LumpedNumberResolver {
 public:
  LumpedNumberResolver(const Document& document, LumpedModel model, CalibrateNames& names)
      : document_(document), model_(std::move(model)), names_(names), sizes_(sizes_of(model_)) {}

  void resolve(std::size_t i) {
    const std::string& name = names_.name(i);
    if (name == "joint_stiffness")
      return add_hinges(i, &Hinge::stiffness, "stiffness_Nm_rad", "joint_stiffness_Nmm_rad");
    if (name == "joint_damping") return add_hinges(i, &Hinge::damping, "damping_Nms_rad", "joint_damping_Nmms_rad");
    const std::vector<std::string> steps = names_.steps(i);
    names_.claim(i, {name});
    if (const auto number = names_.effect_number(i, steps, model_.effects)) {
      found_.numbers.push_back(
          {.parameter = calibration_parameter(name, model_.effects[number->effect], number->parameter),
           .target = LumpedShares{{{.number = *number}}}});
      return;
    }
    if (auto known = find(i, steps)) return add(name, *known);
    const auto there = follow(document_.root(), steps);
    if (there && there->kind() != Node::Kind::number) throw not_a_number(i, *there);
    throw names_.leads_nowhere(i);
  }

  [[nodiscard]] LumpedNumbers found() && { return std::move(found_); }

 private:
  InputError not_a_number(std::size_t i, const Node& node) const {
    return names_.error(i, "must lead to a number, and leads to " + node.shown());
  }

  [[nodiscard]] CalibrationParameter parameter(const std::string& name, std::string_view key, double declared,
                                               const Rule& rule) const {
    return calibration_parameter(name, key, declared, rule,
                                 usual_change(units::split_unit(key)->unit.dimension, sizes_));
  }

  void add(const std::string& pointer, const KnownNumber& known) {
    const double declared = number_in(model_, known.number);
    found_.numbers.push_back({.parameter = parameter(pointer, known.key, declared, known.rule),
                              .target = LumpedShares{{{.number = known.number}}}});
    found_.in_file.push_back({pointer, units::split_unit(known.key)->unit, known.number});
  }

  // One value for all joints: the mean, to which each keeps its ratio.
  void add_hinges(std::size_t i, double Hinge::*member, const std::string& key, const std::string& name) {
    const MeanOfJoints value = mean_of_joints(model_.hinges, member);
    LumpedShares target;
    std::vector<std::string> pointers;
    for (std::size_t j = 0; j < value.ratios.size(); ++j) {
      const LumpedNumber number = PartNumber<Hinge>{j, member};
      target.each.push_back({.number = number, .ratio = value.ratios[j]});
      pointers.push_back(fmt::format("/joints/{}/{}", j, key));
      found_.in_file.push_back({pointers.back(), units::split_unit(key)->unit, number});
    }
    names_.claim(i, pointers);
    found_.numbers.push_back(
        {.parameter = parameter(name, name, value.mean, non_negative), .target = std::move(target)});
  }

  [[nodiscard]] std::optional<KnownNumber> find(std::size_t i, std::span<const std::string> steps) const {
    if (steps.front() == "magnetics") return find_magnetic(i, steps);
    if (steps.size() == 1 && steps[0] == gravity_key)
      return KnownNumber{.number = GravityNumber{}, .key = std::string(gravity_key), .rule = gravity_rule};
    const auto index = steps.size() < 3 ? std::nullopt : array_index(steps[1]);
    if (!index || *index >= model_.links.size()) return std::nullopt;
    if (steps[0] == "links" && steps.size() == 3) return number_of(link_rows, *index, steps[2]);
    if (steps[0] == "joints" && steps.size() == 3) return number_of(joint_rows, *index, steps[2]);
    const bool contact = steps[0] == "joints" && steps.size() == 4 && steps[2] == "contact";
    if (!contact || !follow(document_.root(), steps.first(3))) return std::nullopt;
    return number_of(contact_rows, *index, steps[3]);
  }

  // A number that stands in the file: what has no key has no default either.
  [[nodiscard]] std::optional<KnownNumber> find_magnetic(std::size_t i, std::span<const std::string> steps) const {
    const auto node = follow(document_.root(), steps);
    if (!node) throw names_.leads_nowhere(i);
    if (node->kind() != Node::Kind::number) throw not_a_number(i, *node);
    const auto name = units::split_unit(node->key());
    if (node->key() == "recoil_permeability") throw names_.cannot_move(i, "makers' tables give this one");
    if (!name) throw names_.cannot_move(i, "this one is a whole number");
    const std::size_t pair = pair_of_joint(*array_index(steps[1]));
    if (steps.size() == 3) return find_length(pair, node->key());
    if (steps[2] == "coil") return as_positive(number_of(coil_rows, pair, node->key()));
    if (steps[2] == "magnet") return as_positive(number_of(magnet_rows, pair, node->key()));
    const auto column =
        name->unit.dimension == "angle" ? &actuator::TorqueTable::angles : &actuator::TorqueTable::torques;
    return KnownNumber{.number = TableNumber{.pair = pair, .column = column, .row = *array_index(steps[3])},
                       .key = node->key(),
                       .rule = finite};
  }

  [[nodiscard]] static std::optional<KnownNumber> find_length(std::size_t pair, const std::string& key) {
    using units::quantity_of;
    for (const auto& each : geometry_rows)
      if (quantity_of(key) == quantity_of(each.key) || quantity_of(key) == quantity_of(each.also))
        return KnownNumber{
            .number = PartNumber<magnetics::HingeGeometry>{pair, each.member}, .key = key, .rule = positive};
    return std::nullopt;
  }

  // The reader's upper bounds keep it from overflowing; a fit has none.
  [[nodiscard]] static std::optional<KnownNumber> as_positive(std::optional<KnownNumber> known) {
    if (known) known->rule = positive;
    return known;
  }

  [[nodiscard]] std::size_t pair_of_joint(std::size_t joint) const {
    const auto found = std::ranges::find(model_.pairs, static_cast<int>(joint), &actuator::LumpedPair::joint);
    return static_cast<std::size_t>(found - model_.pairs.begin());
  }

  const Document& document_;
  LumpedModel model_;
  CalibrateNames& names_;
  Sizes sizes_;
  LumpedNumbers found_;
};

}  // namespace

LumpedNumbers lumped_numbers(const Document& document, const LumpedModel& model, CalibrateNames& names) {
  LumpedNumberResolver resolver(document, model, names);
  for (std::size_t i = 0; i < names.size(); ++i) resolver.resolve(i);
  return std::move(resolver).found();
}

Document with_numbers_of(const Document& document, const std::vector<NumberInFile>& in_file, LumpedModel model) {
  std::map<std::string, text::PlainValue> numbers;
  for (const NumberInFile& each : in_file)
    numbers[each.pointer] = units::from_si(number_in(model, each.number), each.unit);
  return document.with_values(numbers);
}

}  // namespace coilwright::formats
