#include "coilwright/formats/actuator/pair_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "formats/actuator/magnetic_parts.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using magnetics::CurrentDistribution;
using magnetics::CylinderMagnet;
using magnetics::Pose;
using magnetics::ThickCoil;

// Bounds far beyond any hardware, and near enough that nothing computed from the numbers overflows.
constexpr Rule coordinate = Rule::between(-1e6, 1e6);  // mm
constexpr Rule current = Rule::between(-1e6, 1e6);     // A
constexpr Rule direction = Rule::between(-1e6, 1e6);

Pose read_pose(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    const auto position = in.vector("position_mm", coordinate);
    const Node axis_node = in.at("axis");
    const auto axis = axis_node.vector(direction);
    constexpr double shortest = 1e-6;
    if (std::hypot(axis[0], axis[1], axis[2]) < shortest) {
      throw axis_node.error_without_value(fmt::format("must be at least {} long, to give a direction", shortest));
    }
    return Pose{.position = {position[0], position[1], position[2]}, .axis = {axis[0], axis[1], axis[2]}};
  });
}

TwoMagnets read_two_magnets(ObjectReader& in) {
  const auto magnets = in.elements("magnets", Length::exactly(2));
  return {.first = CylinderMagnet(read_magnet(magnets[0], design_remanence)),
          .second = CylinderMagnet(read_magnet(magnets[1], design_remanence))};
}

TwoCoils read_two_coils(ObjectReader& in) {
  const CurrentDistribution winding = read_winding(in);
  const auto coils = in.elements("coils", Length::exactly(2));
  const bool one_each = in.one_of({"current_A", "currents_A"}) == "currents_A";
  const auto currents = one_each ? in.quantities("currents_A", Length::exactly(2), current)
                                 : std::vector<double>(2, in.quantity("current_A", current));
  return {.first = ThickCoil(read_coil(coils[0], winding)),
          .first_current = currents[0],
          .second = ThickCoil(read_coil(coils[1], winding)),
          .second_current = currents[1]};
}

CoilAndMagnet read_coil_and_magnet(ObjectReader& in) {
  return {.coil = ThickCoil(read_coil(in.at("coil"), read_winding(in))),
          .current = in.quantity("current_A", current),
          .magnet = CylinderMagnet(read_magnet(in.at("magnet"), design_remanence))};
}

std::variant<CoilAndMagnet, TwoCoils, TwoMagnets> read_bodies(ObjectReader& in) {
  const std::string bodies = in.one_of({"coil", "coils", "magnets"});
  if (bodies == "coils") return read_two_coils(in);
  if (bodies == "magnets") return read_two_magnets(in);
  return read_coil_and_magnet(in);
}

PairFile read_pair_file(const Document& document) {
  return read_object(document.root(), [](ObjectReader& in) {
    PairFile file{.bodies = read_bodies(in)};
    for (const Node& pose : in.elements("poses", Length::at_least(1))) file.poses.push_back(read_pose(pose));
    return file;
  });
}

}  // namespace

PairFile read_pair(const std::filesystem::path& path) {
  return read_pair_file(read_json(path));
}

PairFile parse_pair(std::string_view text, std::string file) {
  return read_pair_file(parse_json(text, std::move(file)));
}

}  // namespace coilwright::formats
