#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/model/commands.hpp"
#include "cli/model/placed_bodies.hpp"
#include "cli/options.hpp"
#include "coilwright/formats/actuator/pair_file.hpp"
#include "coilwright/magnetics/forces.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using formats::PairFile;
using magnetics::Forces;
using magnetics::Pose;
using magnetics::Wrench;
using text::Json;
using units::from_si;

struct ForceOptions {
  std::string pair;
  bool matrix{false};
  bool json{false};
};

std::array<double, 3> components_in(const Eigen::Vector3d& vector, std::string_view name) {
  return {from_si(vector.x(), name), from_si(vector.y(), name), from_si(vector.z(), name)};
}

/// What acts in each pose of the last body.
std::vector<Forces> forces_of(const PairFile& file, const std::string& name) {
  std::vector<Forces> all;
  all.reserve(file.poses.size());
  for (const Pose& pose : file.poses)
    all.push_back(formats::forces_on(file, file.bodies_at(pose), all.size() + 1, name));
  return all;
}

Json pose_json(const Pose& pose) {
  return Json::object({{"position_mm", Json::numbers(components_in(pose.position, "position_mm"))},
                       {"axis", Json::numbers(components_in(pose.axis, "axis"))}});
}

void append(Json& object, const Wrench& wrench) {
  object.set("force_N", Json::numbers(components_in(wrench.force, "force_N")))
      .set("torque_Nmm", Json::numbers(components_in(wrench.torque, "torque_Nmm")));
}

Eigen::Vector3d pull_on_plate(const Forces& forces) {
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  for (const Wrench& each : forces.by_plate) pull -= each.force;
  return pull;
}

Json plate_json(const PairFile& file, const Pose& pose, const Forces& forces) {
  const magnetics::PlateLoad load = magnetics::plate_load(file.bodies_at(pose), *file.plate);
  return Json::object({{"force_N", Json::numbers(components_in(pull_on_plate(forces), "force_N"))},
                       {"flux_density_T", load.flux_density},
                       {"least_thickness_mm", from_si(load.least_thickness, "thickness_mm")},
                       {"reach_mm", from_si(load.reach, "reach_mm")}});
}

// One object for each body: its pose, what acts on it in all and, if asked, what each of the others adds.
Json bodies_json(const PairFile& file, const Pose& pose, const Forces& forces, bool matrix) {
  const std::vector<magnetics::Body> bodies = file.bodies_at(pose);
  Json out = Json::array();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Json body = Json::object({{"name", file.names[i]}});
    body.set("position_mm", Json::numbers(components_in(bodies[i].pose.position, "position_mm")))
        .set("axis", Json::numbers(components_in(bodies[i].pose.axis, "axis")));
    append(body, forces.on[i]);
    if (matrix) {
      Json from = Json::array();
      for (std::size_t j = 0; j < bodies.size(); ++j) {
        if (j == i) continue;
        Json part = Json::object({{"name", file.names[j]}});
        append(part, forces.by[i][j]);
        from.add(std::move(part));
      }
      if (file.plate) {
        Json part = Json::object({{"name", "plate"}});
        append(part, forces.by_plate[i]);
        from.add(std::move(part));
      }
      body.set("from", std::move(from));
    }
    out.add(std::move(body));
  }
  return out;
}

Json as_json(const PairFile& file, const std::vector<Forces>& all, bool matrix) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < all.size(); ++i) {
    Json row = pose_json(file.poses[i]);
    if (file.listed || matrix)
      row.set("bodies", bodies_json(file, file.poses[i], all[i], matrix));
    else
      append(row, all[i].on.back());
    if (file.plate) row.set("plate", plate_json(file, file.poses[i], all[i]));
    rows.add(std::move(row));
  }
  return Json::object({{"poses", std::move(rows)}});
}

// Ten digits: one more than the torque and the force of a tilted body are good for.
std::string numbers_text(const Wrench& wrench) {
  std::string text;
  for (const double force : components_in(wrench.force, "force_N")) text += fmt::format(" {:>17.9e}", force);
  for (const double torque : components_in(wrench.torque, "torque_Nmm")) text += fmt::format(" {:>17.9e}", torque);
  return text + '\n';
}

std::string heading_text() {
  std::string text;
  for (const auto* name : {"force_x_N", "force_y_N", "force_z_N", "torque_x_Nmm", "torque_y_Nmm", "torque_z_Nmm"})
    text += fmt::format(" {:>17}", name);
  return text + '\n';
}

std::string position_text(const Pose& pose) {
  const auto position = components_in(pose.position, "position_mm");
  return fmt::format("{:.6g} {:.6g} {:.6g}", position[0], position[1], position[2]);
}

