#include "coilwright/actuator/parts/coil_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "actuator/parts/axial_curves.hpp"
#include "coilwright/magnetics/pair_curve.hpp"

namespace coilwright::actuator {
namespace {

using magnetics::ThickCoil;

bool alike(const ThickCoil& a, const ThickCoil& b) {
  return a.inner_radius() == b.inner_radius() && a.outer_radius() == b.outer_radius() && a.length() == b.length() &&
         a.turns_radial() == b.turns_radial() && a.turns_axial() == b.turns_axial() && a.winding() == b.winding();
}

// Pairs of the same two coils share a curve over the distances of them all.
struct Family {
  const PlacedCoil* first;
  const PlacedCoil* second;
  double lower;
  double upper;
  std::vector<std::size_t> pairs;
};

Family& family_of(std::vector<Family>& families, const Family& candidate) {
  const auto known = std::ranges::find_if(families, [&](const Family& family) {
    return alike(family.first->coil, candidate.first->coil) && alike(family.second->coil, candidate.second->coil);
  });
  if (known == families.end()) return families.emplace_back(candidate);
  known->lower = std::min(known->lower, candidate.lower);
  known->upper = std::max(known->upper, candidate.upper);
  return *known;
}

}  // namespace

CoilRow::CoilRow(const mechanics::PlanarChain& chain, std::vector<PlacedCoil> coils,
                 DistantPair::Orientation orientation, double curve_tolerance)
    : coils_(std::move(coils)), orientation_(orientation), curve_tolerance_(curve_tolerance) {
  if (coils_.size() < 2) throw std::invalid_argument(fmt::format("coils: at least two; got {}", coils_.size()));
  const mechanics::JointVector straight = mechanics::JointVector::Zero(chain.joints());
  for (std::size_t i = 0; i < coils_.size(); ++i) {
    if (i > 0 && coils_[i].centre.link <= coils_[i - 1].centre.link)
      throw std::invalid_argument(
          fmt::format("coils: links must rise; got {} after {}", coils_[i].centre.link, coils_[i - 1].centre.link));
    straight_.push_back(chain.position(coils_[i].centre, straight));
  }
}

std::vector<DistantPair> CoilRow::build() const {
  std::vector<DistantPair> pairs;
  std::vector<Family> families;
  for (std::size_t i = 0; i < coils_.size(); ++i) {
    for (std::size_t k = i + 1; k < coils_.size(); ++k) {
      const PlacedCoil& first = coils_[i];
      const PlacedCoil& second = coils_[k];
      const double distance = (straight_[k] - straight_[i]).norm();
      const double radius = std::max(first.coil.outer_radius(), second.coil.outer_radius());
      const double touching = 0.5 * (first.coil.length() + second.coil.length());
      // Closing joints bring two coils at most a tenth nearer, and neighbours no nearer than they touch. Opening each
      // joint between them takes them apart by at most twice the joint's lever; ten radii on, the force is a dipole's
      // within 3 %.
      const int joints = second.centre.link - first.centre.link;
      const double lever = std::max(std::abs(first.centre.offset), std::abs(second.centre.offset));
      const Family candidate{.first = &first,
                             .second = &second,
                             .lower = std::min(std::max(0.9 * distance, touching), distance),
                             .upper = std::max(distance + 2.0 * joints * lever, 10.0 * radius),
                             .pairs = {}};
      family_of(families, candidate).pairs.push_back(pairs.size());
      pairs.push_back({.first = first.centre,
                       .second = second.centre,
                       .coil = static_cast<int>(i),
                       .second_coil = static_cast<int>(k),
                       .sense = first.polarity * second.polarity,
                       .orientation = orientation_,
                       .axial_force = nullptr,
                       .axial_energy = nullptr});
    }
  }
  for (const Family& family : families) {
    const AxialCurves curves = axial_curves(
        magnetics::force_curve(family.first->coil, family.second->coil,
                               {.lower = family.lower, .upper = family.upper, .tolerance = curve_tolerance_}),
        curve_tolerance_);
    for (const std::size_t pair : family.pairs) {
      pairs[pair].axial_force = curves.force;
      pairs[pair].axial_energy = curves.energy;
    }
  }
  return pairs;
}

std::vector<DistantPair> CoilRow::pairs() const {
  const std::lock_guard lock(mutex_);
  if (pairs_.empty()) pairs_ = build();
  return pairs_;
}

}  // namespace coilwright::actuator
