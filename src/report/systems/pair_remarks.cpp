#include "coilwright/report/systems/pair_remarks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "coilwright/magnetics/overlap.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::report {
namespace {

using magnetics::Body;
using units::from_si;

constexpr std::size_t most_poses_told = 5;

bool some_in_one_place(const std::vector<Body>& bodies, std::size_t first) {
  for (std::size_t j = first; j < bodies.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (magnetics::overlap(bodies[i], bodies[j])) return true;
  return false;
}

}  // namespace

void PairRemarks::add(const std::vector<Body>& bodies, std::size_t pose) {
  const std::size_t first_that_moved = fixed_are_known_ ? bodies.size() - 1 : 0;
  fixed_are_known_ = true;
  if (some_in_one_place(bodies, first_that_moved) && ++overlapping_ <= most_poses_told)
    first_overlapping_.push_back(pose);
  if (file_.plate) add_plate(bodies);
}

void PairRemarks::add(const magnetics::Forces& forces) {
  constexpr double told_from = 1e-5;  // of the largest force
  double largest = 0.0;
  for (const magnetics::Wrench& each : forces.on) largest = std::max(largest, each.force.norm());
  if (forces.error <= told_from * largest || forces.error / largest <= worst_error_) return;
  worst_error_ = forces.error / largest;
  error_ = forces.error;
}

void PairRemarks::add_plate(const std::vector<Body>& bodies) {
  const magnetics::PlateLoad load = magnetics::plate_load(bodies, *file_.plate);
  if (load.flux_density > plate_.flux_density) plate_ = load;
  // From the plate's middle, which need not be below the bodies.
  const Eigen::Vector3d normal = file_.plate->normal.normalized();
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Body& body : bodies) middle += body.pose.position / static_cast<double>(bodies.size());
  const Eigen::Vector3d aside = middle - file_.plate->position;
  plate_reach_ = std::max(plate_reach_, load.reach + (aside - normal.dot(aside) * normal).norm());
}

std::string PairRemarks::overlaps_text() const {
  return fmt::format(
      "in {} {}{} the bodies are in the same place, as no two parts can be: what is computed is that of both currents "
      "there, to about 0.5 %.",
      overlapping_ == 1 ? "pose" : "poses", fmt::join(first_overlapping_, ", "),
      overlapping_ > most_poses_told ? ", .." : "");
}

std::vector<std::string> PairRemarks::sentences() const {
  std::vector<std::string> out;
  if (overlapping_ > 0) out.push_back(overlaps_text());
  if (worst_error_ > 0.0)
    out.push_back(fmt::format("edges of a body touch another one's face: a force is known to {:.2g} N.", error_));
  if (plate_.flux_density > magnetics::steel_saturation)
    out.push_back(fmt::format(
        "the plate of {:.4g} mm would have to carry {:.3g} T, and steel saturates at about {} T: it pulls less than "
        "this. A mirror from {:.3g} mm on.",
        from_si(file_.plate->thickness, "thickness_mm"), plate_.flux_density, magnetics::steel_saturation,
        from_si(plate_.least_thickness, "thickness_mm")));
  if (file_.plate_radius && plate_reach_ > *file_.plate_radius)
    out.push_back(
        fmt::format("the plate ends {:.4g} mm from its position, and 99 % of an endless plate's pull takes {:.3g} mm: "
                    "it pulls less "
                    "than this.",
                    from_si(*file_.plate_radius, "radius_mm"), from_si(plate_reach_, "radius_mm")));
  return out;
}

}  // namespace coilwright::report
