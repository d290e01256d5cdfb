#include "coilwright/actuator/demagnetisation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "actuator/pair_curves.hpp"
#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/magnetics/constants.hpp"
#include "coilwright/magnetics/irreversible_loss.hpp"

namespace coilwright::actuator {
namespace {

using magnetics::AxialField;
using magnetics::FaceValues;

// Centres of the components along the straight actuator, m.
std::vector<double> centres(const Design& design, const Assembly& assembly) {
  const Dimensions& size = assembly.dimensions;
  std::vector<double> out;
  double start = 0.0;
  for (std::size_t i = 0; i < design.layout.size(); ++i) {
    const double half = design.layout[i].kind == ComponentKind::magnet ? size.magnet_half_pitch : size.coil_half_pitch;
    out.push_back(i == 0 ? -half : start + half);
    if (i > 0) start += assembly.segments[i].length;
  }
  return out;
}

void add(AxialField& sum, const AxialField& field, double factor) {
  sum.mean += factor * field.mean;
  for (std::size_t p = 0; p < magnetics::face_points; ++p) sum.faces[p] += factor * field.faces[p];
}

// Seen from the other side: the faces change places.
AxialField mirrored(AxialField field) {
  // Not std::ranges::rotate: Clang 14 does not take it from this standard library.
  std::rotate(field.faces.begin(), field.faces.begin() + magnetics::face_points / 2, field.faces.end());
  return field;
}

// Fields at the few distances that a design has, each computed once.
template <class Compute>
class ByDistance {
 public:
  explicit ByDistance(Compute compute) : compute_(std::move(compute)) {}

  AxialField at(double distance) {
    const double apart = std::abs(distance);
    auto known = std::ranges::find_if(known_, [&](const Known& each) { return std::abs(each.apart - apart) < 1e-9; });
    if (known == known_.end()) known = known_.insert(known_.end(), {apart, compute_(apart)});
    return distance < 0.0 ? mirrored(known->field) : known->field;
  }

 private:
  struct Known {
    double apart;
    AxialField field;
  };
  Compute compute_;
  std::vector<Known> known_;
};

}  // namespace

InnerFields::InnerFields(const Design& design, const Assembly& assembly)
    : material_(design.magnet), size_{}, factor_{}, face_factors_{}, components_(design.layout.size()) {
  if (!design.magnet.has_coercivity())
    throw std::invalid_argument("magnets without a grade, or a coercivity and its coefficient, have no coercivity");
  size_ = {.radius = design.magnet.radius, .length = design.magnet.length};
  factor_ = magnetics::demagnetisation_factor(size_);
  face_factors_ = magnetics::face_demagnetisation_factors(size_);
  PairCurves parts(design, assembly.dimensions);
  const magnetics::ThickCoil coil = parts.coil();
  const magnetics::CylinderMagnet magnet = parts.magnet();
  ByDistance of_coil([&](double distance) { return magnetics::axial_field(coil, 1.0, size_, distance); });
  ByDistance of_magnet([&](double distance) { return magnetics::axial_field(magnet, size_, distance); });
  const std::vector<double> places = centres(design, assembly);
  const std::vector<double> shares = current_shares(design);
  for (std::size_t i = 0; i < components_; ++i) {
    const Component& own = design.layout[i];
    if (own.kind != ComponentKind::magnet) continue;
    Inside inside{.component = i, .coils = {}, .neighbours = {}};
    std::size_t coil_number = 0;
    for (std::size_t k = 0; k < components_; ++k) {
      if (k == i) continue;
      const Component& other = design.layout[k];
      const double sense = own.polarity * other.polarity;
      const double distance = places[i] - places[k];
      // Positive current sets a coil's moment against a magnet's.
      if (other.kind == ComponentKind::coil) {
        add(inside.coils, of_coil.at(distance), -sense * shares[coil_number++]);
      } else {
        AxialField field{};
        add(field, of_magnet.at(distance), sense);
        inside.neighbours.push_back({.component = k, .field = field});
      }
    }
    magnets_.push_back(std::move(inside));
  }
}

Demagnetisation InnerFields::demagnetisation(std::span<const double> temperatures, double current) const {
  if (temperatures.size() != components_)
    throw std::invalid_argument(
        fmt::format("temperatures: one per component, {} here; got {}", components_, temperatures.size()));
  const double susceptibility = material_.recoil_permeability - 1.0;
  Demagnetisation worst{.margin = 1.0, .margin_worst_point = 1.0, .irreversible_loss = 0.0};
  for (const Inside& magnet : magnets_) {
    const double temperature = temperatures[magnet.component];
    AxialField outside{};
    for (const Neighbour& other : magnet.neighbours)
      add(outside, other.field, magnetics::share_at(temperatures[other.component], material_.remanence_coefficient));
    const double coils = -std::abs(current * magnet.coils.mean);
    // M = Br / mu0 + chi H on the recoil line, with H = -N M + what comes from outside.
    const double mean_outside = outside.mean + coils;
    const double unloaded = material_.remanence * magnetics::share_at(temperature, material_.remanence_coefficient) /
                            magnetics::vacuum_permeability;
    const double magnetisation = (unloaded + susceptibility * mean_outside) / (1.0 + susceptibility * factor_);
    const double coercivity = material_.coercivity * magnetics::share_at(temperature, material_.coercivity_coefficient);
    const auto margin = [&](double field) {
      if (field >= 0.0) return 1.0;
      return -field <= coercivity ? 1.0 + field / coercivity : -coercivity / field - 1.0;
    };
    worst.margin = std::min(worst.margin, margin(mean_outside - factor_ * magnetisation));
    double worst_point = 1.0;
    for (std::size_t p = 0; p < magnetics::face_points; ++p) {
      outside.faces[p] -= std::abs(current * magnet.coils.faces[p]);
      worst_point = std::min(worst_point, margin(outside.faces[p] - face_factors_[p] * magnetisation));
    }
    worst.margin_worst_point = std::min(worst.margin_worst_point, worst_point);
    // Where its worst point is above the knee, so is all of it.
    const magnetics::DemagnetisationCurve curve{.magnetisation = unloaded,
                                                .coercivity = coercivity,
                                                .susceptibility = susceptibility,
                                                .squareness = material_.squareness};
    if (worst_point < curve.knee_margin())
      worst.irreversible_loss =
          std::max(worst.irreversible_loss, magnetics::irreversible_loss(size_, curve, outside.faces));
  }
  worst.margin_worst_point = std::min(worst.margin_worst_point, worst.margin);
  return worst;
}

std::vector<double> magnet_strengths(const Design& design, std::span<const double> temperatures) {
  if (temperatures.size() != design.layout.size())
    throw std::invalid_argument(
        fmt::format("temperatures: one per component, {} here; got {}", design.layout.size(), temperatures.size()));
  std::vector<double> out;
  for (std::size_t i = 0; i < design.layout.size(); ++i) {
    if (design.layout[i].kind != ComponentKind::magnet) continue;
    out.push_back(magnetics::share_at(temperatures[i], design.magnet.remanence_coefficient));
  }
  return out;
}

}  // namespace coilwright::actuator
