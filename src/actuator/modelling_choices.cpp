#include "coilwright/actuator/modelling_choices.hpp"

#include <fmt/format.h>

#include <utility>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/actuator/hinges.hpp"
#include "coilwright/actuator/number_widths.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::actuator {
namespace {

constexpr std::string_view two_bottom_layers = "the force that bends two fingers with different bottom layers";
constexpr std::string_view two_releases = "the ringing after a release of two fingers with different bottom layers";
constexpr std::string_view coil_and_magnet = "the force between one coil and its magnet at two distances";
constexpr std::string_view full_grasp = "the grasp force of this finger at its full current";
constexpr std::string_view thermocouple = "a hold of an hour with a thermocouple in the coil";
// What each choice rests on: docs/assumptions.md says more.
constexpr std::string_view cut_or_cast = "a body cast whole and cut by hand, or cast with its joints";
constexpr std::string_view loss_of_prototype = "silicones have 15 to 60 % of the damping that the prototype had";
constexpr std::string_view film_of_paper = "one remark of the source paper against textbooks";

std::string name_of(const Design& design, HingeLaw law) {
  switch (law) {
    case HingeLaw::slit:
      return "a slit (stiffness goes with the square of the bottom layer)";
    case HingeLaw::slot:
      return fmt::format("a slot of {:.3g} mm", design.body.slot_width * 1e3);
    case HingeLaw::beam:
      return "a beam of fixed length (stiffness goes with the cube of the bottom layer)";
  }
  return "";
}

void add_hinge_laws(const Design& design, std::vector<OtherChoice>& out) {
  for (const HingeLaw law : {HingeLaw::slit, HingeLaw::slot, HingeLaw::beam})
    if (law != design.choices.hinge)
      out.push_back({.subject = "law of the hinges",
                     .taken = name_of(design, design.choices.hinge),
                     .otherwise = name_of(design, law),
                     .settled_by = two_bottom_layers,
                     .design = with_hinge_law(design, law),
                     .source = cut_or_cast});
}

std::string name_of(const DampingSplit& split) {
  const std::string_view law =
      split.law == DampingLaw::loss_factor ? "at one loss factor of the silicone" : "proportional to the stiffness";
  if (split.share <= 0.0) return "all of it constant";
  if (split.share >= 1.0) return fmt::format("all of it {}", law);
  return fmt::format("{:.0f} % of it {}, the rest constant", 100.0 * split.share, law);
}

void add_damping_laws(const Design& design, std::vector<OtherChoice>& out) {
  const DampingSplit taken = damping_split(design);
  for (const DampingSplit other :
       {DampingSplit{.law = taken.law, .share = 0.0}, DampingSplit{.law = DampingLaw::loss_factor, .share = 1.0},
        DampingSplit{.law = DampingLaw::proportional, .share = 1.0}}) {
    const bool same = other.share == taken.share && (other.law == taken.law || taken.share == 0.0);
    if (!same)
      out.push_back({.subject = "damping of the joints",
                     .taken = name_of(taken),
                     .otherwise = name_of(other),
                     .settled_by = two_releases,
                     .design = with_damping(design, other),
                     .source = loss_of_prototype});
  }
}

std::string name_of(const Design&, ContactChoice faces) {
  return faces == ContactChoice::walls ? "the silicone walls between coil and magnet carry it"
                                       : "the walls give way until coil and magnet touch";
}

std::string name_of(const Design&, AmpacityChoice ampacity) {
  return ampacity == AmpacityChoice::law ? "a smooth law through the chassis-wiring table"
                                         : "the chassis-wiring table, gauge by gauge";
}

std::string name_of(const Design&, magnetics::CurrentDistribution winding) {
  switch (winding) {
    case magnetics::CurrentDistribution::paper_shells:
      return "in layers, the outermost at the rim (the source paper)";
    case magnetics::CurrentDistribution::layer_centres:
      return "in layers at the wires' centres";
    case magnetics::CurrentDistribution::uniform:
      return "spread evenly over the winding";
  }
  return "";
}

std::string name_of(const Design& design, FilmChoice film) {
  if (film == FilmChoice::still_air) return "still air with radiation";
  return fmt::format("{:.3g} W/m2K, from a continuous current", calibrated_film(design));
}

std::string name_of(const Design&, magnetics::Fidelity torque) {
  return torque == magnetics::Fidelity::exact ? "exact at every angle"
                                              : "that of the line of centres (the source paper)";
}

std::string name_of(const Design&, SegmentMass masses) {
  return masses == SegmentMass::rigid_bodies ? "bodies with inertia" : "points on the axis (the source paper)";
}

struct Question {
  std::string_view subject;
  std::string_view settled_by;
  std::string_view source;
};

// A choice by which nothing is calibrated, made otherwise: `usual`, or `other` where the design takes that already.
template <class Choice>
OtherChoice made_otherwise(const Design& design, const Question& question, Choice ModelChoices::*choice, Choice usual,
                           Choice other) {
  const Choice taken = design.choices.*choice;
  const Choice otherwise = taken == usual ? other : usual;
  OtherChoice out{.subject = question.subject,
                  .taken = name_of(design, taken),
                  .otherwise = name_of(design, otherwise),
                  .settled_by = question.settled_by,
                  .design = design,
                  .source = question.source};
  out.design.choices.*choice = otherwise;
  return out;
}

}  // namespace

