#include "coilwright/formats/actuator/pair_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "coilwright/magnetics/overlap.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/actuator/actuator_reader.hpp"
#include "formats/actuator/body_reader.hpp"
#include "formats/actuator/choice_words.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using magnetics::Body;
using magnetics::CurrentDistribution;
using magnetics::DrivenCoil;
using magnetics::ThickCoil;
using text::Json;

// Bounds a message and the work: each body acts on each.
constexpr std::size_t most_bodies = 200;

std::vector<Body> read_two_magnets(ObjectReader& in) {
  std::vector<Body> bodies;
  for (const Node& magnet : in.elements("magnets", Length::exactly(2))) bodies.push_back({.part = read_magnet(magnet)});
  return bodies;
}

std::vector<Body> read_two_coils(ObjectReader& in) {
  const CurrentDistribution winding = read_winding(in);
  const auto coils = in.elements("coils", Length::exactly(2));
  const bool one_each = in.one_of({"current_A", "currents_A"}) == "currents_A";
  const auto currents = one_each ? in.quantities("currents_A", Length::exactly(2), current_rule)
                                 : std::vector<double>(2, in.quantity("current_A", current_rule));
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < coils.size(); ++i)
    bodies.push_back({.part = DrivenCoil{.coil = ThickCoil(read_coil(coils[i], winding)), .current = currents[i]}});
  return bodies;
}

std::vector<Body> read_coil_and_magnet(ObjectReader& in) {
  const ThickCoil coil(read_coil(in.at("coil"), read_winding(in)));
  const double current = in.quantity("current_A", current_rule);
  return {{.part = DrivenCoil{.coil = coil, .current = current}}, {.part = read_magnet(in.at("magnet"))}};
}

void read_list(ObjectReader& in, PairFile& file) {
  const std::vector<Node> bodies = in.elements("bodies", Length::from_to(1, most_bodies));
  const bool posed_apart = in.find("poses").has_value();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    NamedBody body = read_body(bodies[i], !posed_apart || i + 1 < bodies.size());
    file.names.push_back(body.name.empty() ? usual_name(body.body, i) : std::move(body.name));
    file.bodies.push_back(std::move(body.body));
  }
  if (!posed_apart) file.poses.push_back(file.bodies.back().pose);
}

void read_pair_of_bodies(ObjectReader& in, const std::string& bodies, PairFile& file) {
  file.bodies = bodies == "coils"     ? read_two_coils(in)
                : bodies == "magnets" ? read_two_magnets(in)
                                      : read_coil_and_magnet(in);
  for (std::size_t i = 0; i < file.bodies.size(); ++i) file.names.push_back(usual_name(file.bodies[i], i));
}

PairFile read_pair_file(const Document& document) {
  return read_object(document.root(), [](ObjectReader& in) {
    PairFile file;
    const std::string bodies = in.one_of({"bodies", "coil", "coils", "magnets"});
    file.listed = bodies == "bodies";
    if (file.listed)
      read_list(in, file);
    else
      read_pair_of_bodies(in, bodies, file);
    if (file.poses.empty())
      for (const Node& pose : in.elements("poses", Length::at_least(1))) file.poses.push_back(read_pose(pose));
    file.bodies.back().pose = file.poses.front();
    if (const auto plate = in.find("plate")) {
      const PlateContent content = read_plate(*plate);
      file.plate = content.plate;
      file.plate_radius = content.radius;
      for (const magnetics::Pose& pose : file.poses) require_in_front(*plate, content.plate, file.bodies_at(pose));
    }
    return file;
  });
}

Json pose_json(const magnetics::Pose& pose) {
  return Json::object(
      {Json::quantities("position_mm", {pose.position.data(), 3}), {"axis", Json::numbers({pose.axis.data(), 3})}});
}

}  // namespace

std::vector<Body> PairFile::bodies_at(const magnetics::Pose& pose) const {
  std::vector<Body> out = bodies;
  out.back().pose = pose;
  return out;
}

PairFile read_pair(const std::filesystem::path& path) {
  return read_pair_file(read_json(path));
}

PairFile parse_pair(std::string_view text, std::string file) {
  return read_pair_file(parse_json(text, std::move(file)));
}

void require_apart(const PairFile& file, std::span<const Body> bodies, std::size_t first, std::size_t pose,
                   const std::string& who) {
  for (std::size_t j = first; j < bodies.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      if (magnetics::is_axial(bodies[i]) && magnetics::is_axial(bodies[j])) continue;
      if (magnetics::overlap(bodies[i], bodies[j]))
        throw InputError({.file = who,
                          .rule = fmt::format("must have {} and {} apart: in pose {} they are in the same place, where "
                                              "the force on a magnet's faces means nothing",
                                              file.names[i], file.names[j], pose)});
    }
}

magnetics::Forces forces_on(const PairFile& file, const std::vector<Body>& bodies, std::size_t pose,
                            const std::string& who) {
  magnetics::Forces forces = magnetics::forces(bodies, file.plate);
  for (const magnetics::Wrench& each : forces.on)
    if (!each.force.allFinite() || !each.torque.allFinite())
      throw InputError({.file = who, .rule = fmt::format("pose {}: the force is beyond what can be computed", pose)});
  return forces;
}

Json to_json(const magnetics::DrivenCoil& driven, const magnetics::CylinderMagnet& magnet,
             std::span<const magnetics::Pose> poses) {
  const magnetics::ThickCoil& coil = driven.coil;
  Json out = Json::object({{"coil", coil_json({.inner_radius = coil.inner_radius(),
                                               .outer_radius = coil.outer_radius(),
                                               .length = coil.length(),
                                               .turns_radial = coil.turns_radial(),
                                               .turns_axial = coil.turns_axial(),
                                               .winding = coil.winding()})},
                           {"magnet", magnet_json({.radius = magnet.radius(),
                                                   .length = magnet.length(),
                                                   .remanence = magnet.remanence(),
                                                   .recoil_permeability = magnet.recoil_permeability()})},
                           {"current_A", driven.current},
                           {"winding", winding_words[static_cast<std::size_t>(coil.winding())]}});
  out.set("poses", Json::list(poses, pose_json));
  return out;
}

}  // namespace coilwright::formats
