#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "coilwright/text/json/json_pointer.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/data/declared_parts.hpp"
#include "formats/data/recent_results.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Effect;
using actuator::Hinge;
using actuator::HingePair;
using measurement::replay::CalibrationParameter;

// Numbers of the file by their pointers, in its units.
using Numbers = std::map<std::string, double>;

// A number that may be calibrated: how it gets into a model, and how into the file.
struct Movable {
  CalibrationParameter parameter;
  std::function<void(LumpedModel&, double)> set{};  // null: a number of the magnetics, which are read anew
  std::function<void(Numbers&, double)> write{};    // null: of an effect, which is written with the others
  bool moves_coils{};
};

// How large things are on the rig, for what is 0 in the file.
struct Sizes {
  double length{};     // m
  double inertia{};    // about the first joint when straight, kg m^2
  double stiffness{};  // of gravity, or of a swing of one second, N m/rad
  double damping{};    // a tenth of critical, N m s/rad
};

Sizes sizes_of(const LumpedModel& lumped) {
  Sizes sizes;
  double before = 0.0, gravity = 0.0;
  for (const mechanics::Link& link : lumped.links) {
    const double reach = before + std::abs(link.com_along);
    sizes.inertia += link.inertia + link.mass * (reach * reach + link.com_offset * link.com_offset);
    gravity += link.mass * lumped.gravity * reach;
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

CalibrationParameter parameter_at(const std::string& pointer, std::string_view key, double declared, const Rule& rule,
                                  const Sizes& sizes) {
  return calibration_parameter(pointer, key, declared, rule,
                               usual_change(units::split_unit(key)->unit.dimension, sizes));
}

std::string at_joint(std::size_t joint, std::string_view key) {
  return fmt::format("/joints/{}/{}", joint, key);
}

// One value for all joints: the mean, to which each keeps its ratio.
Movable of_all_joints(const LumpedModel& lumped, std::string_view key, double Hinge::*member, std::string name,
                      const Sizes& sizes) {
  std::vector<double> ratios;
  double mean = 0.0;
  for (const Hinge& hinge : lumped.hinges) mean += hinge.*member / static_cast<double>(lumped.hinges.size());
  const bool alike = std::ranges::all_of(
      lumped.hinges, [&](const Hinge& hinge) { return hinge.*member == lumped.hinges.front().*member; });
  if (alike) mean = lumped.hinges.front().*member;  // to the bit
  for (const Hinge& hinge : lumped.hinges) ratios.push_back(alike ? 1.0 : hinge.*member / mean);
  return {.parameter = calibration_parameter(name, name, mean, non_negative,
                                             usual_change(units::split_unit(key)->unit.dimension, sizes)),
          .set =
              [ratios, member](LumpedModel& model, double value) {
                for (std::size_t j = 0; j < ratios.size(); ++j) model.hinges[j].*member = value * ratios[j];
              },
          .write =
              [ratios, key = std::string(key)](Numbers& numbers, double value) {
                for (std::size_t j = 0; j < ratios.size(); ++j)
                  numbers[at_joint(j, key)] = units::from_si(value * ratios[j], key);
              }};
}

// Of the part of a model that `part` gives.
template <class Part, std::size_t Count, class Access>
std::optional<Movable> number_of(const std::array<LumpedNumber<Part>, Count>& known, const std::string& pointer,
                                 std::string_view key, const Part& declared, Access access, const Sizes& sizes) {
  const auto found = std::ranges::find(known, key, &LumpedNumber<Part>::key);
  if (found == known.end()) return std::nullopt;
  const auto member = found->member;
  return Movable{.parameter = parameter_at(pointer, key, declared.*member, found->rule, sizes),
                 .set = [access, member](LumpedModel& model, double value) { access(model).*member = value; },
                 .write = [pointer, key = std::string(key)](
                              Numbers& numbers, double value) { numbers[pointer] = units::from_si(value, key); }};
}

// All that a name may mean, one kind after the other.
class Finder {
 public:
  Finder(const Document& document, const LumpedModel& lumped, CalibrateNames& names)
      : document_(document), lumped_(lumped), names_(names), sizes_(sizes_of(lumped)) {}

  [[nodiscard]] Movable find(std::size_t i) {
    const std::string& name = names_.name(i);
    if (name == "joint_stiffness")
      return of_joints(i, "stiffness_Nm_rad", &Hinge::stiffness, "joint_stiffness_Nmm_rad");
    if (name == "joint_damping") return of_joints(i, "damping_Nms_rad", &Hinge::damping, "joint_damping_Nmms_rad");
    const std::vector<std::string> steps = names_.steps(i);
    names_.claim(i, {name});
    if (const auto number = names_.effect_number(i, steps, lumped_.effects)) return of_effect(i, *number);
    if (steps.front() == "magnetics") return of_magnetics(i, steps);
    if (steps.size() == 1 && steps[0] == gravity_key) return gravity();
    if (steps.size() >= 3)
      if (auto movable = of_part(i, steps)) return *std::move(movable);
    const auto there = follow(document_.root(), steps);
    if (there && there->kind() != Node::Kind::number) throw not_a_number(i, *there);
    throw names_.leads_nowhere(i);
  }

 private:
  InputError not_a_number(std::size_t i, const Node& node) const {
    return names_.error(i, "must lead to a number, and leads to " + node.shown());
  }

  Movable of_joints(std::size_t i, std::string_view key, double Hinge::*member, std::string name) {
    std::vector<std::string> pointers;
    for (std::size_t j = 0; j < lumped_.hinges.size(); ++j) pointers.push_back(at_joint(j, key));
    names_.claim(i, pointers);
    return of_all_joints(lumped_, key, member, std::move(name), sizes_);
  }

  Movable of_effect(std::size_t i, const EffectNumber& number) const {
    return {.parameter = calibration_parameter(names_.name(i), lumped_.effects[number.effect], number.parameter),
            .set = [number](LumpedModel& model, double value) {
              model.effects[number.effect].values[number.parameter] = value;
            }};
  }

  Movable gravity() const {
    const std::string pointer = fmt::format("/{}", gravity_key);
    return {
        .parameter = parameter_at(pointer, gravity_key, lumped_.gravity, non_negative, sizes_),
        .set = [](LumpedModel& model, double value) { model.gravity = value; },
        .write = [pointer](Numbers& numbers, double value) { numbers[pointer] = units::from_si(value, gravity_key); }};
  }

  std::optional<Movable> of_part(std::size_t i, std::span<const std::string> steps) const {
    const std::string& pointer = names_.name(i);
    const auto index = array_index(steps[1]);
    if (!index || *index >= lumped_.links.size()) return std::nullopt;
    const std::size_t at = *index;
    if (steps[0] == "links" && steps.size() == 3) {
      auto movable = number_of(
          link_numbers, pointer, steps[2], lumped_.links[at],
          [at](LumpedModel& model) -> mechanics::Link& { return model.links[at]; }, sizes_);
      if (movable) movable->moves_coils = steps[2] == link_numbers.front().key;
      return movable;
    }
    if (steps[0] == "joints" && steps.size() == 3)
      return number_of(
          joint_numbers, pointer, steps[2], lumped_.hinges[at],
          [at](LumpedModel& model) -> Hinge& { return model.hinges[at]; }, sizes_);
    const bool contact = steps[0] == "joints" && steps.size() == 4 && steps[2] == "contact";
    if (!contact || !follow(document_.root(), steps.first(3))) return std::nullopt;
    return number_of(
        contact_numbers, pointer, steps[3], lumped_.hinges[at].contact,
        [at](LumpedModel& model) -> mechanics::FaceContact& { return model.hinges[at].contact; }, sizes_);
  }

  Movable of_magnetics(std::size_t i, std::span<const std::string> steps) const {
    const auto node = follow(document_.root(), steps);
    if (!node) throw names_.leads_nowhere(i);
    if (node->kind() != Node::Kind::number) throw not_a_number(i, *node);
    const auto name = units::split_unit(node->key());
    if (!name) throw names_.cannot_move(i, "this one is a whole number");
    const bool table = name->unit.dimension == "torque per current" || name->unit.dimension == "angle";
    return {.parameter = parameter_at(names_.name(i), node->key(), node->quantity(), table ? finite : positive, sizes_),
            .write = [pointer = names_.name(i), unit = name->unit](
                         Numbers& numbers, double value) { numbers[pointer] = units::from_si(value, unit); },
            .moves_coils = true};
  }

  const Document& document_;
  const LumpedModel& lumped_;
  CalibrateNames& names_;
  Sizes sizes_;
};

// What build() and updated() share.
class DeclaredLumpedModel {
 public:
  DeclaredLumpedModel(Document document, LumpedModel lumped, CalibrateNames names)
      : document_(std::move(document)), lumped_(std::move(lumped)) {
    Finder finder(document_, lumped_, names);
    for (std::size_t i = 0; i < names.size(); ++i) movables_.push_back(finder.find(i));
  }

  [[nodiscard]] std::vector<CalibrationParameter> parameters() const {
    std::vector<CalibrationParameter> all;
    for (const Movable& movable : movables_) all.push_back(movable.parameter);
    return all;
  }

  [[nodiscard]] LumpedModel at(std::span<const double> values) {
    check_count(values);
    LumpedModel model = lumped_;
    Numbers magnetic;
    std::vector<double> magnetic_values;
    bool moves_coils = false;
    for (std::size_t i = 0; i < movables_.size(); ++i) {
      const Movable& movable = movables_[i];
      moves_coils = moves_coils || movable.moves_coils;
      if (movable.set) {
        movable.set(model, values[i]);
      } else {
        movable.write(magnetic, values[i]);
        magnetic_values.push_back(values[i]);
      }
    }
    if (!magnetic.empty()) model.pairs = *pairs_.get(magnetic_values, [&] { return read_pairs(magnetic); });
    if (moves_coils) place_coils(model);
    return model;
  }

  [[nodiscard]] UpdatedActuator updated(std::span<const double> values, const std::vector<Effect>& effects) {
    LumpedModel model = at(values);
    Numbers numbers;
    for (std::size_t i = 0; i < movables_.size(); ++i)
      if (movables_[i].write) movables_[i].write(numbers, values[i]);
    return UpdatedLumpedModel{.document = document_.with_numbers(numbers),
                              .effects = joined(std::move(model.effects), effects)};
  }

 private:
  void check_count(std::span<const double> values) const {
    if (values.size() != movables_.size())
      throw std::invalid_argument(
          fmt::format("calibration must have {} values; got {}", movables_.size(), values.size()));
  }

  std::vector<HingePair> read_pairs(const Numbers& numbers) const {
    const Document changed = document_.with_numbers(numbers);
    try {
      return read_lumped_magnetics(*changed.root().find("magnetics"), lumped_.links.size());
    } catch (const InputError& mistake) {
      throw std::invalid_argument(mistake.what());
    }
  }

  Document document_;
  LumpedModel lumped_;
  std::vector<Movable> movables_;
  RecentResults<std::vector<HingePair>> pairs_;
};

}  // namespace

DeclaredActuator declare(Document document, LumpedModel lumped, CalibrateNames names,
                         const actuator::EffectCatalogue& /*known*/) {
  const auto model = std::make_shared<DeclaredLumpedModel>(std::move(document), std::move(lumped), std::move(names));
  return {.name = {},
          .model = {.calibration = model->parameters(),
                    .build = [model](std::span<const double> values) { return spec_of(model->at(values)); }},
          .updated = [model](std::span<const double> values, const std::vector<Effect>& effects) {
            return model->updated(values, effects);
          }};
}

}  // namespace coilwright::formats
