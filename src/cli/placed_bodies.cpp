#include "placed_bodies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <vector>

#include "coilwright/magnetics/forces.hpp"
#include "coilwright/magnetics/overlap.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using magnetics::Body;
using units::from_si;

// Of the bodies only the last one moves from pose to pose.
std::size_t first_that_moved(const std::vector<Body>& bodies, std::size_t pose) {
  return pose == 0 ? 0 : bodies.size() - 1;
}

bool some_in_one_place(const std::vector<Body>& bodies, std::size_t first) {
  for (std::size_t j = first; j < bodies.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (magnetics::overlap(bodies[i], bodies[j])) return true;
  return false;
}

}  // namespace

void warn_of_overlaps(const formats::PairFile& file, const std::string& name) {
  std::vector<std::size_t> poses;
  for (std::size_t p = 0; p < file.poses.size(); ++p) {
    const std::vector<Body> bodies = file.bodies_at(file.poses[p]);
    if (some_in_one_place(bodies, first_that_moved(bodies, p))) poses.push_back(p + 1);
  }
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

void require_apart(const formats::PairFile& file, const std::string& name) {
  for (std::size_t p = 0; p < file.poses.size(); ++p) {
    const std::vector<Body> bodies = file.bodies_at(file.poses[p]);
    formats::require_apart(file, bodies, first_that_moved(bodies, p), p + 1, name);
  }
}

void warn_of_plate(const formats::PairFile& file, const std::string& name) {
  magnetics::PlateLoad worst{};
  double reach = 0.0;
  for (const magnetics::Pose& pose : file.poses) {
    const std::vector<Body> bodies = file.bodies_at(pose);
    const magnetics::PlateLoad load = magnetics::plate_load(bodies, *file.plate);
    if (load.flux_density > worst.flux_density) worst = load;
    // From the plate's middle, which need not be below the bodies.
    const Eigen::Vector3d normal = file.plate->normal.normalized();
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Body& body : bodies) middle += body.pose.position / static_cast<double>(bodies.size());
    const Eigen::Vector3d aside = middle - file.plate->position;
    reach = std::max(reach, load.reach + (aside - normal.dot(aside) * normal).norm());
  }
  if (worst.flux_density > magnetics::steel_saturation)
    std::cerr << fmt::format(
        "MIND: {}: the plate of {:.4g} mm would have to carry {:.3g} T, and steel saturates at about {} T: it pulls "
        "less "
        "than this. A mirror from {:.3g} mm on.\n",
        name, from_si(file.plate->thickness, "thickness_mm"), worst.flux_density, magnetics::steel_saturation,
        from_si(worst.least_thickness, "thickness_mm"));
  if (file.plate_radius && reach > *file.plate_radius)
    std::cerr << fmt::format(
        "MIND: {}: the plate ends {:.4g} mm from its position, and 99 % of an endless plate's pull takes {:.3g} mm: it "
        "pulls less than this.\n",
        name, from_si(*file.plate_radius, "radius_mm"), from_si(reach, "radius_mm"));
}

}  // namespace coilwright::cli
