#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>
#include <string>

#include "coilwright/actuator/parts/hinge_pair_parts.hpp"
#include "coilwright/exports/kinds.hpp"
#include "coilwright/formats/actuator/pair_file.hpp"
#include "coilwright/magnetics/axial_force.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/units/unit.hpp"
#include "exports/packed_files.hpp"

namespace coilwright::exports {
namespace {

constexpr double mu0 = 4e-7 * std::numbers::pi;

// A coil and the magnet beside it on one axis, as a program for fields of axial symmetry takes them. SI.
struct FieldPair {
  magnetics::ThickCoil::Spec coil{};  // its current is uniform over the section
  magnetics::CylinderMagnet::Spec magnet{};
  double gap{};      // between their faces, m; > 0
  double current{};  // A; positive repels the magnet
  double size{};     // half of the largest extent of both, m: what meshes and boundaries are in proportion to
};

const actuator::HingePairParts::Spec& parts_of(const actuator::Model& model) {
  for (const actuator::HingePair& pair : model.magnetics().hinge_pairs())
    if (pair.parts) return pair.parts->spec();
  throw std::invalid_argument(
      "needs a coil and a magnet by their dimensions: this model has none, or torque tables alone");
}

// The first coil and magnet on the two sides of a joint, with the joint straight.
FieldPair field_pair(const actuator::Model& model, const ExportSettings& settings) {
  const actuator::HingePairParts::Spec& parts = parts_of(model);
  FieldPair pair{.coil = {.inner_radius = parts.coil.inner_radius(),
                          .outer_radius = parts.coil.outer_radius(),
                          .length = parts.coil.length(),
                          .turns_radial = parts.coil.turns_radial(),
                          .turns_axial = parts.coil.turns_axial()},
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

// From the centre of the coil to the centre of the magnet, m.
double centre_distance(const FieldPair& pair) {
  return 0.5 * (pair.coil.length + pair.magnet.length) + pair.gap;
}

// By Coilwright, N, away from the coil. Like moments attract, and a positive current is the one that repels.
double force_on_magnet(const FieldPair& pair) {
  return magnetics::axial_force(magnetics::ThickCoil(pair.coil), -pair.current, magnetics::CylinderMagnet(pair.magnet),
                                centre_distance(pair));
}

// The same pair as the file of the command `force`.
ExportedFile pair_file(const FieldPair& pair) {
  const magnetics::Pose pose{.position = {0.0, 0.0, centre_distance(pair)}};
  const magnetics::DrivenCoil coil{.coil = magnetics::ThickCoil(pair.coil), .current = -pair.current};
  return {.name = "pair.json",
          .text = formats::to_json(coil, magnetics::CylinderMagnet(pair.magnet), std::array{pose}).text()};
}

// What a field of axial symmetry does not have of the model: one line each.
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

// A number of a pair as files of field programs write it: lengths in mm, the rest in SI.
struct FieldNumber {
  std::string_view name;
  double value{};
  std::string_view meaning;
};

double pair_mm(double length) {
  return units::from_memory(length, "length_mm");
}

// How a program writes comments and numbers: beginning of a comment's line, and a number's name, value and meaning.
struct FieldSyntax {
  std::string_view comment;
  std::string_view number;
};
constexpr FieldSyntax getdp_syntax{"// ", "  {} = {:.12g},  // {}\n"};
constexpr FieldSyntax lua_syntax{"-- ", "{} = {:.12g} -- {}\n"};

std::string numbers_text(const FieldSyntax& syntax, const std::vector<FieldNumber>& numbers) {
  std::string text;
  for (const FieldNumber& each : numbers)
    text += fmt::format(fmt::runtime(syntax.number), each.name, each.value, each.meaning);
  return text;
}

// What the file is, and the force that Coilwright computes. What a person wrote may have line ends, and what follows
// one would be a command.
std::string head_of_pair(const FieldSyntax& syntax, const FieldPair& pair, const Origin& origin) {
  constexpr std::size_t longest = 400;
  const std::string made_by = text::one_line(origin.made_by, longest);
  return fmt::format(
      "{0}Coil and magnet of {1}{2}\n"
      "{0}Coilwright: {3:.5g} N on the magnet, away from the coil, at {4:.6g} A (coilwright force pair.json).\n",
      syntax.comment, origin.name.empty() ? "an actuator" : text::one_line(origin.name),
      made_by.empty() ? "." : ". Made by " + made_by + ".", force_on_magnet(pair), pair.current);
}

// The coil and the shape of the magnet; what the program takes the magnet's `strength` by; and where they are, and
// under which current.
std::string pair_text(const FieldSyntax& syntax, const FieldPair& pair, const std::vector<FieldNumber>& strength) {
  return numbers_text(syntax,
                      {{"coil_inner", pair_mm(pair.coil.inner_radius), "radius of the bore"},
                       {"coil_outer", pair_mm(pair.coil.outer_radius), "radius"},
                       {"coil_length", pair_mm(pair.coil.length), "along the axis"},
                       {"turns", pair.coil.turns_radial * static_cast<double>(pair.coil.turns_axial), "all of them"},
                       {"magnet_radius", pair_mm(pair.magnet.radius), "radius"},
                       {"magnet_length", pair_mm(pair.magnet.length), "along the axis"}}) +
         numbers_text(syntax, strength) +
         numbers_text(syntax, {{"gap", pair_mm(pair.gap), "between the faces of coil and magnet"},
                               {"current", pair.current, "A; positive repels the magnet"},
                               {"size", pair_mm(pair.size), "half of the largest extent, for mesh and boundary"}});
}

std::string asset(std::string_view name) {
  return std::string(text::packed_text(assets(), name));
}

}  // namespace

std::vector<ExportedFile> getdp(const ModelSubject& subject, const ExportSettings& settings) {
  const FieldPair pair = field_pair(subject.model, settings);
  const std::string data =
      head_of_pair(getdp_syntax, pair, subject.origin) +
      "// Lengths in mm, the rest in SI. Each may be set on the command line: -setnumber gap 2.\nDefineConstant[\n" +
      pair_text(getdp_syntax, pair,
                {{"remanence", pair.magnet.remanence, "T, along the axis, away from the coil"},
                 {"recoil", pair.magnet.recoil_permeability, "relative permeability of the magnet"}}) +
      "  fineness = 1,  // all lengths of elements are divided by it\n  order = 2  // of the elements, 1 or 2\n];\n";
  return {{.name = "pair_data.pro", .text = data, .left_out = beyond_the_pair(subject.model)},
          {.name = "pair.geo", .text = asset("pair.geo")},
          {.name = "pair.pro", .text = asset("pair.pro")},
          pair_file(pair)};
}

std::vector<ExportedFile> femm(const ModelSubject& subject, const ExportSettings& settings) {
  const FieldPair pair = field_pair(subject.model, settings);
  const std::string from = fmt::format("A/m: the remanence of {:.6g} T over the permeability", pair.magnet.remanence);
  const std::string data =
      head_of_pair(lua_syntax, pair, subject.origin) +
      "-- FEMM 4.2: File, Open Lua Script. Lengths in mm, the rest in SI.\n\n" +
      pair_text(lua_syntax, pair,
                {{"recoil", pair.magnet.recoil_permeability, "relative permeability of the magnet"},
                 {"coercivity", pair.magnet.remanence / (mu0 * pair.magnet.recoil_permeability), from}});
  return {{.name = "pair.lua", .text = data + "\n" + asset("pair.lua"), .left_out = beyond_the_pair(subject.model)},
          pair_file(pair)};
}

}  // namespace coilwright::exports
