#include "coilwright/exports/kinds.hpp"

#include <fmt/format.h>

#include "coilwright/text/one_line.hpp"
#include "exports/cast.hpp"
#include "exports/packed_files.hpp"

namespace coilwright::exports {
namespace {

std::string scad_mm(double length) {
  return fmt::format("{:.7g}", 1e3 * length);
}

std::string assignment(std::string_view name, double length, std::string_view comment) {
  return fmt::format("{} = {};  // {}\n", name, scad_mm(length), comment);
}

// A row a part: what it is, where its pocket begins and how long that is, and the part's own radius, bore and length.
std::string parts_text(const Cast& cast) {
  std::string text = "// kind, start of its pocket, length of that, radius, radius of the bore, length\nparts = [\n";
  for (const PlacedPart& part : cast.plan.parts)
    text += fmt::format("  [\"{}\", {}, {}, {}, {}, {}],\n",
                        part.component.kind == actuator::ComponentKind::magnet ? "magnet" : "coil",
                        scad_mm(part.centre - part.half_pitch), scad_mm(2.0 * part.half_pitch), scad_mm(part.radius),
                        scad_mm(part.inner_radius), scad_mm(part.length));
  return text + "];\n";
}

std::string joints_text(const BodyPlan& plan) {
  std::string text = "// places of the slits\njoints = [";
  for (const double joint : plan.joints) text += (text.back() == '[' ? "" : ", ") + scad_mm(joint);
  return text + "];\n";
}

std::string variables(const DesignSubject& subject, const Cast& cast) {
  const BodyPlan& plan = cast.plan;
  return assignment("body_length", plan.length, "along the actuator, from its rear end") +
         assignment("body_width", plan.width, "across") +
         assignment("body_height", plan.height, "from underside to top") +
         assignment("bottom_layer", plan.bottom_layer, "that is left under the slits: the hinge") +
         assignment("axis_height", plan.axis_height, "of coils and magnets, above the underside") +
         assignment("clearance", cast.clearance, "round a part in its pocket") +
         assignment("coil_bore_diameter", 2.0 * subject.design.coil.inner_radius, "core of the bobbin") +
         assignment("coil_outer_diameter", 2.0 * subject.assembly.dimensions.coil_outer_radius,
                    "of the finished coil") +
         assignment("coil_length", subject.assembly.dimensions.coil_length, "between the flanges of the bobbin") +
         parts_text(cast) + joints_text(plan);
}

constexpr const char* how_to_render =
    "// To print: openscad -D 'part=\"mould_lower\"' -o mould_lower.stl mould.scad\n"
    "// and so for mould_upper, bobbin, bobbin_flange and cutting_box. To look at: body (as it is cast), "
    "bottom_layer,\n"
    "// filling (what is cast round the parts), coils, magnets, cavity (what the closed mould leaves free), "
    "assembly.\n";

std::string head(const Origin& origin) {
  const std::string name = origin.name.empty() ? "actuator" : text::one_line(origin.name, 200);
  return fmt::format("// Parts and casting mould of an actuator: {}\n// {}\n// Lengths in mm.\n", name,
                     text::one_line(origin.made_by, 1000));
}

}  // namespace

std::vector<ExportedFile> mould(const DesignSubject& subject, const ExportSettings&) {
  const Cast cast = cast_of(subject);
  return {{.name = "mould.scad",
           .text = head(subject.origin) + how_to_render + "\n// What the design says.\n" + variables(subject, cast) +
                   "\n" + std::string(text::packed_text(assets(), "mould.scad"))}};
}

}  // namespace coilwright::exports
