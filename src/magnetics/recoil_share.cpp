#include "magnetics/recoil_share.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coilwright/magnetics/axial_force.hpp"

namespace coilwright::magnetics {

RecoilShare::Piece::Piece(const ThickCoil& coil, const CylinderMagnet& magnet, double origin, double nearest,
                          double farthest)
    : origin_(origin), place_{}, share_{} {
  const double first = std::log(nearest - origin_);
  const double half = 0.5 * (std::log(farthest - origin_) - first);
  std::array<double, points> distance{};
  for (int i = 0; i < points; ++i) {
    place_[i] = first + half * (1.0 - std::cos(std::numbers::pi * i / (points - 1)));
    distance[i] = origin_ + std::exp(place_[i]);
  }
  std::array<double, points> rigid{};
  axial_force_per_ampere(coil, magnet.without_recoil(), distance, rigid);
  axial_force_per_ampere(coil, magnet, distance, share_);
  for (int i = 0; i < points; ++i) share_[i] /= rigid[i];
}

// Berrut and Trefethen, SIAM Rev. 46, 501, 2004.
double RecoilShare::Piece::at(double distance) const {
  const double place = std::clamp(std::log(distance - origin_), place_.front(), place_.back());
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 0; i < points; ++i) {
    const double apart = place - place_[i];
    if (apart == 0.0) return share_[i];
    const bool end = i == 0 || i == points - 1;
    const double weight = (i % 2 == 0 ? 1.0 : -1.0) * (end ? 0.5 : 1.0) / apart;
    sum += weight * share_[i];
    weights += weight;
  }
  return sum / weights;
}

RecoilShare::RecoilShare(const ThickCoil& coil, const CylinderMagnet& magnet, double nearest, double farthest)
    : level_(0.5 * (coil.length() + magnet.length())) {
  const double radius = std::min(coil.outer_radius(), magnet.radius());
  if (farthest > level_) {
    const double from = std::max(nearest, level_);
    // The share varies most where the faces are near.
    apart_.emplace(coil, magnet, from - 0.3 * radius, from, farthest);
  }
  // Nothing to divide by where the centres meet.
  const double least = std::max(nearest, 1e-3 * level_);
  if (least < level_) passed_.emplace(coil, magnet, -level_, least, std::min(farthest, level_));
}

double RecoilShare::at(double distance) const {
  const bool passes = distance < level_;
  if (passes ? !passed_ : !apart_) return passes ? apart_->at(level_) : passed_->at(level_);
  return passes ? passed_->at(distance) : apart_->at(distance);
}

}  // namespace coilwright::magnetics
