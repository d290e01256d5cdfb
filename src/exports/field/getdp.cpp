#include "coilwright/exports/getdp.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "coilwright/units/unit.hpp"
#include "exports/field/field_pair.hpp"
#include "exports/field/getdp_texts.hpp"

namespace coilwright::exports {
namespace {

std::string line(std::string_view name, double value, std::string_view meaning) {
  return fmt::format("  {} = {:.12g},  // {}\n", name, value, meaning);
}

// A length under a name of the geometry, which is in mm.
std::string length(std::string_view name, double value, std::string_view meaning) {
  return line(name, units::from_memory(value, "length_mm"), meaning);
}

std::string data(const FieldPair& pair, const Origin& origin) {
  std::string text;
  for (const std::string& words : about(pair, origin)) text += "// " + words + "\n";
  text += "// Lengths in mm, the rest in SI. Each may be set on the command line: -setnumber gap 2.\n";
  text += "DefineConstant[\n";
  text += length("coil_inner", pair.coil.inner_radius, "radius of the bore");
  text += length("coil_outer", pair.coil.outer_radius, "radius");
  text += length("coil_length", pair.coil.length, "along the axis");
  text += line("turns", pair.coil.turns_radial * static_cast<double>(pair.coil.turns_axial), "all of them");
  text += length("magnet_radius", pair.magnet.radius, "radius");
  text += length("magnet_length", pair.magnet.length, "along the axis");
  text += line("remanence", pair.magnet.remanence, "T, along the axis, away from the coil");
  text += line("recoil", pair.magnet.recoil_permeability, "relative permeability of the magnet");
  text += length("gap", pair.gap, "between the faces of coil and magnet");
  text += line("current", pair.current, "A; positive repels the magnet");
  text += length("size", pair.size, "half of the largest extent, for mesh and boundary");
  text += "  fineness = 1,  // all lengths of elements are divided by it\n";
  text += "  order = 2  // of the elements, 1 or 2\n];\n";
  return text;
}

}  // namespace

std::vector<ExportedFile> getdp(const ModelSubject& subject, const ExportSettings& settings) {
  const FieldPair pair = field_pair(subject.model, settings);
  return {{.name = "pair_data.pro", .text = data(pair, subject.origin), .left_out = beyond_the_pair(subject.model)},
          {.name = "pair.geo", .text = std::string(getdp_geometry)},
          {.name = "pair.pro", .text = std::string(getdp_problem)},
          pair_file(pair)};
}

}  // namespace coilwright::exports