std::vector<OtherChoice> other_choices(const Design& design) {
  std::vector<OtherChoice> out;
  add_hinge_laws(design, out);
  add_damping_laws(design, out);
  out.push_back(made_otherwise(design, {"heat transfer of the surface", thermocouple, film_of_paper},
                               &ModelChoices::film, FilmChoice::calibrated, FilmChoice::still_air));
  out.push_back(made_otherwise(design,
                               {"contact of a closing joint", full_grasp, "the prototype's grasp force lies between"},
                               &ModelChoices::faces, ContactChoice::walls, ContactChoice::hard_parts));
  out.push_back(made_otherwise(design, {"ampacity of the wire", thermocouple, "a rounded table, or a law through it"},
                               &ModelChoices::ampacity, AmpacityChoice::law, AmpacityChoice::table));
  out.push_back(made_otherwise(
      design, {"current in the winding", coil_and_magnet, "the source paper's shells, or a wound coil"},
      &ModelChoices::winding, magnetics::CurrentDistribution::uniform, magnetics::CurrentDistribution::paper_shells));
  // Of these two the other one is known to be nearer the truth, and is only looked at from the paper's.
  if (design.choices.torque != magnetics::Fidelity::exact)
    out.push_back(
        made_otherwise(design, {"torque of a coil on its magnet", coil_and_magnet, "theory/actuator.md, Pairs"},
                       &ModelChoices::torque, magnetics::Fidelity::line_of_centres, magnetics::Fidelity::exact));
  if (design.choices.masses != SegmentMass::rigid_bodies)
    out.push_back(made_otherwise(design, {"mass of a segment", "a balance on an edge", "theory/actuator.md, Geometry"},
                                 &ModelChoices::masses, SegmentMass::on_axis_points, SegmentMass::rigid_bodies));
  return out;
}

std::vector<OtherChoice> other_numbers(const Design& design) {
  std::vector<OtherChoice> out;
  for (const NumberWidth& width : number_widths()) {
    const Parameter& parameter = *find_parameter(width.name);
    const auto text = [&](double value) {
      if (!parameter.names().empty())
        return fmt::format("{} {}", width.name, parameter.names()[static_cast<std::size_t>(value)]);
      return fmt::format("{} {:.4g}", width.name, value);
    };
    for (const double value : other_values(width, design)) {
      out.push_back({.subject = width.subject,
                     .taken = text(units::from_memory(parameter.get(design), parameter.key)),
                     .otherwise = text(value),
                     .settled_by = width.settled_by,
                     .design = design,
                     .source = width.source,
                     .number = width.name,
                     .decided = width.decided});
      parameter.set(out.back().design, units::to_memory(value, parameter.key));
    }
  }
  return out;
}

}  // namespace coilwright::actuator
