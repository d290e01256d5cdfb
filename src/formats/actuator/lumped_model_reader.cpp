#include "formats/actuator/lumped_model_reader.hpp"

#include <algorithm>
#include <boost/math/interpolators/barycentric_rational.hpp>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "coilwright/actuator/parts/coil_row.hpp"
#include "coilwright/actuator/parts/hinge_pair_parts.hpp"
#include "coilwright/magnetics/curve.hpp"
#include "coilwright/magnetics/hinge_torque.hpp"
#include "formats/actuator/effects_reader.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Hinge;
using actuator::HingePair;
using actuator::HingePairParts;
using magnetics::Curve;
using mechanics::Link;

// A curve over the whole working range of a joint, exact to a millionth of its largest torque.
constexpr double degree = std::numbers::pi / 180.0;
constexpr double swing_back = -30.0 * degree;  // nothing stops the joints of a lumped model without a contact
constexpr Curve::Spec pair_range{.lower = -2.0 * degree, .upper = 120.0 * degree, .tolerance = 1e-6};

template <class Part, std::size_t Count>
Part read_numbers(ObjectReader& in, const std::array<LumpedNumber<Part>, Count>& numbers) {
  Part part{};
  for (const LumpedNumber<Part>& number : numbers)
    part.*number.member = number.otherwise ? in.quantity_or(number.key, *number.otherwise, number.rule)
                                           : in.quantity(number.key, number.rule);
  return part;
}

Link read_link(const Node& node) {
  return read_object(node, [](ObjectReader& in) { return read_numbers(in, link_numbers); });
}

Hinge read_joint(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    Hinge hinge = read_numbers(in, joint_numbers);
    if (const auto contact = in.find_not_null("contact"))
      hinge.contact = read_object(*contact, [](ObjectReader& faces) { return read_numbers(faces, contact_numbers); });
    return hinge;
  });
}

// The paper's name or ours, in any unit of length.
double read_length(ObjectReader& in, std::string_view ours, std::string_view paper) {
  const auto found = in.find_in_any_unit(ours);
  const auto other = in.find_in_any_unit(paper);
  if (found && other) throw other->error_without_value("cannot stand beside \"" + found->key() + "\"");
  return other ? other->quantity(positive) : in.at_in_any_unit(ours).quantity(positive);
}

// Coil and magnet of Table II with the paper's l_a, l_b and h.
std::shared_ptr<const HingePairParts> read_pair_parts(ObjectReader& in) {
  const magnetics::CurrentDistribution winding = read_winding(in);
  const magnetics::ThickCoil coil = read_coil(in.at("coil"), winding);
  const magnetics::CylinderMagnet magnet = read_magnet(in.at("magnet"));
  const magnetics::HingeGeometry geometry{.coil_offset = read_length(in, "coil_offset_mm", "l_a_mm"),
                                          .magnet_offset = read_length(in, "magnet_offset_mm", "l_b_mm"),
                                          .axis_offset = read_length(in, "axis_offset_mm", "h_mm")};
  const auto fidelity =
      in.choice_or("torque", magnetics::Fidelity::line_of_centres,
                   {{"line_of_centres", magnetics::Fidelity::line_of_centres}, {"exact", magnetics::Fidelity::exact}});
  return std::make_shared<const HingePairParts>(HingePairParts::Spec{.coil = coil,
                                                                     .magnet = magnet,
                                                                     .geometry = geometry,
                                                                     .fidelity = fidelity,
                                                                     .range = pair_range,
                                                                     .line_of_centres_lower = swing_back});
}

HingePair read_pair(ObjectReader& in) {
  const std::shared_ptr<const HingePairParts> parts = read_pair_parts(in);
  return {.torque_per_ampere = parts->torque(), .parts = parts};
}

