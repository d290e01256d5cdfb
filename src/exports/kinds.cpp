#include "coilwright/exports/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {
namespace {

constexpr std::array<std::string_view, 3> of_workshop = {"lead_mm", "waste", "base_per_hardener"};
constexpr std::array<std::string_view, 1> of_fields = {"current_A"};

// One row a kind.
constexpr std::array table = {
    ExportKind{.name = "workshop",
               .gives = "winding sheet, bill of materials, casting recipe and order of assembly, to print and as CSV",
               .use = "Open workshop.html in a browser and print it on A4; the CSV files have the same numbers.",
               .settings = of_workshop,
               .write_text = &workshop},
    ExportKind{.name = "drawing",
               .gives = "dimensioned sections to scale, as SVG and DXF",
               .use = "Print drawing.svg as it is; drawing.dxf has the actuator at its own size, in mm.",
               .settings = {},
               .write_text = &drawing},
    ExportKind{.name = "mould",
               .gives = "parts, bobbin and casting mould as parametric OpenSCAD",
               .use = "Render each part that its first lines name: openscad -D 'part=\"mould_lower\"' -o "
                      "mould_lower.stl mould.scad. The numbers on top may be changed.",
               .settings = {},
               .write_text = &mould},
    ExportKind{
        .name = "lumped",
        .gives = "links, joints and torque curves by their numbers (lumped-model/1)",
        .use = "Commands that need no geometry (evaluate, simulate, linearise, diagnose, twin) take lumped_model.json.",
        .settings = {},
        .write_text = &lumped},
    ExportKind{.name = "mjcf",
               .gives = "the chain as a MuJoCo model, with its torque over angle",
               .use = "Load actuator.xml in MuJoCo and apply the torque of each joint as its first lines say.",
               .settings = {},
               .write_text = &mjcf},
    ExportKind{.name = "urdf",
               .gives = "the chain as URDF, with its springs, stops and torque over angle as CSV",
               .use = "Load actuator.urdf, and apply what its first lines say: URDF has no springs.",
               .settings = {},
               .write_text = &urdf},
    ExportKind{.name = "getdp",
               .gives = "a coil and its magnet as geometry and field problem for Gmsh and GetDP",
               .use = "In that folder: gmsh -2 -format msh22 pair.geo -o pair.msh && getdp pair.pro -msh pair.msh "
                      "-solve Solve; forces.txt has the force.",
               .settings = of_fields,
               .write_text = &getdp},
    ExportKind{.name = "femm",
               .gives = "a coil and its magnet as a script for FEMM 4.2",
               .use = "In FEMM 4.2, open pair.lua as a Lua script: it draws, solves and prints the force.",
               .settings = of_fields,
               .write_text = &femm},
};

struct Writing {
  const ExportKind& kind;
  const ExportSettings& settings;

  std::vector<ExportedFile> operator()(DesignExport write, const DesignSubject& subject) const {
    return write(subject, settings);
  }
  std::vector<ExportedFile> operator()(DesignExport, const ModelSubject&) const {
    throw std::invalid_argument(fmt::format("{} needs the geometry of a design (actuator/1)", kind.name));
  }
  std::vector<ExportedFile> operator()(ModelExport write, const DesignSubject& subject) const {
    return write({.origin = subject.origin, .model = subject.assembly.model}, settings);
  }
  std::vector<ExportedFile> operator()(ModelExport write, const ModelSubject& subject) const {
    return write(subject, settings);
  }
};

constexpr std::array setting_table = {
    ExportSetting{.name = "lead_mm",
                  .text = "Length of each of the two leads of a coil, mm (default 150)",
                  .lowest = 0.0,
                  .highest = 10'000.0,
                  .value = &ExportSettings::lead_length},
    ExportSetting{.name = "waste",
                  .text = "Silicone that stays in cups and on tools, over the silicone in the actuator (default 0.25)",
                  .lowest = 0.0,
                  .highest = 10.0,
                  .value = &ExportSettings::waste},
    ExportSetting{.name = "base_per_hardener",
                  .text = "Mass of part A of the silicone over that of part B, by its data sheet (default: not known)",
                  .lowest = 0.01,
                  .highest = 1000.0,
                  .value = &ExportSettings::base_per_hardener},
    ExportSetting{
        .name = "current_A",
        .text = "Current in the coil of the pair whose field is computed, A; positive repels the magnet (default 1)",
        .lowest = -1000.0,
        .highest = 1000.0,
        .value = &ExportSettings::current},
};

}  // namespace

std::span<const ExportKind> export_kinds() noexcept {
  return table;
}

const ExportKind* find_export_kind(std::string_view name) noexcept {
  const auto* found = std::ranges::find(table, name, &ExportKind::name);
  return found == table.end() ? nullptr : &*found;
}

std::vector<ExportedFile> export_files(const ExportKind& kind, const Subject& subject, const ExportSettings& settings) {
  return std::visit(Writing{kind, settings}, kind.write_text, subject);
}

std::span<const ExportSetting> export_settings() noexcept {
  return setting_table;
}

}  // namespace coilwright::exports
