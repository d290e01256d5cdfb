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

/// Writes the files of a kind that a model alone suffices for.
using ModelExport = std::vector<ExportedFile> (*)(const ModelSubject& subject, const ExportSettings& settings);

/// One kind of export: a row of the table that the command line offers.
struct ExportKind {
  std::string_view name;                               ///< "workshop"
  std::string_view gives;                              ///< what its files are, in a phrase
  std::string_view use;                                ///< what to do with them next, in one or two sentences
  std::span<const std::string_view> settings;          ///< names of the ExportSetting that it reads
  std::variant<DesignExport, ModelExport> write_text;  ///< by which it is made; see export_files()
};

/// Every kind.
[[nodiscard]] std::span<const ExportKind> export_kinds() noexcept;

/// The kind of that name; nullptr if there is none.
[[nodiscard]] const ExportKind* find_export_kind(std::string_view name) noexcept;

/// The files of one kind, at least one. Pure: the same subject and settings give the same bytes. Throws
/// std::invalid_argument where the kind needs a geometry and the subject has none, and as the kind says where it cannot
/// say what the subject has (an effect that its format does not know).
[[nodiscard]] std::vector<ExportedFile> export_files(const ExportKind& kind, const Subject& subject,
                                                     const ExportSettings& settings);

/// What a workshop needs to build the actuator: workshop.html, one page without anything from outside that prints on
/// A4, with winding sheet, bill of materials, casting recipe, order of assembly and checks; and the same numbers as
/// winding.csv and layers.csv, materials.csv, casting.csv and assembly.csv. Reads lead_length, waste and
/// base_per_hardener. Throws std::invalid_argument where a calibrated axis lies so that the parts do not fit into the
/// body.
[[nodiscard]] std::vector<ExportedFile> workshop(const DesignSubject& subject, const ExportSettings& settings);

/// The straight actuator with dimensions, in longitudinal section and in cross-sections through a coil and a magnet:
/// drawing.svg at the largest scale that fits on A4 across, and drawing.dxf (release 12, ASCII) at its own size, in mm.
/// Takes any design; reads no setting.
[[nodiscard]] std::vector<ExportedFile> drawing(const DesignSubject& subject, const ExportSettings& settings);

/// The parts and the tools to make them by as parametric OpenSCAD: mould.scad, its numbers in mm as variables on top.
/// Cast body, bottom layer, filling, coils, magnets; bobbin and its loose flange; lower and upper half of the mould; a
/// box that guides the knife. After the steps of the source paper's section IV; its Fig. 7 shows them, the shapes of
/// mould and bobbin are ours. Reads no setting. Throws std::invalid_argument where a calibrated axis lies so that the
/// parts do not fit into the body.
[[nodiscard]] std::vector<ExportedFile> mould(const DesignSubject& subject, const ExportSettings& settings);

/// A model by its numbers alone, and what of it these cannot say.
struct LumpedNumbers {
  actuator::LumpedModel model;
  std::vector<std::string> left_out{};  ///< one line each
};

/// The links, joints, torque curves (as tables) and effects of `model`. A base tilt becomes the effect base_tilt, since
/// a lumped model has none of its own; differences as built are in the numbers. Left out are forces between parts that
/// are not neighbours, effects that need to know where the coils are, and the coils' resistance. Throws
/// std::invalid_argument for a base tilt beyond the 45 degrees of that effect.
[[nodiscard]] LumpedNumbers lumped_numbers(const actuator::Model& model);

/// The same as a `lumped-model/1`: lumped_model.json, whose description names what was left out.
[[nodiscard]] std::vector<ExportedFile> lumped(const ModelSubject& subject, const ExportSettings& settings);

/// The chain as a MuJoCo model, actuator.xml, and its torque per ampere as torque.csv and as custom data of the model:
/// links with inertias, joints with stiffness, damping and rest angle, stops where the faces meet, a motor for each
/// joint that takes its torque in N m. Left out are what PlainModel leaves out, and inertia about the axes in the
/// plane. What the files mean is in docs/exports/simulators.md.
[[nodiscard]] std::vector<ExportedFile> mjcf(const ModelSubject& subject, const ExportSettings& settings);

/// The chain as URDF, actuator.urdf, with what URDF has no words for beside it: springs and stops in joints.csv, torque
/// per ampere in torque.csv. The springs are in the file too, as the extension that Gazebo reads. Left out are what
/// PlainModel leaves out, and inertia about the axes in the plane. What the files mean is in
/// docs/exports/simulators.md.
[[nodiscard]] std::vector<ExportedFile> urdf(const ModelSubject& subject, const ExportSettings& settings);

/// The first coil and magnet that are neighbours, straight, for Gmsh and GetDP: pair_data.pro has their numbers,
/// pair.geo the geometry and mesh, pair.pro the field with the force by J x B and by Maxwell's stress, and pair.json is
/// what the command `force` takes. Throws std::invalid_argument where the model has no pair by its dimensions, or no
/// air between the two. What the files mean is in docs/exports/fields.md.
[[nodiscard]] std::vector<ExportedFile> getdp(const ModelSubject& subject, const ExportSettings& settings);

/// The first coil and magnet that are neighbours, straight, as a script for FEMM 4.2: pair.lua draws them, solves the
/// field and prints the force; pair.json is what the command `force` takes. Throws as getdp(). What the files mean is
/// in docs/exports/fields.md.
[[nodiscard]] std::vector<ExportedFile> femm(const ModelSubject& subject, const ExportSettings& settings);

}  // namespace coilwright::exports
