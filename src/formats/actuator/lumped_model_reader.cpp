#include "formats/actuator/actuator_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <new>
#include <utility>
#include <vector>

#include "coilwright/magnetics/hinge_torque.hpp"
#include "formats/actuator/as_built_format.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Hinge;
using actuator::LumpedPair;
using actuator::PairDimensions;
using actuator::TorqueTable;
using mechanics::Link;

// Millimetres for metres. A thin rod of carbon has 30 g a metre; a link of a finger whose lengths are written in
// millimetres has a tenth of that.
Link read_link(const Node& node) {
  constexpr double usual_length = 1.0;       // m
  constexpr double longest = 50.0;           // m
  constexpr double lightest_of_long = 0.01;  // kg/m
  return read_object(node, [&](ObjectReader& in) {
    const Link link = read_rows(in, link_rows, Link{});
    for (const auto& [key, length] : {std::pair("length_m", link.length), std::pair("com_along_m", link.com_along),
                                      std::pair("com_offset_m", link.com_offset)})
      if (std::abs(length) > longest ||
          (std::abs(length) > usual_length && link.mass < lightest_of_long * std::abs(length)))
        throw in.at(key).error(
            fmt::format("must be a length in m that a link of {:.4g} kg can have: is it in mm?", link.mass));
    return link;
  });
}

// Grams for kilograms: no chain is heavier than a cube of osmium, the densest of all metals, twice as wide as it is
// long.
void require_mass_in_kg(const std::vector<Node>& nodes, const std::vector<Link>& links) {
  constexpr double density = 22590.0;  // kg/m^3
  double length = 0.0;
  for (const Link& link : links) length += std::max({link.length, std::abs(link.com_along), std::abs(link.com_offset)});
  for (std::size_t i = 0; i < links.size(); ++i)
    if (length > 0.0 && links[i].mass > density * std::pow(2.0 * length, 3))
      throw nodes[i].find("mass_kg")->error(
          fmt::format("must be a mass in kg that a chain of {:.3g} m can have: is it in g?", length));
}

// Writes the joint's part of `link` too.
Hinge read_joint(const Node& node, Link& link) {
  return read_object(node, [&link](ObjectReader& in) {
    Hinge hinge = read_rows(in, joint_rows, Hinge{});
    link = read_rows(in, rotor_rows, link);
    if (const auto contact = in.find_not_null("contact"))
      hinge.contact = read_object(
          *contact, [](ObjectReader& faces) { return read_rows(faces, contact_rows, mechanics::FaceContact{}); });
    return hinge;
  });
}

// The paper's name or ours, in any unit of length.
double read_length(ObjectReader& in, const RowFacts& length) {
  const auto found = in.find_in_any_unit(length.key);
  const auto other = in.find_in_any_unit(length.also);
  if (found && other) throw other->error_without_value("cannot stand beside \"" + found->key() + "\"");
  const Node node = other ? *other : in.at_in_any_unit(length.key);
  return node.quantity(part_length(node.key()));
}

constexpr std::array pair_rows = {
    text::choice_row<&PairDimensions::fidelity>("torque", fidelity_words, "The paper's approximation, or exact")};

// Coil and magnet of Table II with the paper's l_a, l_b and h.
PairDimensions read_dimensions(ObjectReader& in) {
  PairDimensions pair;
  const magnetics::CurrentDistribution winding = read_winding(in);
  pair.coil = read_coil(in.at("coil"), winding);
  pair.magnet = read_magnet(in.at("magnet"), effective_remanence);
  for (const auto& length : geometry_rows) length.set(pair.geometry, read_length(in, length));
  pair = read_rows(in, pair_rows, pair);
  return pair;
}

TorqueTable read_table(ObjectReader& in) {
  TorqueTable table;
  const Node angles = in.at_in_any_unit("angle_deg");
  table.angles = angles.quantities(Length::at_least(4));
  table.torques = in.at_in_any_unit("torque_Nmm_A").quantities(Length::exactly(table.angles.size()));
  if (std::ranges::adjacent_find(table.angles, std::greater_equal<>()) != table.angles.end())
    throw angles.error_without_value("must increase from one angle to the next");
  return table;
}

// The entries of "magnetics": one per joint, null for a joint without a coil.
void read_magnetics(const Node& node, LumpedModelContent& content) {
  const std::size_t joints = content.model.links.size();
  const std::vector<Node> entries = node.elements(Length::exactly(joints));
  for (std::size_t j = 0; j < joints; ++j) {
    if (entries[j].is_null()) continue;
    LumpedPair pair{.joint = static_cast<int>(j)};
    const int coil = static_cast<int>(content.model.pairs.size());
    content.magnetics.hinge_pairs.push_back(read_object(entries[j], [&](ObjectReader& in) {
      const auto table = in.find_in_any_unit("angle_deg");
      const auto parts = in.find("coil");
      if (table && parts) throw table->error_without_value("cannot stand beside \"coil\"");
      if (table) {
        pair.source = read_table(in);
      } else {
        (void)in.one_of({"coil", "angle_deg"});
        pair.source = read_dimensions(in);
      }
      try {
        return actuator::hinge_pair_of(pair, coil);
      } catch (const std::bad_alloc&) {
        throw;
      } catch (const std::exception& why) {
        throw entries[j].error_without_value(fmt::format("must give a smooth torque over the angle: {}", why.what()));
      }
    }));
    content.model.pairs.push_back(std::move(pair));
  }
}

}  // namespace

LumpedModelContent read_lumped_model(ObjectReader& in, const actuator::EffectCatalogue& known) {
  LumpedModelContent content;
  actuator::LumpedModel& model = content.model;
  model.gravity = in.quantity_or(gravity_key, usual_gravity, gravity_rule);
  const std::vector<Node> links = in.elements("links", Length::from_to(1, mechanics::max_joints));
  for (const Node& node : links) model.links.push_back(read_link(node));
  require_mass_in_kg(links, model.links);
  for (const Node& node : in.elements("joints", Length::exactly(model.links.size())))
    model.hinges.push_back(read_joint(node, model.links[model.hinges.size()]));
  if (const auto magnetics = in.find_not_null("magnetics")) read_magnetics(*magnetics, content);
  content.magnetics.coil_row = actuator::coil_row_of(model);
  model.effects = read_effects(in, known);
  model.as_built = read_as_built(in);
  if (model.effects.empty()) return content;
  const actuator::ModelSpec spec = actuator::spec_of(model, content.magnetics);
  for (std::size_t i = 0; i < model.effects.size(); ++i)
    if (const auto why = model.effects[i].kind->inapplicable(spec))
      throw in.at("effects").elements()[i].error_without_value("cannot be in this model: " + *why);
  return content;
}

}  // namespace coilwright::formats
