#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/formats/actuator/pair_file.hpp"
#include "coilwright/magnetics/overlap.hpp"
#include "coilwright/magnetics/wrench.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/units/unit.hpp"
#include "commands.hpp"

namespace coilwright::cli {
namespace {

using magnetics::Pose;
using magnetics::Wrench;
using text::Json;
using units::from_si;

struct Options {
  std::string pair;
  bool json{false};
};

Wrench wrench_on_second(const formats::CoilAndMagnet& pair, const Pose& pose) {
  return magnetics::wrench(pair.coil, pair.current, pair.magnet, pose);
}

Wrench wrench_on_second(const formats::TwoCoils& pair, const Pose& pose) {
  return magnetics::wrench(pair.first, pair.first_current, pair.second, pair.second_current, pose);
}

Wrench wrench_on_second(const formats::TwoMagnets& pair, const Pose& pose) {
  return magnetics::wrench(pair.first, pair.second, pose);
}

std::array<double, 3> in_unit(const Eigen::Vector3d& vector, std::string_view name) {
  return {from_si(vector.x(), name), from_si(vector.y(), name), from_si(vector.z(), name)};
}

bool bodies_overlap(const formats::CoilAndMagnet& pair, const Pose& pose) {
  return magnetics::overlap(magnetics::outline_of(pair.coil), magnetics::outline_of(pair.magnet), pose);
}

bool bodies_overlap(const formats::TwoCoils& pair, const Pose& pose) {
  return magnetics::overlap(magnetics::outline_of(pair.first), magnetics::outline_of(pair.second), pose);
}

bool bodies_overlap(const formats::TwoMagnets& pair, const Pose& pose) {
  return magnetics::overlap(magnetics::outline_of(pair.first), magnetics::outline_of(pair.second), pose);
}

// Says so of poses that no two parts can have.
void warn_of_overlaps(const formats::PairFile& file, const std::string& name) {
  std::vector<std::size_t> poses;
  for (std::size_t i = 0; i < file.poses.size(); ++i)
    if (std::visit([&](const auto& pair) { return bodies_overlap(pair, file.poses[i]); }, file.bodies))
      poses.push_back(i + 1);
  if (poses.empty()) return;
  constexpr std::size_t most = 5;
  const std::size_t shown = std::min(most, poses.size());
  std::cerr << fmt::format(
      "MIND: {}: in {} {}{} the bodies are in the same place, as no two parts can be: what is computed is that of both "
      "currents there, to about 0.5 %.\n",
      name, poses.size() == 1 ? "pose" : "poses",
      fmt::join(poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
      poses.size() > shown ? ", .." : "");
}

Json as_json(const std::vector<Pose>& poses, const std::vector<Wrench>& wrenches) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    rows.add(Json::object({{"position_mm", Json::numbers(in_unit(poses[i].position, "position_mm"))},
                           {"axis", Json::numbers(in_unit(poses[i].axis, "axis"))},
                           {"force_N", Json::numbers(in_unit(wrenches[i].force, "force_N"))},
                           {"torque_Nmm", Json::numbers(in_unit(wrenches[i].torque, "torque_Nmm"))}}));
  }
  return Json::object({{"poses", std::move(rows)}});
}

// Ten digits: one more than the torque and the force of a tilted body are good for.
std::string as_table(const std::vector<Pose>& poses, const std::vector<Wrench>& wrenches) {
  std::string text = fmt::format("{:>5} {:>28}", "pose", "position (mm)");
  for (const auto* name : {"force_x_N", "force_y_N", "force_z_N", "torque_x_Nmm", "torque_y_Nmm", "torque_z_Nmm"}) {
    text += fmt::format(" {:>17}", name);
  }
  text += '\n';
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto position = in_unit(poses[i].position, "position_mm");
    text +=
        fmt::format("{:>5} {:>28}", i + 1, fmt::format("{:.6g} {:.6g} {:.6g}", position[0], position[1], position[2]));
    for (const double force : in_unit(wrenches[i].force, "force_N")) text += fmt::format(" {:>17.9e}", force);
    for (const double torque : in_unit(wrenches[i].torque, "torque_Nmm")) text += fmt::format(" {:>17.9e}", torque);
    text += '\n';
  }
  return text;
}

std::vector<Wrench> wrenches_of(const formats::PairFile& file) {
  std::vector<Wrench> wrenches;
  wrenches.reserve(file.poses.size());
  for (const Pose& pose : file.poses) {
    wrenches.push_back(std::visit([&](const auto& pair) { return wrench_on_second(pair, pose); }, file.bodies));
    const Wrench& last = wrenches.back();
    if (!last.force.allFinite() || !last.torque.allFinite()) {
      throw std::domain_error(fmt::format("pose {}: the force is beyond what can be computed", wrenches.size()));
    }
  }
  return wrenches;
}

void run_force(const Options& options) {
  const formats::PairFile file = formats::read_pair(options.pair);
  const std::vector<Wrench> wrenches = wrenches_of(file);
  warn_of_overlaps(file, options.pair);
  std::cout << (options.json ? as_json(file.poses, wrenches).text() : as_table(file.poses, wrenches));
}

}  // namespace

void add_force_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("force", "Compute force and torque between a coil and a magnet, two coils or two magnets");
  command->add_option("PAIR.json", options->pair, "File with the two bodies and the poses of the second one")
      ->required();
  command->add_flag("--json", options->json, "Print JSON instead of a table")->disable_flag_override();
  command->footer(
      "The first body (the coil) is at the origin with its axis along +z. Force and torque act on the second body\n"
      "(the magnet); the torque is about its centre. Both are given in the axes of the first body, in N and Nmm.\n\n"
      "Example:\n"
      "  coilwright force pair.json --json\n\n"
      "pair.json:\n"
      "  {\"coil\": {\"inner_radius_mm\": 5, \"outer_radius_mm\": 9, \"length_mm\": 10,\n"
      "            \"turns_radial\": 8, \"turns_axial\": 20},\n"
      "   \"magnet\": {\"radius_mm\": 4, \"length_mm\": 6, \"remanence_T\": 1.3},\n"
      "   \"current_A\": 1.4,\n"
      "   \"poses\": [{\"position_mm\": [0.5, 0, 12], \"axis\": [0, 0.1, 1]}]}\n\n"
      "Instead of \"coil\" and \"magnet\", a file may have \"coils\": [.., ..] with \"currents_A\": [.., ..], or\n"
      "\"magnets\": [.., ..]. \"winding\" (paper_shells, layer_centres, uniform) says where in the coil the current\n"
      "flows (default uniform).");
  command->callback([options] { run_force(*options); });
}

}  // namespace coilwright::cli
