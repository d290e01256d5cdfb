#include "placed_bodies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iostream>
#include <vector>

#include "coilwright/magnetics/forces.hpp"
#include "coilwright/magnetics/overlap.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::cli {
namespace {

using magnetics::Body;
using units::from_si;

bool in_one_place(const Body& first, const Body& second) {
  return magnetics::overlap(magnetics::shape_of(first), magnetics::shape_of(second),
                            magnetics::seen_from(first.pose, second.pose));
}

// Calls `found` with the number of the pose and of both bodies. Of the bodies only the last one moves.
void each_overlap(const formats::PairFile& file,
                  const std::function<void(std::size_t, std::size_t, std::size_t)>& found) {
  const std::size_t last = file.bodies.size() - 1;
  for (std::size_t p = 0; p < file.poses.size(); ++p) {
    const std::vector<Body> bodies = file.bodies_at(file.poses[p]);
    for (std::size_t i = 0; i < last; ++i) {
      if (in_one_place(bodies[i], bodies[last])) found(p, i, last);
      for (std::size_t j = i + 1; p == 0 && j < last; ++j)
        if (in_one_place(bodies[i], bodies[j])) found(p, i, j);
    }
  }
}

}  // namespace

void warn_of_overlaps(const formats::PairFile& file, const std::string& name) {
  std::vector<std::size_t> poses;
  each_overlap(file, [&](std::size_t pose, std::size_t, std::size_t) {
    if (poses.empty() || poses.back() != pose + 1) poses.push_back(pose + 1);
  });
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
  each_overlap(file, [&](std::size_t pose, std::size_t i, std::size_t j) {
    if (magnetics::is_axial(file.bodies[i]) && magnetics::is_axial(file.bodies[j])) return;
    throw text::InputError({.file = name,
                            .place = {},
                            .rule = fmt::format("must have {} and {} apart: in pose {} they are in the same place, "
                                                "where the force on a magnet's faces means nothing",
                                                file.names[i], file.names[j], pose + 1)});
  });
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
