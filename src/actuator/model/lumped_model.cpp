#include "coilwright/actuator/model/lumped_model.hpp"

#include <algorithm>
#include <boost/math/interpolators/barycentric_rational.hpp>
#include <functional>
#include <stdexcept>
#include <utility>

#include "coilwright/actuator/parts/hinge_pair_parts.hpp"
#include "coilwright/magnetics/curve.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::actuator {
namespace {

using magnetics::Curve;

// A curve over the whole working range of a joint, exact to a millionth of its largest torque.
constexpr double swing_back = -30.0 * units::degree;  // nothing stops the joints of a lumped model without a contact
constexpr Curve::Spec pair_range{.lower = -2.0 * units::degree, .upper = 120.0 * units::degree, .tolerance = 1e-6};

HingePair pair_of(const PairDimensions& dimensions) {
  const auto parts = std::make_shared<const HingePairParts>(
      HingePairParts::Spec{.coil = magnetics::ThickCoil(dimensions.coil),
                           .magnet = magnetics::CylinderMagnet(dimensions.magnet),
                           .geometry = dimensions.geometry,
                           .fidelity = dimensions.fidelity,
                           .range = pair_range,
                           .line_of_centres_lower = swing_back});
  return {.torque_per_ampere = parts->torque(), .parts = parts};
}

HingePair pair_of(const TorqueTable& table) {
  const auto& [angles, torques] = table;
  constexpr std::size_t degree_of_blending = 3;
  if (angles.size() <= degree_of_blending || torques.size() != angles.size())
    throw std::invalid_argument("torque table: must have at least 4 angles and a torque for each");
  if (std::ranges::adjacent_find(angles, std::greater_equal<>()) != angles.end())
    throw std::invalid_argument("torque table: angles must increase from one to the next");
  const boost::math::barycentric_rational<double> interpolant(angles.data(), torques.data(), angles.size(),
                                                              degree_of_blending);
  const auto values = [&interpolant](std::span<const double> at, std::span<double> out) {
    std::ranges::transform(at, out.begin(), [&interpolant](double angle) { return interpolant(angle); });
  };
  return {.torque_per_ampere = std::make_shared<const Curve>(
              values, Curve::Spec{.lower = angles.front(), .upper = angles.back(), .tolerance = 1e-4})};
}

}  // namespace

HingePair hinge_pair_of(const LumpedPair& pair, int coil) {
  HingePair out = std::visit([](const auto& source) { return pair_of(source); }, pair.source);
  out.joint = pair.joint;
  out.coil = coil;
  return out;
}

std::vector<HingePair> hinge_pairs_of(std::span<const LumpedPair> pairs) {
  std::vector<HingePair> out;
  for (const LumpedPair& pair : pairs) out.push_back(hinge_pair_of(pair, static_cast<int>(out.size())));
  return out;
}

std::shared_ptr<const CoilRow> coil_row_of(const LumpedModel& model) {
  if (model.links.size() != 2 || model.pairs.size() != 2) return nullptr;
  const auto* base = std::get_if<PairDimensions>(&model.pairs[0].source);
  const auto* last = std::get_if<PairDimensions>(&model.pairs[1].source);
  if (base == nullptr || last == nullptr) return nullptr;
  const bool exact = base->fidelity == magnetics::Fidelity::exact && last->fidelity == magnetics::Fidelity::exact;
  return std::make_shared<const CoilRow>(
      mechanics::PlanarChain(model.links, model.gravity),
      std::vector<PlacedCoil>{
          {.coil = magnetics::ThickCoil(base->coil),
           .centre = {.link = -1, .along = -base->geometry.coil_offset, .offset = base->geometry.axis_offset}},
          {.coil = magnetics::ThickCoil(last->coil),
           .centre = {.link = 1, .along = last->geometry.coil_offset, .offset = last->geometry.axis_offset}}},
      exact ? DistantPair::Orientation::dipoles : DistantPair::Orientation::ignored);
}

LumpedMagnetics magnetics_of(const LumpedModel& model) {
  return {.hinge_pairs = hinge_pairs_of(model.pairs), .coil_row = coil_row_of(model)};
}

ModelSpec spec_of(const LumpedModel& model, const LumpedMagnetics& magnetics) {
  return as_built({.chain = mechanics::PlanarChain(model.links, model.gravity),
                   .hinges = model.hinges,
                   .magnetics = MagneticStage(magnetics.hinge_pairs, {}),
                   .coils = static_cast<int>(magnetics.hinge_pairs.size()),
                   .tip = {.link = static_cast<int>(model.links.size()) - 1, .along = model.links.back().length},
                   .effects = model.effects,
                   .coil_row = magnetics.coil_row},
                  model.as_built);
}

}  // namespace coilwright::actuator
