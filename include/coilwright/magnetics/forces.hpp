#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coilwright/magnetics/body.hpp"
#include "coilwright/magnetics/plate.hpp"
#include "coilwright/magnetics/wrench.hpp"

namespace coilwright::magnetics {

/// Force and torque on each of several bodies.
struct Forces {
  std::vector<Wrench> on;               ///< on each body from all others and the plate: the sum of its row
  std::vector<std::vector<Wrench>> by;  ///< element [i][j]: on body i from body j; zero for a body on itself
  std::vector<Wrench> by_plate;         ///< on each body from the plate; empty if there is none
  double error{};  ///< N, the largest error of a force by integration over faces; 0 without such forces
};

/// Force and torque on each body from all others, in the axes of their poses, each torque about the centre of its body.
/// Each pair is computed once and acts back with equal force and opposite moment.
///
/// Coils and round magnets magnetised along their axis act on each other as in wrench(), with its accuracy. Other
/// magnets act by the charge of their faces in the closed field of the other body; `error` states the accuracy. A plate
/// adds the images of all bodies, including a body's own. Recoil is the mean over a magnet (Magnet), and between a coil
/// and a full cylinder magnetised along its axis also varies from point to point.
///
/// Throws std::invalid_argument for a body that breaks a rule, and for bodies behind the plate's face. Precondition:
/// bodies do not overlap (overlap()); only coils and round magnets magnetised along their axis may.
[[nodiscard]] Forces forces(std::span<const Body> bodies, const std::optional<Plate>& plate = std::nullopt);

/// Whether wrench() can compute a body: a coil, or a round magnet magnetised along its axis.
[[nodiscard]] bool is_axial(const Body& body);

}  // namespace coilwright::magnetics
