#include "coilwright/actuator/coil_bank.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "coilwright/winding/copper.hpp"
#include "coilwright/winding/inductance.hpp"

namespace coilwright::actuator {
namespace {

double half_pitch(const Component& part, const Dimensions& size) {
  return part.kind == ComponentKind::coil ? size.coil_half_pitch : size.magnet_half_pitch;
}

}  // namespace

std::vector<int> coil_places(const Layout& layout) {
  std::vector<int> places;
  for (int i = 0; i < static_cast<int>(layout.size()); ++i)
    if (layout[i].kind == ComponentKind::coil) places.push_back(i);
  return places;
}

drive::CoilBank coil_bank(const Design& design, const Assembly& assembly, drive::BankWiring wiring,
                          const Eigen::VectorXd& temperatures) {
  const std::vector<int> places = coil_places(design.layout);
  const auto coils = static_cast<Eigen::Index>(places.size());
  if (temperatures.size() != coils)
    throw std::invalid_argument(
        fmt::format("temperatures: one a coil is needed, {} here; got {}", coils, temperatures.size()));
  const winding::Winding wound = winding_of(design);
  const winding::CoilSection section{.inner_radius = wound.inner_radius(),
                                     .outer_radius = wound.outer_radius(),
                                     .length = wound.length(),
                                     .turns = wound.turns()};
  const auto centre_of = [&](int place) {
    double along = half_pitch(design.layout[place], assembly.dimensions);
    for (int i = 0; i < place; ++i) along += 2.0 * half_pitch(design.layout[i], assembly.dimensions);
    return along;
  };
  drive::CoilBank bank{.resistances = Eigen::VectorXd(coils),
                       .inductances = assembly.coil.inductance * Eigen::MatrixXd::Identity(coils, coils),
                       .wiring = wiring};
  for (Eigen::Index i = 0; i < coils; ++i) {
    bank.resistances[i] = assembly.coil.resistance * winding::copper_resistance_ratio(temperatures[i]);
    for (Eigen::Index j = 0; j < i; ++j) {
      const int sense = design.layout[places[i]].polarity * design.layout[places[j]].polarity;
      const double mutual =
          sense * winding::mutual_inductance(section, section, centre_of(places[i]) - centre_of(places[j]));
      bank.inductances(i, j) = bank.inductances(j, i) = mutual;
    }
  }
  return bank;
}

}  // namespace coilwright::actuator
