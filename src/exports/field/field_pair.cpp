#include "exports/field/field_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "coilwright/actuator/parts/hinge_pair_parts.hpp"
#include "coilwright/formats/actuator/pair_json.hpp"
#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::exports {
namespace {

const actuator::HingePairParts::Spec& parts_of(const actuator::Model& model) {
  for (const actuator::HingePair& pair : model.magnetics().hinge_pairs())
    if (pair.parts) return pair.parts->spec();
  throw std::invalid_argument(
      "needs a coil and a magnet by their dimensions: this model has none, or torque tables alone");
}

magnetics::ThickCoil::Spec uniform(const magnetics::ThickCoil& coil) {
  return {.inner_radius = coil.inner_radius(),
          .outer_radius = coil.outer_radius(),
          .length = coil.length(),
          .turns_radial = coil.turns_radial(),
          .turns_axial = coil.turns_axial()};
}

}  // namespace

FieldPair field_pair(const actuator::Model& model, const ExportSettings& settings) {
  const actuator::HingePairParts::Spec& parts = parts_of(model);
  FieldPair pair{.coil = uniform(parts.coil),
                 .magnet = {.radius = parts.magnet.radius(),
                            .length = parts.magnet.length(),
                            .remanence = parts.magnet.remanence(),
                            .recoil_permeability = parts.magnet.recoil_permeability()},
                 .current = settings.current};
  const double lengths = pair.coil.length + pair.magnet.length;
  pair.gap = parts.geometry.coil_offset + parts.geometry.magnet_offset - 0.5 * lengths;
  if (!(pair.gap > 0.0))
    throw std::invalid_argument(
        fmt::format("needs air between the faces of coil and magnet; their gap is {:.6g} mm", 1e3 * pair.gap));
  pair.size = std::max({pair.coil.outer_radius, pair.magnet.radius, 0.5 * (lengths + pair.gap)});
  return pair;
}

double centre_distance(const FieldPair& pair) {
  return 0.5 * (pair.coil.length + pair.magnet.length) + pair.gap;
}

double force_on_magnet(const FieldPair& pair) {
  // Like moments attract, and a positive current is the one that repels.
  return magnetics::axial_force(magnetics::ThickCoil(pair.coil), -pair.current, magnetics::CylinderMagnet(pair.magnet),
                                centre_distance(pair));
}

std::vector<FieldNumber> shape_numbers(const FieldPair& pair) {
  const auto mm = [](double length) { return units::from_memory(length, "length_mm"); };
  return {{"coil_inner", mm(pair.coil.inner_radius), "radius of the bore"},
          {"coil_outer", mm(pair.coil.outer_radius), "radius"},
          {"coil_length", mm(pair.coil.length), "along the axis"},
          {"turns", pair.coil.turns_radial * static_cast<double>(pair.coil.turns_axial), "all of them"},
          {"magnet_radius", mm(pair.magnet.radius), "radius"},
          {"magnet_length", mm(pair.magnet.length), "along the axis"}};
}

std::vector<FieldNumber> place_numbers(const FieldPair& pair) {
  const auto mm = [](double length) { return units::from_memory(length, "length_mm"); };
  return {{"gap", mm(pair.gap), "between the faces of coil and magnet"},
          {"current", pair.current, "A; positive repels the magnet"},
          {"size", mm(pair.size), "half of the largest extent, for mesh and boundary"}};
}

ExportedFile pair_file(const FieldPair& pair) {
  const magnetics::Pose pose{.position = {0.0, 0.0, centre_distance(pair)}};
  const magnetics::DrivenCoil coil{.coil = magnetics::ThickCoil(pair.coil), .current = -pair.current};
  return {.name = "pair.json",
          .text = formats::to_json(coil, magnetics::CylinderMagnet(pair.magnet), std::array{pose}).text()};
}

std::vector<std::string> beyond_the_pair(const actuator::Model& model) {
  std::vector<std::string> lines;
  if (parts_of(model).coil.winding() != magnetics::CurrentDistribution::uniform)
    lines.emplace_back("where in the coil the model has its current: here it is uniform over the section");
  const actuator::ModelSpec& spec = model.nominal_spec();
  if (spec.magnetics.hinge_pairs().size() > 1)
    lines.emplace_back("every coil and magnet but the first two neighbours, and all poses but the straight one");
  else
    lines.emplace_back("all poses but the straight one");
  if (model.coil_resistance()) lines.emplace_back("heat: the magnet is at 20 degC");
  return lines;
}

std::vector<std::string> about(const FieldPair& pair, const Origin& origin) {
  // What a person wrote may have line ends, and what follows one would be a command.
  constexpr std::size_t longest = 400;
  const std::string made_by = text::one_line(origin.made_by, longest);
  return {
      fmt::format("Coil and magnet of {}{}", origin.name.empty() ? "an actuator" : text::one_line(origin.name),
                  made_by.empty() ? "." : ". Made by " + made_by + "."),
      fmt::format("Coilwright: {:.5g} N on the magnet, away from the coil, at {:.6g} A (coilwright force pair.json).",
                  force_on_magnet(pair), pair.current)};
}

}  // namespace coilwright::exports
