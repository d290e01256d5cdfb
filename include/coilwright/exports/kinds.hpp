#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// Writes the files of a kind that needs a geometry.
using DesignExport = std::vector<ExportedFile> (*)(const DesignSubject& subject, const ExportSettings& settings);

/// Writes the files of a kind that needs only a model.
using ModelExport = std::vector<ExportedFile> (*)(const ModelSubject& subject, const ExportSettings& settings);

/// One kind of export: a row of the table that the command line offers.
struct ExportKind {
  std::string_view name;                               ///< "workshop"
  std::string_view gives;                              ///< content of its files, in a phrase
  std::string_view use;                                ///< how to use the files, in one or two sentences
  std::span<const std::string_view> settings;          ///< names of the ExportSetting that it reads
  std::variant<DesignExport, ModelExport> write_text;  ///< function that makes the files; see export_files()
};

/// Every kind.
[[nodiscard]] std::span<const ExportKind> export_kinds() noexcept;

/// The kind of that name; nullptr if there is none.
[[nodiscard]] const ExportKind* find_export_kind(std::string_view name) noexcept;

/// Writes the files of one kind, at least one. The same subject and settings give the same bytes. Throws
/// std::invalid_argument if the kind needs a geometry that the subject lacks, or if its format cannot express something
/// of the subject (such as an effect).
[[nodiscard]] std::vector<ExportedFile> export_files(const ExportKind& kind, const Subject& subject,
                                                     const ExportSettings& settings);

/// Writes what a workshop needs to build the actuator: workshop.html, one self-contained page to print on A4, with
/// winding sheet, bill of materials, casting recipe, order of assembly and checks; and the same numbers as winding.csv,
/// layers.csv, materials.csv, casting.csv and assembly.csv. Reads lead_length, waste and base_per_hardener. Throws
/// std::invalid_argument if the parts do not fit into the body at a calibrated axis.
[[nodiscard]] std::vector<ExportedFile> workshop(const DesignSubject& subject, const ExportSettings& settings);

/// Draws the straight actuator with dimensions, in longitudinal section and in cross-sections through a coil and a
/// magnet: drawing.svg at the largest scale that fits on A4 landscape, and drawing.dxf (release 12, ASCII) at full
/// size, in mm. Takes any design and reads no setting.
[[nodiscard]] std::vector<ExportedFile> drawing(const DesignSubject& subject, const ExportSettings& settings);

/// Writes mould.scad, the parts and their tools as parametric OpenSCAD, with its numbers in mm as variables on top:
/// cast body, bottom layer, filling, coils, magnets; bobbin and its loose flange; lower and upper half of the mould; a
/// box that guides the knife. The steps are those of the source paper's section IV and Fig. 7; the shapes of mould and
/// bobbin are ours. Reads no setting. Throws std::invalid_argument if the parts do not fit into the body at a
/// calibrated axis.
[[nodiscard]] std::vector<ExportedFile> mould(const DesignSubject& subject, const ExportSettings& settings);

/// A model by its numbers alone, and what these numbers cannot express.
struct LumpedNumbers {
  actuator::LumpedModel model;
  std::vector<std::string> left_out{};  ///< one line each
};

/// The links, joints, torque curves (as tables) and effects of `model`. A base tilt becomes the effect base_tilt,
/// because a lumped model has no tilt; differences as built are in the numbers. Left out are forces between parts that
/// are not neighbours, effects that need the places of the coils, and the coils' resistance. Throws
/// std::invalid_argument for a base tilt beyond the 45 degrees of that effect.
[[nodiscard]] LumpedNumbers lumped_numbers(const actuator::Model& model);

/// Writes those numbers as a `lumped-model/1`: lumped_model.json, whose description names what was left out.
[[nodiscard]] std::vector<ExportedFile> lumped(const ModelSubject& subject, const ExportSettings& settings);

/// Writes the chain as a MuJoCo model, actuator.xml, and its torque per ampere as torque.csv and as custom data of the
/// model: links with inertias, joints with stiffness, damping and rest angle, stops where the faces meet, and for each
/// joint a motor whose control is its torque in N m. PlainModel says what is left out; so is inertia about the axes in
/// the plane. docs/exports/simulators.md explains the files.
[[nodiscard]] std::vector<ExportedFile> mjcf(const ModelSubject& subject, const ExportSettings& settings);

/// Writes the chain as URDF, actuator.urdf, and beside it what URDF cannot express: springs and stops in joints.csv,
/// torque per ampere in torque.csv. The springs are in the URDF too, as Gazebo's extension. PlainModel says what is
/// left out; so is inertia about the axes in the plane. docs/exports/simulators.md explains the files.
[[nodiscard]] std::vector<ExportedFile> urdf(const ModelSubject& subject, const ExportSettings& settings);

/// Writes the first coil and magnet that are neighbours, with their joint straight, for Gmsh and GetDP: pair_data.pro
/// has their numbers, pair.geo geometry and mesh, pair.pro the field with the force by J x B and by Maxwell's stress,
/// and pair.json the input of the command `force`. Throws std::invalid_argument if the model has no pair by its
/// dimensions, or no air between the two. docs/exports/fields.md explains the files.
[[nodiscard]] std::vector<ExportedFile> getdp(const ModelSubject& subject, const ExportSettings& settings);

/// Writes the first coil and magnet that are neighbours, with their joint straight, as a script for FEMM 4.2: pair.lua
/// draws them, solves the field and prints the force; pair.json is the input of the command `force`. Throws as getdp().
/// docs/exports/fields.md explains the files.
[[nodiscard]] std::vector<ExportedFile> femm(const ModelSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
