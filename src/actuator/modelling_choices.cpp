#include "coilwright/actuator/modelling_choices.hpp"

#include <fmt/format.h>

#include <utility>

#include "coilwright/actuator/hinges.hpp"

namespace coilwright::actuator {
namespace {

constexpr std::string_view two_bottom_layers = "the force that bends two fingers with different bottom layers";
constexpr std::string_view two_releases = "the ringing after a release of two fingers with different bottom layers";
constexpr std::string_view coil_and_magnet = "the force between one coil and its magnet at two distances";
constexpr std::string_view full_grasp = "the grasp force of this finger at its full current";
constexpr std::string_view thermocouple = "a hold of an hour with a thermocouple in the coil";

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
                     .design = with_hinge_law(design, law)});
}

std::string name_of(const DampingSplit& split) {
  const std::string_view law =
      split.law == DampingLaw::loss_factor ? "at one loss factor of the silicone" : "proportional to the stiffness";
  if (split.share <= 0.0) return "all of it constant";
  if (split.share >= 1.0) return fmt::format("all of it {}", law);
  return fmt::format("{:.0f} % of what was measured {}, the rest constant", 100.0 * split.share, law);
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
                     .design = with_damping(design, other)});
  }
}

std::string name_of(ContactChoice faces) {
  return faces == ContactChoice::walls ? "the silicone walls between coil and magnet carry it"
                                       : "the walls give way until coil and magnet touch";
}

OtherChoice contact_otherwise(const Design& design) {
  const ContactChoice other =
      design.choices.faces == ContactChoice::walls ? ContactChoice::hard_parts : ContactChoice::walls;
  return {.subject = "contact of a closing joint",
          .taken = name_of(design.choices.faces),
          .otherwise = name_of(other),
          .settled_by = full_grasp,
          .design = with_face_contact(design, other)};
}

std::string name_of(AmpacityChoice ampacity) {
  return ampacity == AmpacityChoice::law ? "a smooth law through the chassis-wiring table"
                                         : "the chassis-wiring table, gauge by gauge";
}

OtherChoice ampacity_otherwise(const Design& design) {
  const AmpacityChoice other =
      design.choices.ampacity == AmpacityChoice::law ? AmpacityChoice::table : AmpacityChoice::law;
  OtherChoice out{.subject = "ampacity of the wire",
                  .taken = name_of(design.choices.ampacity),
                  .otherwise = name_of(other),
                  .settled_by = thermocouple,
                  .design = design};
  out.design.choices.ampacity = other;
  return out;
}

std::string name_of(magnetics::CurrentDistribution winding) {
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

OtherChoice winding_otherwise(const Design& design) {
  using enum magnetics::CurrentDistribution;
  const auto other = design.choices.winding == uniform ? paper_shells : uniform;
  OtherChoice out{.subject = "current in the winding",
                  .taken = name_of(design.choices.winding),
                  .otherwise = name_of(other),
                  .settled_by = coil_and_magnet,
                  .design = design};
  out.design.choices.winding = other;
  return out;
}

std::string name_of(const Design& design, FilmChoice film) {
  if (film == FilmChoice::still_air) return "still air with radiation";
  return fmt::format("{:.3g} W/m2K, from a continuous current",
                     design.surroundings.heat_transfer * design.calibration.heat_transfer);
}

OtherChoice film_otherwise(const Design& design) {
  const FilmChoice other =
      design.choices.film == FilmChoice::calibrated ? FilmChoice::still_air : FilmChoice::calibrated;
  OtherChoice out{.subject = "heat transfer of the surface",
                  .taken = name_of(design, design.choices.film),
                  .otherwise = name_of(design, other),
                  .settled_by = thermocouple,
                  .design = design};
  out.design.choices.film = other;
  return out;
}

}  // namespace

std::vector<OtherChoice> other_choices(const Design& design) {
  std::vector<OtherChoice> out;
  add_hinge_laws(design, out);
  add_damping_laws(design, out);
  out.push_back(film_otherwise(design));
  out.push_back(contact_otherwise(design));
  out.push_back(ampacity_otherwise(design));
  out.push_back(winding_otherwise(design));
  return out;
}

}  // namespace coilwright::actuator