// Measured torque per ampere over the joint angle, joined by a rational interpolant without poles (Floater and
// Hormann).
HingePair read_table(ObjectReader& in) {
  const Node angle_node = in.at_in_any_unit("angle_deg");
  const std::vector<double> angles = angle_node.quantities(Length::at_least(4));
  const std::vector<double> torques = in.at_in_any_unit("torque_Nmm_A").quantities(Length::exactly(angles.size()));
  if (std::ranges::adjacent_find(angles, std::greater_equal<>()) != angles.end())
    throw angle_node.error_without_value("must increase from one angle to the next");
  const boost::math::barycentric_rational<double> table(angles.data(), torques.data(), angles.size(), 3);
  const auto values = [&table](std::span<const double> at, std::span<double> out) {
    std::ranges::transform(at, out.begin(), [&table](double angle) { return table(angle); });
  };
  return {.torque_per_ampere = std::make_shared<const Curve>(
              values, Curve::Spec{.lower = angles.front(), .upper = angles.back(), .tolerance = 1e-4})};
}

}  // namespace

std::vector<HingePair> read_lumped_magnetics(const Node& node, std::size_t joints) {
  std::vector<HingePair> pairs;
  const std::vector<Node> entries = node.elements(Length::exactly(joints));
  for (std::size_t j = 0; j < joints; ++j) {
    if (entries[j].is_null()) continue;
    HingePair pair = read_object(entries[j], [](ObjectReader& in) {
      const auto table = in.find_in_any_unit("angle_deg");
      const auto coil = in.find("coil");
      if (table && coil) throw table->error_without_value("cannot stand beside \"coil\"");
      if (table) return read_table(in);
      (void)in.one_of({"coil", "angle_deg"});
      return read_pair(in);
    });
    pair.joint = static_cast<int>(j);
    pair.coil = static_cast<int>(pairs.size());
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

void place_coils(LumpedModel& lumped) {
  const std::vector<HingePair>& pairs = lumped.pairs;
  lumped.coil_row = nullptr;
  if (lumped.links.size() != 2 || pairs.size() != 2 || !pairs[0].parts || !pairs[1].parts) return;
  const HingePairParts::Spec& base = pairs[0].parts->spec();
  const HingePairParts::Spec& last = pairs[1].parts->spec();
  const bool exact = base.fidelity == magnetics::Fidelity::exact && last.fidelity == magnetics::Fidelity::exact;
  lumped.coil_row = std::make_shared<const actuator::CoilRow>(
      mechanics::PlanarChain(lumped.links, lumped.gravity),
      std::vector<actuator::PlacedCoil>{
          {.coil = base.coil,
           .centre = {.link = -1, .along = -base.geometry.coil_offset, .offset = base.geometry.axis_offset}},
          {.coil = last.coil,
           .centre = {.link = 1, .along = last.geometry.coil_offset, .offset = last.geometry.axis_offset}}},
      exact ? actuator::DistantPair::Orientation::dipoles : actuator::DistantPair::Orientation::ignored);
}

LumpedModel read_lumped_model(ObjectReader& in, const actuator::EffectCatalogue& known) {
  LumpedModel lumped{.gravity = in.quantity_or(gravity_key, usual_gravity, non_negative)};
  for (const Node& node : in.elements("links", Length::from_to(1, mechanics::max_joints)))
    lumped.links.push_back(read_link(node));
  const std::size_t joints = lumped.links.size();
  for (const Node& node : in.elements("joints", Length::exactly(joints))) lumped.hinges.push_back(read_joint(node));
  if (const auto magnetics = in.find_not_null("magnetics")) lumped.pairs = read_lumped_magnetics(*magnetics, joints);
  place_coils(lumped);
  lumped.effects = read_effects(in, known);
  if (lumped.effects.empty()) return lumped;
  const actuator::ModelSpec spec = spec_of(lumped);
  for (std::size_t i = 0; i < lumped.effects.size(); ++i)
    if (const auto why = lumped.effects[i].kind->inapplicable(spec))
      throw in.at("effects").elements()[i].error_without_value("cannot be in this model: " + *why);
  return lumped;
}

actuator::ModelSpec spec_of(const LumpedModel& lumped) {
  return {.chain = mechanics::PlanarChain(lumped.links, lumped.gravity),
          .hinges = lumped.hinges,
          .magnetics = actuator::MagneticStage(lumped.pairs, {}),
          .coils = static_cast<int>(lumped.pairs.size()),
          .tip = {.link = static_cast<int>(lumped.links.size()) - 1, .along = lumped.links.back().length},
          .effects = lumped.effects,
          .coil_row = lumped.coil_row};
}

}  // namespace coilwright::formats