// A row for each pose of the second body.
std::string pair_table(const PairFile& file, const std::vector<Forces>& all) {
  std::string text = fmt::format("{:>5} {:>28}", "pose", "position (mm)") + heading_text();
  for (std::size_t i = 0; i < all.size(); ++i)
    text += fmt::format("{:>5} {:>28}", i + 1, position_text(file.poses[i])) + numbers_text(all[i].on.back());
  return text;
}

// A row for each body in each pose, and below it one for each of those that act on it.
std::string list_table(const PairFile& file, const std::vector<Forces>& all, bool matrix) {
  std::size_t width = 5;
  for (const std::string& name : file.names) width = std::max(width, name.size() + 5);
  std::string text = fmt::format("{:>5} {:<{}} {:>28}", "pose", "on", width, "position (mm)") + heading_text();
  for (std::size_t p = 0; p < all.size(); ++p) {
    const std::vector<magnetics::Body> bodies = file.bodies_at(file.poses[p]);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      text += fmt::format("{:>5} {:<{}} {:>28}", p + 1, file.names[i], width, position_text(bodies[i].pose)) +
              numbers_text(all[p].on[i]);
      const auto part = [&](const std::string& name, const Wrench& wrench) {
        text += fmt::format("{:>5} {:<{}} {:>28}", "", "by " + name, width, "") + numbers_text(wrench);
      };
      for (std::size_t j = 0; matrix && j < bodies.size(); ++j)
        if (j != i) part(file.names[j], all[p].by[i][j]);
      if (matrix && file.plate) part("plate", all[p].by_plate[i]);
    }
  }
  return text;
}

std::string plate_text(const PairFile& file, const std::vector<Forces>& all) {
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Eigen::Vector3d pull = pull_on_plate(all[i]);
    const magnetics::PlateLoad load = magnetics::plate_load(file.bodies_at(file.poses[i]), *file.plate);
    text += fmt::format(
        "{}plate pulled with {:.6g} N; it carries up to {:.3g} T and must be {:.3g} mm thick for 2 T; "
        "99 % of the pull within {:.3g} mm\n",
        all.size() > 1 ? fmt::format("pose {}: ", i + 1) : "", pull.dot(file.plate->normal.normalized()),
        load.flux_density, from_si(load.least_thickness, "thickness_mm"), from_si(load.reach, "reach_mm"));
  }
  return text;
}

std::string as_table(const PairFile& file, const std::vector<Forces>& all, bool matrix) {
  return (file.listed || matrix ? list_table(file, all, matrix) : pair_table(file, all)) +
         (file.plate ? plate_text(file, all) : "");
}

void run_force(const ForceOptions& options) {
  const PairFile file = formats::read_pair(options.pair);
  require_apart(file, options.pair);
  const std::vector<Forces> all = forces_of(file, options.pair);
  report::PairRemarks remarks(file);
  for (std::size_t p = 0; p < all.size(); ++p) {
    remarks.add(file.bodies_at(file.poses[p]), p + 1);
    remarks.add(all[p]);
  }
  tell(remarks, options.pair);
  std::cout << (options.json ? as_json(file, all, options.matrix).text() : as_table(file, all, options.matrix));
}

}  // namespace

void add_force_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<ForceOptions>();
  CLI::App* command = add_command(app, "force");
  command
      ->add_option("PAIR.json", options->pair, "File with two bodies and poses of the second one, or a list of bodies")
      ->required();
  add_flag(*command, "--matrix", options->matrix, "Also print which body acts on which");
  add_json_option(*command, options->json);
  command->footer(
      "Of a pair, the first body (the coil) is at the origin with its axis along +z. Force and torque act on the "
      "second\n"
      "body (the magnet). Of a list they act on each body, from all others. A torque is about the centre of the body "
      "that\n"
      "it acts on. Both are given in the axes of the file (of a pair: of the first body), in N and Nmm; positive "
      "turns\n"
      "from x to y about z.\n\n"
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
      "flows (default uniform). A list of three, and a steel plate beside them:\n"
      "  {\"bodies\": [{\"magnet\": {\"size_mm\": [10, 10, 5], \"remanence_T\": 1.3}, \"position_mm\": [0, 0, 4]},\n"
      "              {\"magnet\": {\"inner_radius_mm\": 2, \"outer_radius_mm\": 6, \"length_mm\": 8, \"remanence_T\": "
      "1.3,\n"
      "                          \"magnetised_along\": [1, 0, 0]}, \"position_mm\": [0, 0, 15]},\n"
      "              {\"coil\": {\"inner_radius_mm\": 5, \"outer_radius_mm\": 9, \"length_mm\": 10, \"turns_radial\": "
      "8,\n"
      "                        \"turns_axial\": 20}, \"current_A\": 1.4, \"position_mm\": [0, 0, 30]}],\n"
      "   \"plate\": {\"thickness_mm\": 3}}");
  command->callback([options] { run_force(*options); });
}

}  // namespace coilwright::cli
