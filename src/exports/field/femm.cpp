#include "coilwright/exports/femm.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string>

#include "coilwright/units/unit.hpp"
#include "exports/field/femm_text.hpp"
#include "exports/field/field_pair.hpp"

namespace coilwright::exports {
namespace {

constexpr double mu0 = 4e-7 * std::numbers::pi;

std::string line(std::string_view name, double value, std::string_view meaning) {
  return fmt::format("{} = {:.12g} -- {}\n", name, value, meaning);
}

std::string length(std::string_view name, double value, std::string_view meaning) {
  return line(name, units::from_memory(value, "length_mm"), meaning);
}

std::string data(const FieldPair& pair, const Origin& origin) {
  std::string text;
  for (const std::string& words : about(pair, origin)) text += "-- " + words + "\n";
  text += "-- FEMM 4.2: File, Open Lua Script. Lengths in mm, the rest in SI.\n\n";
  text += length("coil_inner", pair.coil.inner_radius, "radius of the bore");
  text += length("coil_outer", pair.coil.outer_radius, "radius");
  text += length("coil_length", pair.coil.length, "along the axis");
  text += line("turns", pair.coil.turns_radial * static_cast<double>(pair.coil.turns_axial), "all of them");
  text += length("magnet_radius", pair.magnet.radius, "radius");
  text += length("magnet_length", pair.magnet.length, "along the axis");
  text += line("recoil", pair.magnet.recoil_permeability, "relative permeability of the magnet");
  text += line("coercivity", pair.magnet.remanence / (mu0 * pair.magnet.recoil_permeability),
               fmt::format("A/m: the remanence of {:.6g} T over the permeability", pair.magnet.remanence));
  text += length("gap", pair.gap, "between the faces of coil and magnet");
  text += line("current", pair.current, "A; positive repels the magnet");
  text += length("size", pair.size, "half of the largest extent, for mesh and boundary");
  return text;
}

}  // namespace

std::vector<ExportedFile> femm(const ModelSubject& subject, const ExportSettings& settings) {
  const FieldPair pair = field_pair(subject.model, settings);
  return {{.name = "pair.lua",
           .text = data(pair, subject.origin) + std::string(femm_script),
           .left_out = beyond_the_pair(subject.model)},
          pair_file(pair)};
}

}  // namespace coilwright::exports
